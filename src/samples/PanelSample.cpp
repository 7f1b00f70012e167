#include "Game.h"
#include "GameWindow.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>

namespace lodsmith::samples {

namespace {

int say(const std::exception& exception)
{
    std::cerr << "lodsmith_panel_sample: " << exception.what() << std::endl;
    return 1;
}

int play(const GameOptions& options)
{
    GameWindow window(options.width, options.height);
    Engine engine;
    try {
        engine.start(LODSMITH_PLUGINS_DIR "/plugins.cfg");
        Game(engine, window.attach(engine.root()), options).run();
        return 0;
    } catch (const std::exception& exception) { // while the plugins are there, which the types of many are in
        return say(exception);
    }
}

int run(int argc, char** argv)
{
    GameOptions options;
    CLI::App app{"A game with Lodsmith's panel in it: F1 opens and closes the panel, F2 halts the camera"};
    app.add_flag("--open-panel", options.opensPanel, "Start with the panel open");
    app.add_option("--objects", options.objects, "How many models")->check(CLI::Range(1, 100000));
    app.add_option("--width", options.width, "Of the window, in pixels")->check(CLI::Range(64, 8192));
    app.add_option("--height", options.height, "Of the window, in pixels")->check(CLI::Range(64, 8192));
    app.add_option("--frames", options.frames, "Draw one round of the camera in so many frames, and end");
    app.add_option("--screenshot", options.screenshot, "File for the last of --frames")->needs("--frames");
    CLI11_PARSE(app, argc, argv);
    return play(options);
}

} // namespace

} // namespace lodsmith::samples

int main(int argc, char** argv)
{
    try {
        return lodsmith::samples::run(argc, argv);
    } catch (const std::exception& exception) {
        return lodsmith::samples::say(exception);
    }
}
