#pragma once

#include <string>

namespace lodsmith::samples {

/// Where the levels come from.
enum class Levels { Library, Plugin, None };

/// What the command line says.
struct Options {
    Levels levels = Levels::Library;
    unsigned objects = 600;
    unsigned width = 1280; ///< pixels of the window
    unsigned height = 720;
    unsigned frames = 0; ///< of one round of the camera, after which the program ends; 0: for ever, a round a minute
    double warmUpSeconds = 0; ///< frames at the beginning of the round that do not count
    std::string screenshot;   ///< file for the picture of the last frame
};

} // namespace lodsmith::samples
