#include "OgreProgram.h"

#include <OgreRoot.h>

#include <chrono>
#include <filesystem>
#include <lua.hpp>
#include <thread>

namespace lodsmith::test {

namespace {

int takeSampleFromLua(lua_State* lua)
{
    const auto& program = *static_cast<OgreProgram*>(lua_touserdata(lua, lua_upvalueindex(1)));
    lua_pushstring(lua, program.takeSample(luaL_checkstring(lua, 1)).c_str());
    return 1;
}

int ogreFrame(lua_State*)
{
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    Ogre::Root::getSingleton()._fireFrameStarted();
    return 0;
}

} // namespace

OgreProgram::OgreProgram(lua_State* lua)
    : mManager(mDefinitions, mQueue), mServices(lua, mDefinitions, mManager, mQueue)
{
    addHelpers(lua);
}

std::string OgreProgram::takeSample(const std::string& name) const
{
    const std::filesystem::path source = std::filesystem::path(LODSMITH_MEDIA) / name;
    // Without a render system there are no textures, and so no materials.
    for (const char* extension : {".mesh", ".skeleton"}) {
        const std::string file = name + extension;
        if (std::filesystem::exists(source / file)) {
            std::filesystem::copy_file(source / file, mSession.directory() / file);
        }
    }
    return (mSession.directory() / (name + ".mesh")).string();
}

void OgreProgram::addHelpers(lua_State* lua)
{
    lua_pushlightuserdata(lua, this);
    lua_pushcclosure(lua, takeSampleFromLua, 1);
    lua_setglobal(lua, "takeSample");
    lua_pushcfunction(lua, ogreFrame);
    lua_setglobal(lua, "ogreFrame");
    lua_pushstring(lua, mSession.directory().c_str());
    lua_setglobal(lua, "directory");
}

} // namespace lodsmith::test
