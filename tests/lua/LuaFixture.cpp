#include "LuaFixture.h"

#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreSubMesh.h>

namespace lodsmith::test {

namespace {

LuaProgram& programOf(lua_State* state)
{
    return *static_cast<LuaProgram*>(lua_touserdata(state, lua_upvalueindex(1)));
}

int makeSphereFromLua(lua_State* state)
{
    programOf(state).makeSphere(luaL_checkstring(state, 1), static_cast<std::uint32_t>(luaL_optinteger(state, 2, 3)));
    return 0;
}

int writeSphereFromLua(lua_State* state)
{
    programOf(state).writeSphere(luaL_checkstring(state, 1), static_cast<std::uint32_t>(luaL_optinteger(state, 2, 3)));
    return 0;
}

int removeMeshFromLua(lua_State* state)
{
    LuaProgram::removeMesh(luaL_checkstring(state, 1));
    return 0;
}

int finishFromLua(lua_State* state)
{
    programOf(state).finish();
    return 0;
}

int spoilFromLua(lua_State* state)
{
    LuaProgram::spoil(luaL_checkstring(state, 1));
    return 0;
}

int finishAnalysisFromLua(lua_State* state)
{
    programOf(state).finishAnalysis();
    return 0;
}

int noteFromLua(lua_State* state)
{
    for (int i = 1; i <= lua_gettop(state); ++i)
        programOf(state).note(luaL_checkstring(state, i));
    return 0;
}

int endServicesFromLua(lua_State* state)
{
    programOf(state).endServices();
    return 0;
}

int startServicesFromLua(lua_State* state)
{
    programOf(state).startServices();
    return 0;
}

Ogre::MeshPtr findMesh(const std::string& name)
{
    for (auto resources = Ogre::MeshManager::getSingleton().getResourceIterator(); resources.hasMoreElements();)
        if (const Ogre::ResourcePtr resource = resources.getNext(); resource->getName() == name)
            return std::dynamic_pointer_cast<Ogre::Mesh>(resource);
    return nullptr;
}

} // namespace

StateHolder newState()
{
    StateHolder state(luaL_newstate());
    luaL_openlibs(state.get());
    return state;
}

std::string runLua(lua_State* state, const std::string& code, const std::string& name)
{
    if (luaL_loadbuffer(state, code.data(), code.size(), name.c_str()) == 0 && lua_pcall(state, 0, 0, 0) == 0)
        return {};
    const char* message = lua_tostring(state, -1);
    const std::string result = message ? message : "an error that is no string";
    lua_pop(state, 1);
    return result;
}

std::string evaluate(lua_State* state, const std::string& expressions)
{
    const std::string code = "local function show(...) local texts = {} "
                             "for i = 1, select('#', ...) do texts[i] = tostring((select(i, ...))) end "
                             "result_ = table.concat(texts, ', ') end show("
                             + expressions + ")";
    if (const std::string error = runLua(state, code); !error.empty())
        return "error: " + error;
    lua_getglobal(state, "result_");
    const std::string result = lua_tostring(state, -1);
    lua_pop(state, 1);
    return result;
}

LuaProgram::LuaProgram() : mQueue(std::make_unique<QueuedProgressiveMeshGenerator>())
{
    LodPolicy policy;
    policy.automatic = false;
    mManager = std::make_unique<LodManager>(mDefinitions, *mQueue, policy);
    mState = newState();
    startServices();
    addHelpers();
}

LuaProgram::~LuaProgram() = default;

void LuaProgram::startServices()
{
    mServices.reset();
    mServices = std::make_unique<LuaServices>(mState.get(), mDefinitions, *mManager, *mQueue);
}

void LuaProgram::destroyQueue()
{
    mServices.reset();
    mManager.reset();
    mQueue.reset();
}

Ogre::MeshPtr LuaProgram::makeSphere(const std::string& name, std::uint32_t subdivisions)
{
    return makeOgreMesh(name, makeIcosphere(subdivisions));
}

void LuaProgram::writeSphere(const std::string& name, std::uint32_t subdivisions)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("writing " + name, makeIcosphere(subdivisions));
    Ogre::MeshSerializer().exportMesh(mesh.get(), (mSession.directory() / name).string());
    Ogre::MeshManager::getSingleton().remove(mesh);
}

void LuaProgram::removeMesh(const std::string& name)
{
    if (const Ogre::MeshPtr mesh = findMesh(name))
        Ogre::MeshManager::getSingleton().remove(mesh);
}

void LuaProgram::spoil(const std::string& name)
{
    const Ogre::MeshPtr mesh = findMesh(name);
    setIndices(*mesh->getSubMesh(0), {0, 1, 60000}, Ogre::RenderOperation::OT_TRIANGLE_LIST);
}

void LuaProgram::addHelper(const char* name, lua_CFunction function)
{
    lua_pushlightuserdata(state(), this);
    lua_pushcclosure(state(), function, 1);
    lua_setglobal(state(), name);
}

void LuaProgram::addHelpers()
{
    addHelper("makeSphere", makeSphereFromLua);
    addHelper("writeSphere", writeSphereFromLua);
    addHelper("removeMesh", removeMeshFromLua);
    addHelper("spoil", spoilFromLua);
    addHelper("finish", finishFromLua);
    addHelper("finishAnalysis", finishAnalysisFromLua);
    addHelper("endServices", endServicesFromLua);
    addHelper("startServices", startServicesFromLua);
    addHelper("note", noteFromLua);
    lua_pushstring(state(), mSession.directory().c_str());
    lua_setglobal(state(), "directory");
    lua_pushstring(state(), mSession.group().c_str());
    lua_setglobal(state(), "group");
}

} // namespace lodsmith::test
