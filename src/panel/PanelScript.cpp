#include "PanelScript.h"

#include "CeguiPreview.h"
#include "GuardedCegui.h"
#include "PreviewBinding.h"

#include <lodsmith/lua/Binding.h>

#include <exception>
#include <lua.hpp>
#include <string_view>
#include <utility>
#include <vector>

int tolua_Panel_open(lua_State* state);

namespace lodsmith {

namespace {

constexpr std::string_view kModulePrefix = "lodsmith.gui.";
constexpr const char* kWindowType = "CEGUI::Window";

std::string takeMessage(lua_State* state)
{
    std::string message = "an error without a message";
    if (lua_type(state, -1) == LUA_TSTRING)
        message = lua_tostring(state, -1);
    lua_pop(state, 1);
    return message;
}

/// Calls a function of Lua's or C's in protected mode. Errors: BadFile.
Result<Done> runProtected(lua_State* state, lua_CFunction function, void* argument)
{
    try {
        if (lua_cpcall(state, function, argument) == 0)
            return Done{};
        return Error{ErrorCode::BadFile, takeMessage(state)};
    } catch (const std::exception& exception) { // what CEGUI throws among others; its bindings let some of it through
        return Error{ErrorCode::BadFile, exception.what()};
    } catch (...) {
        return Error{ErrorCode::BadFile, "an unknown exception"};
    }
}

/// Leaves what stands under a name in the table `lodsmith`, or nil.
void pushLodsmithField(lua_State* state, const char* name)
{
    lua_getglobal(state, "lodsmith");
    if (lua_istable(state, -1))
        lua_getfield(state, -1, name);
    else
        lua_pushnil(state);
    lua_remove(state, -2);
}

int checkState(lua_State* state)
{
    lua_getglobal(state, "CEGUI");
    if (!lua_istable(state, -1))
        luaL_error(state, "the Lua state does not have CEGUI's script module");
    pushLodsmithField(state, "panel");
    if (!lua_isnil(state, -1))
        luaL_error(state, "the Lua state has an open panel");
    return 0;
}

/// Finds "lodsmith.gui.NAME" as NAME.lua in the directory that is its upvalue, so that the panel's modules and the program's may have the
/// same names. For package.loaders. May raise a Lua error.
int findModule(lua_State* state)
{
    const std::string_view name = luaL_checkstring(state, 1);
    if (name.substr(0, kModulePrefix.size()) != kModulePrefix)
        return 0;
    lua_pushfstring(state, "%s/%s.lua", lua_tostring(state, lua_upvalueindex(1)), name.data() + kModulePrefix.size());
    if (luaL_loadfile(state, lua_tostring(state, -1)) != 0)
        return lua_error(state);
    return 1;
}

/// Leaves the table package.loaders.
void pushLoaders(lua_State* state)
{
    lua_getglobal(state, "package");
    lua_getfield(state, -1, "loaders");
    lua_remove(state, -2);
}

void addLoader(lua_State* state, const char* directory)
{
    pushLoaders(state);
    lua_pushstring(state, directory);
    lua_pushcclosure(state, findModule, 1);
    lua_rawseti(state, -2, int(lua_objlen(state, -2)) + 1);
    lua_pop(state, 1);
}

void removeLoader(lua_State* state)
{
    pushLoaders(state);
    const int count = int(lua_objlen(state, -1));
    int kept = 0;
    for (int index = 1; index <= count; ++index) {
        lua_rawgeti(state, -1, index);
        if (lua_tocfunction(state, -1) == findModule)
            lua_pop(state, 1);
        else
            lua_rawseti(state, -2, ++kept);
    }
    for (int index = kept + 1; index <= count; ++index) {
        lua_pushnil(state);
        lua_rawseti(state, -2, index);
    }
    lua_pop(state, 1);
}

struct Message {
    const char* text;
};

int tellInLua(lua_State* state)
{
    const auto* message = static_cast<const Message*>(lua_touserdata(state, 1));
    pushLodsmithField(state, "onError");
    if (lua_isfunction(state, -1)) {
        lua_pushstring(state, message->text);
        lua_call(state, 1, 0);
    }
    return 0;
}

} // namespace

/// What the functions in Lua are given. Strings are kept by whoever calls.
struct PanelScript::Opening {
    PanelScript* script;
    const char* directory;
    lua::Table* fields; ///< of the table `lodsmith`
};

Result<Done> PanelScript::check(lua_State* state)
{
    const auto found = runProtected(state, checkState, nullptr);
    return found ? found : Error{ErrorCode::NotFound, found.error().message};
}

PanelScript::PanelScript(const PanelHost& host, const std::shared_ptr<CeguiPreview>& preview)
    : mState(host.lua), mHost(host), mPreview(preview)
{
}

Result<std::unique_ptr<PanelScript>> PanelScript::open(const PanelHost& host, const std::string& directory,
                                                       const std::shared_ptr<CeguiPreview>& preview)
{
    std::unique_ptr<PanelScript> script(new PanelScript(host, preview));
    lua::Table fields;
    if (preview)
        fields.set("preview", makePreviewHandle(preview));
    Opening opening{script.get(), directory.c_str(), &fields};
    const auto opened = runProtected(host.lua, openInLua, &opening);
    if (!opened)
        return opened.error();
    return script;
}

PanelScript::~PanelScript()
{
    // Nobody is left to tell when it fails, and the panel goes all the same.
    static_cast<void>(runProtected(mState, closeInLua, this));
}

/// Stack: Opening. Raises Lua errors.
int PanelScript::openInLua(lua_State* state)
{
    const auto* opening = static_cast<const Opening*>(lua_touserdata(state, 1));
    guardCegui(state);
    tolua_Panel_open(state);
    lua_settop(state, 1);
    lua_getglobal(state, "lodsmith");
    opening->fields->push(state);
    lua_getfield(state, -1, "preview");
    lua_setfield(state, -3, "preview");
    addLoader(state, opening->directory);
    lua_getglobal(state, "require");
    lua_pushliteral(state, "lodsmith.gui.AssetsManager");
    const int failed = lua_pcall(state, 1, 1, 0);
    removeLoader(state);
    if (failed != 0)
        return lua_error(state);
    lua_getfield(state, -1, "open");
    opening->script->pushOptions();
    lua_call(state, 1, 1);
    luaL_checktype(state, -1, LUA_TTABLE);
    lua_pushlightuserdata(state, opening->script);
    lua_insert(state, -2);
    lua_rawset(state, LUA_REGISTRYINDEX);
    return 0;
}

/// Leaves what AssetsManager's open() takes. Raises Lua errors.
void PanelScript::pushOptions()
{
    lua_newtable(mState);
    if (mHost.parent) {
        tolua_pushusertype(mState, mHost.parent, kWindowType);
        lua_setfield(mState, -2, "parent");
    }
    lua_pushboolean(mState, mHost.fillsParent);
    lua_setfield(mState, -2, "fill");
    pushLodsmithField(mState, "preview");
    lua_setfield(mState, -2, "preview");
    lua_newtable(mState);
    lua_pushboolean(mState, mHost.canOpen);
    lua_setfield(mState, -2, "canOpen");
    lua_pushlightuserdata(mState, this);
    lua_pushcclosure(mState, recentFilesForLua, 1);
    lua_setfield(mState, -2, "recentFiles");
    lua_pushlightuserdata(mState, this);
    lua_pushcclosure(mState, openedForLua, 1);
    lua_setfield(mState, -2, "opened");
    if (mHost.check) {
        lua_pushlightuserdata(mState, this);
        lua_pushcclosure(mState, checkForLua, 1);
        lua_setfield(mState, -2, "check");
    }
    lua_setfield(mState, -2, "host");
}

/// Leaves the panel's table, or nil when the panel is gone.
void PanelScript::pushPanel(lua_State* state, void* script)
{
    lua_pushlightuserdata(state, script);
    lua_rawget(state, LUA_REGISTRYINDEX);
}

/// The script whose function is running, or null when the panel is gone: scripts may have kept the function.
PanelScript* PanelScript::ofUpvalue(lua_State* state)
{
    void* script = lua_touserdata(state, lua_upvalueindex(1));
    pushPanel(state, script);
    const bool isThere = !lua_isnil(state, -1);
    lua_pop(state, 1);
    return isThere ? static_cast<PanelScript*>(script) : nullptr;
}

int PanelScript::recentFilesForLua(lua_State* state)
{
    const PanelScript* script = ofUpvalue(state);
    return lua::call(state, [&]() -> lua::Returned {
        if (!script || !script->mHost.recentFiles)
            return lua::Table();
        return lua::Table(script->mHost.recentFiles());
    });
}

int PanelScript::openedForLua(lua_State* state)
{
    std::size_t length = 0;
    const char* path = luaL_checklstring(state, 1, &length);
    const PanelScript* script = ofUpvalue(state);
    return lua::call(state, [&]() -> lua::Returned {
        if (script && script->mHost.opened)
            script->mHost.opened(std::string(path, length));
        return true;
    });
}

int PanelScript::checkForLua(lua_State* state)
{
    std::size_t length = 0;
    const char* path = luaL_checklstring(state, 1, &length);
    const PanelScript* script = ofUpvalue(state);
    return lua::call(state, [&]() -> lua::Returned {
        if (!script)
            return lua::Returned::failure("the panel is gone");
        return script->mHost.check(std::string(path, length));
    });
}

/// Stack: the script. Raises Lua errors.
int PanelScript::closeInLua(lua_State* state)
{
    void* script = lua_touserdata(state, 1);
    pushPanel(state, script);
    pushLodsmithField(state, "panel");
    const bool isShown = lua_rawequal(state, -1, -2) != 0;
    lua_pop(state, 1);
    lua_pushlightuserdata(state, script);
    lua_pushnil(state);
    lua_rawset(state, LUA_REGISTRYINDEX);
    lua_getglobal(state, "lodsmith");
    for (const char* field : {"preview", isShown ? "panel" : "preview"}) {
        lua_pushnil(state);
        lua_setfield(state, -2, field);
    }
    lua_pop(state, 1);
    if (!lua_istable(state, -1))
        return 0;
    lua_getfield(state, -1, "close");
    lua_insert(state, -2);
    lua_call(state, 1, 0);
    return 0;
}

struct PanelScript::Update {
    PanelScript* script;
    double seconds;
};

/// Stack: Update. Raises Lua errors.
int PanelScript::updateInLua(lua_State* state)
{
    const auto* update = static_cast<const Update*>(lua_touserdata(state, 1));
    pushPanel(state, update->script);
    lua_getfield(state, -1, "update");
    lua_insert(state, -2);
    lua_pushnumber(state, update->seconds);
    lua_call(state, 2, 0);
    return 0;
}

Result<Done> PanelScript::update(double seconds)
{
    Update argument{this, seconds};
    return runProtected(mState, updateInLua, &argument);
}

void PanelScript::tell(const std::string& text)
{
    Message message{text.c_str()};
    static_cast<void>(runProtected(mState, tellInLua, &message)); // the log has it
}

struct PanelScript::Answer {
    const PanelScript* script;
    bool isOpen;
};

/// Stack: Answer. Raises Lua errors.
int PanelScript::isOpenInLua(lua_State* state)
{
    auto* answer = static_cast<Answer*>(lua_touserdata(state, 1));
    pushPanel(state, const_cast<PanelScript*>(answer->script));
    lua_getfield(state, -1, "window");
    answer->isOpen = !lua_isnil(state, -1);
    return 0;
}

bool PanelScript::isOpen() const
{
    Answer answer{this, false};
    return runProtected(mState, isOpenInLua, &answer) && answer.isOpen;
}

} // namespace lodsmith
