#include "Definition.h"
#include "Services.h"

#include <lodsmith/loddef/LoddefXml.h>

#include <filesystem>

namespace lodsmith::lua {

namespace {

Error meshGone()
{
    return Error{ErrorCode::NotFound, "the mesh is gone"};
}

Returned readDefinition(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        return Returned(std::make_unique<Definition>(LodDefinition())).with(nullptr);
    LoddefReading reading = readLoddefFile(path);
    if (!reading.ok())
        return Returned::failures(reading.errors);
    return Returned(std::make_unique<Definition>(std::move(*reading.definition))).with(path.string());
}

} // namespace

Definitions::Definitions(const std::shared_ptr<Services>& services)
    : ServiceHandle("lodsmith::Definitions", "definition manager", services)
{
}

Returned Definitions::read(const Mesh& handle) const
{
    return withServices([&](Services& services) -> Returned {
        const Ogre::MeshPtr mesh = handle.lock();
        if (!mesh)
            return meshGone();
        const Result<std::filesystem::path> path = services.definitions.pathFor(*mesh);
        if (!path)
            return path.error();
        return readDefinition(path.value());
    });
}

Returned Definitions::path(const Mesh& handle) const
{
    return withServices([&](Services& services) -> Returned {
        const Ogre::MeshPtr mesh = handle.lock();
        if (!mesh)
            return meshGone();
        const Result<std::filesystem::path> path = services.definitions.pathFor(*mesh);
        if (!path)
            return path.error();
        return path.value().string();
    });
}

Returned Definitions::save(const Mesh& handle, const Definition& definition) const
{
    return withServices([&](Services& services) -> Returned {
        const Ogre::MeshPtr mesh = handle.lock();
        if (!mesh)
            return meshGone();
        const Result<std::filesystem::path> path = services.definitions.save(*mesh, definition.data());
        if (!path)
            return path.error();
        return path.value().string();
    });
}

} // namespace lodsmith::lua
