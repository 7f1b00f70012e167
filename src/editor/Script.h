#pragma once

#include <lodsmith/core/Result.h>

#include <filesystem>
#include <memory>
#include <string>

struct lua_State;

namespace lodsmith::editor {

/// Runs a piece of Lua, in which `...` is the argument. Errors: BadFile, with Lua's message.
Result<Done> runLua(lua_State* lua, const char* code, const std::string& argument);

/// A Lua file that runs beside the panel, as a coroutine: coroutine.yield() lets a frame pass.
class Script {
public:
    /// Reads it; nothing runs yet. Errors: NotFound, BadFile (it is no Lua). The state has to outlive it.
    static Result<std::unique_ptr<Script>> load(lua_State* lua, const std::filesystem::path& file);
    ~Script();
    Script(const Script&) = delete;
    Script& operator=(const Script&) = delete;

    /// Runs it up to its next yield, or its end. True while there is more to come. Errors: BadFile, with the
    /// message and where it came from.
    Result<bool> resume();

private:
    Script(lua_State* lua, lua_State* thread, int reference);

    lua_State* mLua;
    lua_State* mThread;
    int mReference; ///< keeps the thread from being collected
};

} // namespace lodsmith::editor
