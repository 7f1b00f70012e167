#pragma once

#include "Options.h"

#include <OgreLogManager.h>
#include <OgreOverlaySystem.h>
#include <OgreRenderWindow.h>
#include <OgreRoot.h>

#include <memory>
#include <string>

namespace lodsmith::samples {

/// OGRE itself. It has to outlive what it throws: the types of many exceptions are in plugins, which it unloads.
class Engine {
public:
    Engine();
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Loads plugins and starts the render system that is among them, without asking.
    void start(const std::string& pluginsFile);

    Ogre::Root& root();
    Ogre::OverlaySystem& overlays() { return *mOverlays; }

private:
    class Root;
    class Terminal;

    std::unique_ptr<Ogre::LogListener> mTerminal;
    Ogre::LogManager mLogs;
    std::unique_ptr<Root> mRoot;
    std::unique_ptr<Ogre::OverlaySystem> mOverlays;
};

/// The window.
class Window {
public:
    Window(Engine& engine, const Options& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    Ogre::RenderWindow& target() { return mTarget; }

    /// Draws a frame. False once the user has closed the window.
    bool draw();

private:
    Ogre::Root& mRoot;
    Ogre::RenderWindow& mTarget;
};

} // namespace lodsmith::samples
