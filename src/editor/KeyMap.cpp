#include "KeyMap.h"

#include <algorithm>
#include <iterator>

namespace lodsmith::editor {

namespace {

using Scan = CEGUI::Key::Scan;

// In the order of the alphabet.
constexpr Scan kLetters[] = {Scan::A, Scan::B, Scan::C, Scan::D, Scan::E, Scan::F, Scan::G, Scan::H, Scan::I,
                             Scan::J, Scan::K, Scan::L, Scan::M, Scan::N, Scan::O, Scan::P, Scan::Q, Scan::R,
                             Scan::S, Scan::T, Scan::U, Scan::V, Scan::W, Scan::X, Scan::Y, Scan::Z};
constexpr Scan kDigits[] = {Scan::Zero, Scan::One, Scan::Two,   Scan::Three, Scan::Four,
                            Scan::Five, Scan::Six, Scan::Seven, Scan::Eight, Scan::Nine};

struct NamedKey {
    SDL_Keycode key;
    Scan scan;
};

constexpr NamedKey kNamedKeys[] = {
    {SDLK_ESCAPE, Scan::Escape},
    {SDLK_BACKSPACE, Scan::Backspace},
    {SDLK_TAB, Scan::Tab},
    {SDLK_RETURN, Scan::Return},
    {SDLK_KP_ENTER, Scan::NumpadEnter},
    {SDLK_SPACE, Scan::Space},
    {SDLK_LCTRL, Scan::LeftControl},
    {SDLK_RCTRL, Scan::RightControl},
    {SDLK_LSHIFT, Scan::LeftShift},
    {SDLK_RSHIFT, Scan::RightShift},
    {SDLK_LALT, Scan::LeftAlt},
    {SDLK_RALT, Scan::RightAlt},
    {SDLK_HOME, Scan::Home},
    {SDLK_END, Scan::End},
    {SDLK_PAGEUP, Scan::PageUp},
    {SDLK_PAGEDOWN, Scan::PageDown},
    {SDLK_UP, Scan::ArrowUp},
    {SDLK_DOWN, Scan::ArrowDown},
    {SDLK_LEFT, Scan::ArrowLeft},
    {SDLK_RIGHT, Scan::ArrowRight},
    {SDLK_INSERT, Scan::Insert},
    {SDLK_DELETE, Scan::Delete},
    {SDLK_MINUS, Scan::Minus},
    {SDLK_EQUALS, Scan::Equals},
    {SDLK_PLUS, Scan::Add},
    {SDLK_KP_PLUS, Scan::Add},
    {SDLK_KP_MINUS, Scan::Subtract},
    {SDLK_PERIOD, Scan::Period},
    {SDLK_COMMA, Scan::Comma},
    {SDLK_SLASH, Scan::Slash},
    {SDLK_F1, Scan::F1},
    {SDLK_F2, Scan::F2},
    {SDLK_F3, Scan::F3},
    {SDLK_F4, Scan::F4},
    {SDLK_F5, Scan::F5},
    {SDLK_F6, Scan::F6},
    {SDLK_F7, Scan::F7},
    {SDLK_F8, Scan::F8},
    {SDLK_F9, Scan::F9},
    {SDLK_F10, Scan::F10},
    {SDLK_F11, Scan::F11},
    {SDLK_F12, Scan::F12},
};

} // namespace

CEGUI::Key::Scan keyFor(SDL_Keycode key)
{
    if (key >= SDLK_a && key <= SDLK_z)
        return kLetters[key - SDLK_a];
    if (key >= SDLK_0 && key <= SDLK_9)
        return kDigits[key - SDLK_0];
    const auto named = std::find_if(std::begin(kNamedKeys), std::end(kNamedKeys),
                                    [key](const NamedKey& candidate) { return candidate.key == key; });
    return named == std::end(kNamedKeys) ? Scan::Unknown : named->scan;
}

CEGUI::MouseButton buttonFor(Uint8 button)
{
    switch (button) {
    case SDL_BUTTON_LEFT: return CEGUI::LeftButton;
    case SDL_BUTTON_MIDDLE: return CEGUI::MiddleButton;
    case SDL_BUTTON_RIGHT: return CEGUI::RightButton;
    case SDL_BUTTON_X1: return CEGUI::X1Button;
    case SDL_BUTTON_X2: return CEGUI::X2Button;
    default: return CEGUI::NoButton;
    }
}

} // namespace lodsmith::editor
