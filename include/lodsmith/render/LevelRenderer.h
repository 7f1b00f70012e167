#pragma once

#include <lodsmith/analysis/Image.h>
#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/render/SurfaceMaterials.h>
#include <lodsmith/render/Viewpoint.h>

#include <OgreMesh.h>

#include <cstddef>
#include <memory>

namespace lodsmith {

/// Takes pictures of the levels of a mesh, at rest. Each has one light, over the camera's shoulder, and nothing behind
/// the mesh. A pixel is the mean of 2 x 2 samples, and its alpha what they have of the mesh: holes of alpha-tested
/// materials are holes. Blended ones cover as much as they hide.
///
///     lodsmith::RenderEngine engine("");
///     if (auto started = engine.startHidden(); !started) ...
///     auto mesh = lodsmith::openMeshFile("tree.mesh");
///     auto renderer = lodsmith::LevelRenderer::create(mesh.value());
///     auto image = renderer.value()->picture(1, lodsmith::Paint::Own, renderer.value()->closeUp(direction, 512));
///
/// Needs a render system with fixed functions and a window, as RenderEngine has them; ends before OGRE does. The mesh
/// and its levels must not change meanwhile. Main thread only. The same pictures come out on every run with the same
/// OpenGL driver.
class LODSMITH_API LevelRenderer {
public:
    /// Errors: those of LevelReader for any of its levels; InvalidGeometry when level 0 has no triangles; Unsupported
    /// (OGRE refused).
    /// @param mesh loaded
    static Result<std::unique_ptr<LevelRenderer>> create(const Ogre::MeshPtr& mesh);
    ~LevelRenderer();
    LevelRenderer(const LevelRenderer&) = delete;
    LevelRenderer& operator=(const LevelRenderer&) = delete;

    const Ogre::MeshPtr& mesh() const;
    /// One sentence for each material and texture that is missing or cannot be read: their parts are drawn grey.
    const std::vector<std::string>& notes() const;
    /// Level 0 among them.
    unsigned levels() const;
    /// Of a level, hand-made ones too.
    std::size_t triangles(unsigned level) const;

    /// A level as it is seen on the screen, at one pixel for one: that part of the screen in which the mesh is,
    /// whichever level it shows, and at least 8 pixels around, as far as the screen goes. So pictures from one
    /// viewpoint have one size. Of alpha-tested materials Paint::Grey and Paint::Checker keep the holes; without
    /// normals they are one shade.
    /// Errors: Unsupported (OGRE refused), OutOfMemory.
    /// @param level below levels()
    Result<Image> picture(unsigned level, Paint paint, const Viewpoint& viewpoint);

    /// From where the mesh fills a square screen, in its own proportions: all levels are inside, and 8 pixels short of
    /// an edge.
    /// @param direction from the mesh to the camera, of length 1
    /// @param size pixels of the screen, 32 and up
    Viewpoint closeUp(const Ogre::Vector3& direction, unsigned size) const;

    /// From where OGRE switches to a level on its way away from the mesh. Errors: those of switchDistance(), Unsupported (it
    /// never does).
    Result<Viewpoint> atSwitch(unsigned level, const Ogre::Vector3& direction, const Screen& screen = {}) const;

private:
    class Parts;
    explicit LevelRenderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> mParts;
};

} // namespace lodsmith
