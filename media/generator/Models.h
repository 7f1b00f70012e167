#pragma once

#include <filesystem>

namespace lodsmith::media {

// Each writes one model with its materials and pictures into `directory`, which exists. Throws std::runtime_error or
// Ogre::Exception. Deterministic. Needs OGRE without a window and its PNG codec; main thread.

/// A broad-leaved tree: trunk and branches as one submesh, alpha-tested leaf cards as another, own vertex buffers.
void makeTree(const std::filesystem::path& directory);

/// A timber-framed cottage without a floor: thick walls with openings, and two-sided sheets where it is thin.
void makeCottage(const std::filesystem::path& directory);

/// A lantern: turned metal with hard edges and texture seams, panes, a handle.
void makeLantern(const std::filesystem::path& directory);

/// A four-legged lizard with a skeleton, an idle and a walk animation, and one shared vertex buffer.
void makeDrake(const std::filesystem::path& directory);

} // namespace lodsmith::media
