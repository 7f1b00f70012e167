#pragma once

#include <lodsmith/core/Export.h>

#include <memory>

struct lua_State;

namespace lodsmith {

class LevelAnalyser;
class LodDefinitionManager;
class LodManager;
class QueuedProgressiveMeshGenerator;

namespace lua {
struct Services;
} // namespace lua

/// Puts the table `lodsmith` of docs/lua.md into a Lua 5.1 state, without the services; into the same state once more does nothing.
///
/// The state may have tolua++ already (CEGUI's script module brings it along). Nothing of C++ that Lua holds is an obstacle to
/// closing the state, before or after Ogre::Root goes. Throws std::bad_alloc when Lua has no memory. Main thread only.
///
/// @param state the state itself, none of its coroutines: callbacks run in it
LODSMITH_API void openLuaBindings(lua_State* state);

/// Lets the scripts of a state use what a program has for its meshes, for as long as the object lives: `lodsmith.definitions`,
/// `lodsmith.manager`, `lodsmith.queue`, `lodsmith.generator`, and an analyser of its own, `lodsmith.analysis`.
///
///     lodsmith::LuaServices services(state, definitions, manager, queue);
///
/// When it is destroyed, what Lua has of these says that it is gone, and the functions that were connected to the queue's
/// signals are let go. Made after the three services and destroyed before them; the state may be closed before or
/// after. A later object takes the place of an earlier one. Main thread only.
class LODSMITH_API LuaServices {
public:
    /// Opens the bindings where that has not been done.
    LuaServices(lua_State* state, LodDefinitionManager& definitions, LodManager& manager,
                QueuedProgressiveMeshGenerator& queue);
    ~LuaServices();
    LuaServices(const LuaServices&) = delete;
    LuaServices& operator=(const LuaServices&) = delete;

    /// What stands behind `lodsmith.analysis`, for use from C++ too. Lives as long as this object.
    LevelAnalyser& analyser();

private:
    std::shared_ptr<lua::Services> mServices;
};

} // namespace lodsmith
