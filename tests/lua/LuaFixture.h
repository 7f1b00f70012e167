#pragma once

#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/lua/LuaBindings.h>
#include <lodsmith/ogre/LevelAnalyser.h>
#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/LodManager.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <gtest/gtest.h>
#include <lua.hpp>

#include <memory>
#include <string>

namespace lodsmith::test {

struct CloseState {
    void operator()(lua_State* state) const { lua_close(state); }
};
using StateHolder = std::unique_ptr<lua_State, CloseState>;

/// A state with Lua's own libraries.
StateHolder newState();

/// Runs Lua code. Empty when all went well, else the message of the Lua error.
std::string runLua(lua_State* state, const std::string& code, const std::string& name = "=test");

/// What an expression gives, each value as tostring() shows it, with commas between; or "error: " and the message.
std::string evaluate(lua_State* state, const std::string& expressions);

/// A program with meshes that shares its services with a Lua state. Scripts of tests find there besides:
///
///     makeSphere(name [, subdivisions])  a mesh made by hand, in the group `group`
///     writeSphere(name [, subdivisions]) a mesh file in the directory `directory`, not loaded
///     removeMesh(name)                   OGRE forgets it
///     spoil(name)                        the mesh gets an index that is out of range
///     finish(), finishAnalysis()         everything that is queued, or to be analysed, is done
///     endServices(), startServices()     LuaServices goes, or is made anew
///     note(...)                          writes down values, see transcript()
class LuaProgram {
public:
    LuaProgram();
    ~LuaProgram();
    LuaProgram(const LuaProgram&) = delete;
    LuaProgram& operator=(const LuaProgram&) = delete;

    lua_State* state() const { return mState.get(); }
    void closeState() { mState.reset(); }
    void startServices();
    void endServices() { mServices.reset(); }
    /// The emitter of all signals, with the manager, which needs it.
    void destroyQueue();
    void finish() { mQueue->injector().finishAll(); }
    void finishAnalysis() { mServices->analyser().finishAll(); }
    void note(const std::string& text) { mTranscript += text + "\n"; }
    const std::string& transcript() const { return mTranscript; }

    Ogre::MeshPtr makeSphere(const std::string& name, std::uint32_t subdivisions = 3);
    void writeSphere(const std::string& name, std::uint32_t subdivisions = 3);
    static void removeMesh(const std::string& name);
    static void spoil(const std::string& name);

    OgreSession& session() { return mSession; }
    LodManager& manager() { return *mManager; }
    QueuedProgressiveMeshGenerator& queue() { return *mQueue; }
    LodDefinitionManager& definitions() { return mDefinitions; }

private:
    void addHelpers();
    void addHelper(const char* name, lua_CFunction function);

    OgreSession mSession;
    LodDefinitionManager mDefinitions;
    std::unique_ptr<QueuedProgressiveMeshGenerator> mQueue;
    std::unique_ptr<LodManager> mManager;
    StateHolder mState;
    std::unique_ptr<LuaServices> mServices;
    std::string mTranscript;
};

/// EXPECT_LUA("assert(...)"): the code runs without an error.
#define EXPECT_LUA(state, code) EXPECT_EQ("", ::lodsmith::test::runLua(state, code))

} // namespace lodsmith::test
