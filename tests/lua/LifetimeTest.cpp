#include "LuaFixture.h"

#include <OgreMeshManager.h>

namespace lodsmith::test {

namespace {

/// A connection, a job and handles of every kind, as globals.
const char* const kHoldEverything = R"(
    makeSphere("a", 2)
    mesh = lodsmith.meshes()[1]
    definition = lodsmith.newDefinition()
    definition:setAutomatic(false)
    level = assert(definition:addLevel(10))
    resource = assert(lodsmith.resource("a", "General"))
    heard = 0
    connection = assert(lodsmith.queue:onInjected(function() heard = heard + 1 end))
    progress = assert(lodsmith.queue:onProgress(function() end))
    job = assert(lodsmith.analysis:curve(mesh, definition, 20, function() heard = heard + 1 end))
    assert(lodsmith.queue:generate(mesh, definition))
)";

} // namespace

TEST(LuaLifetime, theStateIsClosedFirst)
{
    LuaProgram program;
    EXPECT_LUA(program.state(), kHoldEverything);
    program.closeState();
    // Functions that would be called by now are gone.
    program.finish();
    program.finishAnalysis();
}

TEST(LuaLifetime, theServicesEndFirst)
{
    LuaProgram program;
    EXPECT_LUA(program.state(), kHoldEverything);
    program.endServices();
    program.finish();
    EXPECT_EQ("0, false, false, false", evaluate(program.state(), "heard, connection:isConnected(), "
                                                                  "progress:isConnected(), job:isRunning()"));
}

TEST(LuaLifetime, theEmitterGoesFirst)
{
    LuaProgram program;
    EXPECT_LUA(program.state(), kHoldEverything);
    program.destroyQueue();
    EXPECT_EQ("false, false, nil, the queue is gone",
              evaluate(program.state(), "connection:isConnected(), progress:isConnected(), lodsmith.queue:queued()"));
    EXPECT_LUA(program.state(), "connection:disconnect() connection = nil collectgarbage()");
}

TEST(LuaLifetime, ogreGoesFirst)
{
    const StateHolder state = newState();
    {
        OgreSession session;
        LodDefinitionManager definitions;
        QueuedProgressiveMeshGenerator queue;
        LodManager manager(definitions, queue);
        const LuaServices services(state.get(), definitions, manager, queue);
        makeOgreMesh("a", makeIcosphere(2));
        EXPECT_LUA(state.get(), "mesh = lodsmith.meshes()[1] resource = lodsmith.resource('a', 'General') "
                                "connection = lodsmith.queue:onFailed(function() end)");
    }
    EXPECT_EQ("true, nil, the mesh is gone", evaluate(state.get(), "mesh:isGone(), mesh:name()"));
    EXPECT_EQ("nil, the resource is gone", evaluate(state.get(), "resource:name()"));
    EXPECT_EQ("nil, OGRE is gone", evaluate(state.get(), "lodsmith.meshes()"));
    EXPECT_EQ("nil, the queue is gone", evaluate(state.get(), "lodsmith.queue:queued()"));
}

TEST(LuaLifetime, twoStatesShareOneProgram)
{
    LuaProgram program;
    const StateHolder other = newState();
    const LuaServices services(other.get(), program.definitions(), program.manager(), program.queue());
    const char* const listen = "heard = 0 connection = lodsmith.queue:onInjected(function() heard = heard + 1 end)";
    EXPECT_LUA(program.state(), listen);
    EXPECT_LUA(other.get(), listen);
    EXPECT_LUA(other.get(), "ball = function() for _, m in ipairs(lodsmith.meshes()) do return m end end");
    program.makeSphere("a", 2);
    EXPECT_LUA(other.get(), "lodsmith.queue:generate(ball(), lodsmith.newDefinition())");
    program.finish();
    EXPECT_EQ("1", evaluate(program.state(), "heard"));
    EXPECT_EQ("1", evaluate(other.get(), "heard"));
    // The first one closes, the second goes on.
    program.closeState();
    EXPECT_LUA(other.get(), "lodsmith.queue:generate(ball(), lodsmith.newDefinition())");
    program.finish();
    EXPECT_EQ("2", evaluate(other.get(), "heard"));
}

TEST(LuaLifetime, aMeshAtTheAddressOfOneThatIsGoneIsAnother)
{
    LuaProgram program;
    program.makeSphere("first", 1);
    EXPECT_LUA(program.state(), "first = lodsmith.meshes()[1]");
    bool sameAddress = false;
    const void* address = Ogre::MeshManager::getSingleton().getByName("first").get();
    LuaProgram::removeMesh("first");
    for (int i = 0; i < 50 && !sameAddress; ++i) {
        const Ogre::MeshPtr next = program.makeSphere("next" + std::to_string(i), 1);
        sameAddress = next.get() == address;
    }
    EXPECT_EQ("true, nil, the mesh is gone", evaluate(program.state(), "first:isGone(), first:name()"));
    EXPECT_EQ("false", evaluate(program.state(), "first:equals(lodsmith.meshes()[1])"));
    if (!sameAddress)
        GTEST_SKIP() << "no mesh got the address of the one that is gone";
}

TEST(LuaLifetime, ameshThatSomebodyElseKeepsIsThere)
{
    LuaProgram program;
    const Ogre::MeshPtr kept = program.makeSphere("a", 1);
    EXPECT_LUA(program.state(), "mesh = lodsmith.meshes()[1]");
    LuaProgram::removeMesh("a");
    EXPECT_EQ("false, a", evaluate(program.state(), "mesh:isGone(), mesh:name()"));
}

} // namespace lodsmith::test
