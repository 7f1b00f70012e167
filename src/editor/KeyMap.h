#pragma once

#include <CEGUI/InputEvent.h>
#include <SDL.h>

namespace lodsmith::editor {

/// CEGUI's name of a key. Letters go by what is printed on the key, so that Ctrl+Z is where the user's keyboard has Z.
/// Unknown for keys that CEGUI has no name for.
CEGUI::Key::Scan keyFor(SDL_Keycode key);

/// CEGUI's name of a mouse button; NoButton for buttons that it has no name for.
CEGUI::MouseButton buttonFor(Uint8 button);

} // namespace lodsmith::editor
