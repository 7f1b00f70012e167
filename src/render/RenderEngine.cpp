#include <lodsmith/render/RenderEngine.h>

#include <cstdlib>
#include <iostream>

namespace lodsmith {

namespace {

Error noDisplay(const std::string& why)
{
    return {ErrorCode::Unsupported,
            "pictures need an X display, " + why + "; without a screen `xvfb-run -a` gives one"};
}

} // namespace

/// Plugins are loaded after its beginning, so that it is there when one of them throws.
class RenderEngine::Root : public Ogre::Root {
public:
    Root() : Ogre::Root("", "", "") {}
};

class RenderEngine::Terminal : public Ogre::LogListener {
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool, const Ogre::String&,
                       bool&) override
    {
        if (level >= Ogre::LML_WARNING)
            std::cerr << message << std::endl;
    }
};

RenderEngine::RenderEngine(const std::filesystem::path& log) : mTerminal(std::make_unique<Terminal>())
{
    mLogs.createLog(log.string(), true, false, log.empty())->addListener(mTerminal.get());
    mRoot = std::make_unique<Root>();
}

RenderEngine::~RenderEngine() = default;

void RenderEngine::start()
{
    mRoot->loadPlugin(LODSMITH_OGRE_PLUGIN_DIR "/RenderSystem_GL");
    mRoot->loadPlugin(LODSMITH_OGRE_PLUGIN_DIR "/Codec_STBI");
    mRoot->setRenderSystem(mRoot->getAvailableRenderers().front());
    mRoot->initialise(false);
}

Result<Done> RenderEngine::startHidden()
{
    const char* const display = std::getenv("DISPLAY");
    if (!display || !*display)
        return noDisplay("and the environment variable DISPLAY names none");
    try {
        start();
        const Ogre::NameValuePairList hidden{{"hidden", "true"}};
        mRoot->createRenderWindow("Lodsmith", 1, 1, false, &hidden);
    } catch (const Ogre::Exception& exception) {
        return noDisplay("and there is none at " + std::string(display) + " (" + exception.getDescription() + ")");
    }
    return Done{};
}

Ogre::Root& RenderEngine::root()
{
    return *mRoot;
}

} // namespace lodsmith
