#pragma once

#include "Gui.h"
#include "Options.h"
#include "Settings.h"
#include "Window.h"

#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/LodManager.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <chrono>
#include <filesystem>

namespace lodsmith::editor {

/// The program: window, panel and what they work on, from the first frame to the last.
class Editor {
public:
    Editor(Window& window, Ogre::Root& root, Settings& settings, const Options& options);

    /// Draws frames until the user, or the script, ends it. Returns the program's exit status.
    int run();

private:
    using Clock = std::chrono::steady_clock;

    /// Sleeps while nothing happens, then passes on what the user did.
    void handleEvents();
    void handle(const SDL_Event& event);
    void drawFrame();

    Window& mWindow;
    Ogre::Root& mRoot;
    Settings& mSettings;
    LodDefinitionManager mDefinitions;
    QueuedProgressiveMeshGenerator mQueue;
    LodManager mManager;
    Gui mGui;
    Clock::time_point mLastFrame = Clock::now();
    bool mIsEnding = false;
};

} // namespace lodsmith::editor
