#include "PictureSession.h"

#include "../ogre/OgreGuard.h"

#include <lodsmith/ogre/MeshFiles.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreResourceGroupManager.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

/// Makes the resource group that openMeshFile() will look for, with the scripts of `materials` and the files of both
/// directories.
Result<Done> prepareGroup(const fs::path& mesh, const fs::path& materials)
{
    std::error_code ignored;
    if (!fs::is_directory(materials, ignored))
        return Error{ErrorCode::NotFound, "no such directory", materials.string()};
    const std::string group = fs::weakly_canonical(mesh, ignored).parent_path().string();
    return guarded(materials.string(), [&]() -> Result<Done> {
        auto& groups = Ogre::ResourceGroupManager::getSingleton();
        groups.createResourceGroup(group, false);
        groups.addResourceLocation(materials.string(), "FileSystem", group);
        groups.initialiseResourceGroup(group);
        // Now that scripts have been read, since those beside the mesh would make the same materials; and before the other
        // one, where files of the same names may be.
        groups.removeResourceLocation(materials.string(), group);
        groups.addResourceLocation(group, "FileSystem", group);
        groups.addResourceLocation(materials.string(), "FileSystem", group);
        return Done{};
    });
}

} // namespace

Result<std::unique_ptr<PictureSession>> PictureSession::open(const fs::path& mesh, const fs::path& materials)
{
    std::unique_ptr<PictureSession> session(new PictureSession);
    if (const Result<Done> started = session->start(mesh, materials); !started) {
        Error error = started.error();
        if (error.file == mesh.filename().string())
            error.file = mesh.string(); // OGRE's name of it is that in its directory
        return error;
    }
    return session;
}

Result<Done> PictureSession::start(const fs::path& mesh, const fs::path& materials)
{
    if (auto started = mEngine.startHidden(); !started)
        return started;
    if (!materials.empty())
        if (auto prepared = prepareGroup(mesh, materials); !prepared)
            return prepared;
    const Result<Ogre::MeshPtr> opened = openMeshFile(mesh);
    if (!opened)
        return opened.error();
    mHasAutomaticLevels = opened.value()->getNumLodLevels() == 1;
    if (mHasAutomaticLevels)
        if (const auto report = ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(opened.value()); !report)
            return report.error();
    auto renderer = LevelRenderer::create(opened.value());
    if (!renderer)
        return renderer.error();
    mRenderer = std::move(renderer).value();
    return Done{};
}

} // namespace lodsmith::cli
