#include "EditorHandle.h"

#include <chrono>

int tolua_Editor_open(lua_State* state);

namespace lodsmith::lua {

EditorHandle::EditorHandle(std::weak_ptr<editor::Control> control)
    : Handle("lodsmith::EditorHandle"), mControl(std::move(control))
{
}

EditorHandle::~EditorHandle() = default;

template <class Action>
Returned EditorHandle::act(const Action& action)
{
    const auto control = mControl.lock();
    if (!control)
        return Returned::failure("the editor is gone");
    return action(*control);
}

Returned EditorHandle::quit(double status)
{
    return act([&](editor::Control& control) -> Returned {
        if (!(status >= 0 && status <= 255))
            return Returned::failure("an exit status is 0..255");
        control.isEnding = true;
        control.status = int(status);
        return true;
    });
}

Returned EditorHandle::screenshot(Text file)
{
    return act([&](editor::Control& control) -> Returned { return control.window.screenshot(std::string(file)); });
}

Returned EditorHandle::recentFiles()
{
    return act([](editor::Control& control) -> Returned { return Table(control.settings.recentFiles); });
}

Returned EditorHandle::frameTimes()
{
    return act([](editor::Control& control) { return Returned(control.lastFrame.work).with(control.lastFrame.draw); });
}

Returned EditorHandle::seconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace lodsmith::lua

namespace lodsmith::editor {

namespace {

/// Stack: a lua::Table with what is to go into the table `lodsmith`. May raise a Lua error.
int share(lua_State* state)
{
    auto* const fields = static_cast<lua::Table*>(lua_touserdata(state, 1));
    tolua_Editor_open(state);
    lua_getglobal(state, "lodsmith");
    fields->push(state);
    lua_getfield(state, -1, "editor");
    lua_setfield(state, -3, "editor");
    return 0;
}

} // namespace

Result<Done> shareEditor(lua_State* state, const std::shared_ptr<Control>& control)
{
    lua::Table fields;
    fields.set("editor", std::make_unique<lua::EditorHandle>(control));
    if (lua_cpcall(state, share, &fields) == 0)
        return Done{};
    lua_pop(state, 1);
    return Error{ErrorCode::OutOfMemory, "Lua has no memory for the editor"};
}

} // namespace lodsmith::editor
