#include <lodsmith/lua/LuaBindings.h>

#include "Analysis.h"
#include "Callback.h"
#include "Services.h"
#include "StateLink.h"

#include <memory>
#include <new>

int tolua_Lodsmith_open(lua_State* state);

namespace lodsmith {

namespace lua {

namespace {

int openProtected(lua_State* state)
{
    makeStateLink(state);
    prepareCallbacks(state);
    tolua_Lodsmith_open(state);
    return 0;
}

/// The services' handles, on their way into the table `lodsmith`.
struct ServiceValues {
    explicit ServiceValues(const std::shared_ptr<Services>& services)
    {
        values.set("definitions", std::make_unique<Definitions>(services))
            .set("manager", std::make_unique<Manager>(services))
            .set("queue", std::make_unique<Queue>(services))
            .set("generator", std::make_unique<Generator>(services))
            .set("analysis", std::make_unique<Analysis>(services));
    }
    Table values;
};

int setFields(lua_State* state)
{
    auto* fields = static_cast<Table*>(lua_touserdata(state, 1));
    lua_getglobal(state, "lodsmith");
    fields->push(state);
    lua_pushnil(state);
    while (lua_next(state, -2) != 0) {
        lua_pushvalue(state, -2);
        lua_insert(state, -2);
        lua_rawset(state, 2);
    }
    return 0;
}

/// Runs a function that may raise Lua errors.
void runProtected(lua_State* state, lua_CFunction function, void* argument)
{
    if (lua_cpcall(state, function, argument) == 0)
        return;
    lua_pop(state, 1);
    throw std::bad_alloc();
}

} // namespace

} // namespace lua

void openLuaBindings(lua_State* state)
{
    if (!lua::stateLink(state))
        lua::runProtected(state, lua::openProtected, nullptr);
}

LuaServices::LuaServices(lua_State* state, LodDefinitionManager& definitions, LodManager& manager,
                         QueuedProgressiveMeshGenerator& queue)
    : mServices(std::make_shared<lua::Services>(definitions, manager, queue))
{
    openLuaBindings(state);
    lua::ServiceValues fields(mServices);
    lua::runProtected(state, lua::setFields, &fields.values);
}

LuaServices::~LuaServices() = default;

LevelAnalyser& LuaServices::analyser()
{
    return mServices->analyser;
}

} // namespace lodsmith
