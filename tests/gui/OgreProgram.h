#pragma once

#include <support/OgreSession.h>

#include <lodsmith/lua/LuaBindings.h>
#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/LodManager.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <string>

struct lua_State;

namespace lodsmith::test {

/// A program with meshes, without a window, that shares its services with a Lua state. Scripts find there besides:
///
///     directory           an empty directory that vanishes with the program
///     takeSample(name)    copies a mesh of media/ and its skeleton to the directory, and returns its path
///     ogreFrame()         a frame of OGRE's, after a moment's rest for the threads
class OgreProgram {
public:
    explicit OgreProgram(lua_State* lua);
    OgreProgram(const OgreProgram&) = delete;
    OgreProgram& operator=(const OgreProgram&) = delete;

    std::string takeSample(const std::string& name) const;

private:
    void addHelpers(lua_State* lua);

    OgreSession mSession;
    LodDefinitionManager mDefinitions;
    QueuedProgressiveMeshGenerator mQueue;
    LodManager mManager;
    LuaServices mServices;
};

} // namespace lodsmith::test
