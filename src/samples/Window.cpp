#include "Window.h"

#include <OgreWindowEventUtilities.h>

#include <iostream>

namespace lodsmith::samples {

/// Plugins are loaded after its beginning, so that it is there when one of them throws.
class Engine::Root : public Ogre::Root {
public:
    Root() : Ogre::Root("", "", "") {}
    using Ogre::Root::loadPlugins;
};

/// Of OGRE's messages those that matter go to the terminal.
class Engine::Terminal : public Ogre::LogListener {
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool, const Ogre::String&,
                       bool&) override
    {
        if (level >= Ogre::LML_WARNING)
            std::cerr << message << std::endl;
    }
};

Engine::Engine() : mTerminal(std::make_unique<Terminal>())
{
    mLogs.createLog("", true, false, true)->addListener(mTerminal.get());
    mRoot = std::make_unique<Root>();
    mOverlays = std::make_unique<Ogre::OverlaySystem>();
}

Engine::~Engine() = default;

void Engine::start(const std::string& pluginsFile)
{
    mRoot->loadPlugins(pluginsFile);
    mRoot->setRenderSystem(mRoot->getAvailableRenderers().front());
    mRoot->initialise(false);
}

Ogre::Root& Engine::root()
{
    return *mRoot;
}

Window::Window(Engine& engine, const Options& options)
    : mRoot(engine.root()), mTarget(*mRoot.createRenderWindow("Lodsmith", options.width, options.height, false))
{
    OgreBites::WindowEventUtilities::_addRenderWindow(&mTarget);
}

Window::~Window()
{
    OgreBites::WindowEventUtilities::_removeRenderWindow(&mTarget);
}

bool Window::draw()
{
    OgreBites::WindowEventUtilities::messagePump();
    return !mTarget.isClosed() && mRoot.renderOneFrame();
}

} // namespace lodsmith::samples
