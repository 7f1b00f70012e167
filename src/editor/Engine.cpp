#include "Engine.h"

#include <iostream>

namespace lodsmith::editor {

/// Plugins are loaded after its beginning, so that it is there when one of them throws.
class Engine::Root : public Ogre::Root {
public:
    Root() : Ogre::Root("", "", "") {}
};

class Engine::Terminal : public Ogre::LogListener {
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool, const Ogre::String&,
                       bool&) override
    {
        if (level >= Ogre::LML_WARNING)
            std::cerr << message << std::endl;
    }
};

Engine::Engine(const std::filesystem::path& log) : mTerminal(std::make_unique<Terminal>())
{
    mLogs.createLog(log.string(), true, false, log.empty())->addListener(mTerminal.get());
    mRoot = std::make_unique<Root>();
}

Engine::~Engine() = default;

void Engine::start()
{
    mRoot->loadPlugin(LODSMITH_OGRE_PLUGIN_DIR "/RenderSystem_GL");
    mRoot->loadPlugin(LODSMITH_OGRE_PLUGIN_DIR "/Codec_STBI");
    mRoot->setRenderSystem(mRoot->getAvailableRenderers().front());
    mRoot->initialise(false);
}

Ogre::Root& Engine::root()
{
    return *mRoot;
}

} // namespace lodsmith::editor
