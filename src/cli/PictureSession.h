#pragma once

#include <lodsmith/core/Result.h>
#include <lodsmith/render/LevelRenderer.h>
#include <lodsmith/render/RenderEngine.h>

#include <filesystem>
#include <memory>

namespace lodsmith::cli {

/// OGRE with a hidden window, and a mesh whose levels can be pictured, for as long as the object lives. One at a time,
/// in a child process, and not beside an OgreSession.
class PictureSession {
public:
    /// Loads a mesh. One without levels gets the automatic ones, in memory.
    /// Errors: Unsupported without an X display, NotFound (also for `materials`), those of openMeshFile(), loadMesh(),
    /// LevelRenderer and of generating.
    /// @param materials directory of its materials, and of their textures where they are not beside the mesh; empty for
    /// the mesh's
    static Result<std::unique_ptr<PictureSession>> open(const std::filesystem::path& mesh,
                                                        const std::filesystem::path& materials);

    LevelRenderer& renderer() { return *mRenderer; }
    /// Whether the file has no levels, so that these are the automatic ones.
    bool hasAutomaticLevels() const { return mHasAutomaticLevels; }

private:
    PictureSession() : mEngine("") {}
    Result<Done> start(const std::filesystem::path& mesh, const std::filesystem::path& materials);

    RenderEngine mEngine;
    std::unique_ptr<LevelRenderer> mRenderer;
    bool mHasAutomaticLevels = false;
};

} // namespace lodsmith::cli
