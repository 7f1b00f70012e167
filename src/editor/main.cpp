#include "Editor.h"

#include <lodsmith/render/RenderEngine.h>

#include <CLI/CLI.hpp>

#include <exception>
#include <fstream>
#include <iostream>

namespace lodsmith::editor {

namespace {

constexpr int kFailed = 1;

void say(const std::string& message)
{
    std::cerr << "lodsmith-editor: " << message << std::endl;
}

Settings settingsFrom(const std::filesystem::path& file)
{
    if (file.empty())
        return {};
    auto settings = readSettings(file);
    if (!settings)
        say(describe(settings.error()) + "; starting without");
    return settings ? settings.value() : Settings{};
}

/// The exit status.
int runEditor(Ogre::Root& root, Window& window, Settings& settings, MeshProbe& probe, const Options& options)
{
    Editor editor(root, window, settings, probe);
    if (const auto opened = editor.open(options); !opened) {
        say(describe(opened.error()));
        return kFailed;
    }
    return editor.run();
}

int edit(const Options& options)
{
    if (!options.log.empty() && !std::ofstream(options.log, std::ios::app)) {
        say(options.log.string() + ": cannot be written");
        return kFailed;
    }
    const std::filesystem::path file = settingsFile();
    Settings settings = settingsFrom(file);
    // While there is one thread.
    const auto probe = MeshProbe::start();
    if (!probe) {
        say(describe(probe.error()));
        return kFailed;
    }
    auto window = Window::open(settings.window);
    if (!window) {
        say(describe(window.error()));
        return kFailed;
    }
    RenderEngine engine(options.log);
    try {
        engine.start();
        window.value()->attach(engine.root());
        const int status = runEditor(engine.root(), *window.value(), settings, *probe.value(), options);
        settings.window = window.value()->place();
        if (!file.empty())
            if (const auto written = writeSettings(file, settings); !written)
                say(describe(written.error()));
        window.value().reset();
        return status;
    } catch (const std::exception& exception) {
        say(exception.what());
        window.value().reset();
        return kFailed;
    }
}

int run(int argc, char** argv)
{
    Options options;
    CLI::App app{"Shows the levels of detail of OGRE meshes, and edits the .loddef files beside them"};
    app.add_option("paths", options.paths, "Meshes to open, or directories of meshes");
    app.add_option("--script", options.script, "Lua to run once the window is open")->type_name("FILE.lua");
    app.add_option("--log", options.log, "File for all messages")->type_name("FILE");
    CLI11_PARSE(app, argc, argv);
    return edit(options);
}

} // namespace

} // namespace lodsmith::editor

int main(int argc, char** argv)
{
    try {
        return lodsmith::editor::run(argc, argv);
    } catch (const std::exception& exception) {
        lodsmith::editor::say(exception.what());
        return lodsmith::editor::kFailed;
    }
}
