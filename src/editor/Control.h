#pragma once

#include "Settings.h"
#include "Window.h"

#include <string>
#include <vector>

namespace lodsmith::editor {

/// What the last frame took, seconds.
struct FrameTimes {
    double work = 0.0; ///< events, panel, generation's share of the main thread
    double draw = 0.0; ///< the renderer's own
};

/// What scripts and the panel may do with the editor. Belongs to it, and goes with it.
struct Control {
    Window& window;
    Settings& settings;
    FrameTimes lastFrame;
    bool isEnding = false;
    int status = 0; ///< of the program, once isEnding
};

} // namespace lodsmith::editor
