#pragma once

#include "Blocks.h"

#include <lodsmith/core/MeshView.h>
#include <lodsmith/ogre/MeshReader.h>

#include <OgreMesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace lodsmith {

constexpr std::size_t kMostPoses = 4; ///< of a skeleton, and as many of poses and morph frames

/// What each of the offsets is, for each vertex buffer of a view.
using OffsetMoments = std::vector<std::vector<PoseMoment>>;

/// Gives a view's vertex buffers the positions that the mesh's animations take them to at a few moments: those of its skeleton
/// (skinned as OGRE does it in software) if that is loaded, and its poses and morph frames, up to four each. None are chosen
/// that bend and stretch nothing. Adds a note for what stands in the way.
///
/// @param moments those to show; null to have them chosen
/// @return the moments shown; none if one of those given cannot be
std::vector<PoseMoment> readPoses(const Ogre::Mesh& mesh, const OffsetMoments& offsets,
                                  const std::vector<PoseMoment>* moments, MeshView& view, Blocks& blocks,
                                  std::vector<std::string>& notes);

} // namespace lodsmith
