#pragma once

#include <lodsmith/lua/Binding.h>

#include <OgreResource.h>

#include <memory>

namespace lodsmith::lua {

/// A resource of whichever kind, as OGRE's managers have them: its kind is found out by toMesh() and toDefinition().
class Resource final : public Handle {
public:
    explicit Resource(const Ogre::ResourcePtr& resource);

    Ogre::ResourcePtr lock() const;

    Returned name() const;
    Returned group() const;
    Returned type() const;
    Returned isGone() const;

private:
    std::weak_ptr<Ogre::Resource> mResource;
};

/// The functions of that name in Lua: docs/lua.md.
Returned meshes();
Returned openMesh(Text path);
Returned openDirectory(Text path);
Returned listDirectory(Text path);
Returned resource(Text name, Text group);
Returned toMesh(const Resource& resource);
Returned toDefinition(const Resource& resource);

} // namespace lodsmith::lua
