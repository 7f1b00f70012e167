#pragma once

#include "Control.h"

#include <lodsmith/lua/Binding.h>

#include <memory>

namespace lodsmith::lua {

/// The table field `lodsmith.editor`: docs/lua.md.
class EditorHandle final : public Handle {
public:
    explicit EditorHandle(std::weak_ptr<editor::Control> control);
    ~EditorHandle() override;

    Returned quit(double status);
    Returned screenshot(Text file);
    Returned recentFiles();
    Returned frameTimes();
    Returned seconds();

private:
    template <class Action>
    Returned act(const Action& action);

    std::weak_ptr<editor::Control> mControl;
};

} // namespace lodsmith::lua

namespace lodsmith::editor {

/// Puts `lodsmith.editor` into a state that has the bindings. Errors: OutOfMemory.
Result<Done> shareEditor(lua_State* state, const std::shared_ptr<Control>& control);

} // namespace lodsmith::editor
