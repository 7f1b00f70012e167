#include <lodsmith/panel/AssetsManagerPanel.h>

#include "CeguiPreview.h"
#include "LayoutLocation.h"
#include "PanelScript.h"
#include "SkinAliases.h"

#include <lodsmith/lua/LuaBindings.h>
#include <lodsmith/ogre/LevelAnalyser.h>

#include <CEGUI/GUIContext.h>
#include <CEGUI/RendererModules/Ogre/Renderer.h>
#include <CEGUI/System.h>

#include <OgreLogManager.h>

#include <exception>
#include <utility>

namespace lodsmith {

struct AssetsManagerPanel::Parts {
    explicit Parts(const PanelHost& host) : services(host.lua, host.definitions, host.manager, host.queue) {}

    void report(const Error& error);

    LuaServices services;
    std::shared_ptr<CeguiPreview> preview;
    std::unique_ptr<PanelScript> script;
    std::string lastError;
};

namespace {

std::filesystem::path directoryOf(const PanelHost& host)
{
    return host.directory.empty() ? guiDirectory() : host.directory;
}

/// Errors: what the host lacks.
Result<Done> prepare(const PanelHost& host)
{
    if (!host.lua)
        return Error{ErrorCode::InvalidSetting, "the panel needs a Lua state"};
    if (!CEGUI::System::getSingletonPtr())
        return Error{ErrorCode::NotFound, "CEGUI does not run"};
    if (!host.parent && !CEGUI::System::getSingleton().getDefaultGUIContext().getRootWindow())
        return Error{ErrorCode::NotFound, "there is no window to put the panel into"};
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(directoryOf(host) / "AssetsManager.lua", ignored))
        return Error{ErrorCode::NotFound, "the panel's scripts are not there", directoryOf(host).string()};
    for (const auto& checked : {LayoutLocation::check(), PanelScript::check(host.lua)})
        if (!checked)
            return checked;
    return nameWidgetsFor(host.skin);
}

bool hasOgreRenderer()
{
    return dynamic_cast<CEGUI::OgreRenderer*>(CEGUI::System::getSingleton().getRenderer()) != nullptr;
}

void log(const std::string& message)
{
    if (auto* logs = Ogre::LogManager::getSingletonPtr(); logs && logs->getDefaultLog())
        logs->logError("Lodsmith's panel: " + message);
}

/// Runs `work`; what is thrown becomes an error.
template <class Work>
auto catching(const Work& work) -> decltype(work())
{
    try {
        return work();
    } catch (const std::exception& exception) { // Ogre::Exception and CEGUI::Exception too
        return Error{ErrorCode::Unsupported, exception.what()};
    }
}

} // namespace

/// Once, although it may come with every frame.
void AssetsManagerPanel::Parts::report(const Error& error)
{
    const std::string message = describe(error);
    if (std::exchange(lastError, message) == message)
        return;
    log(message);
    script->tell(message);
}

Result<std::unique_ptr<AssetsManagerPanel>> AssetsManagerPanel::open(const PanelHost& host)
{
    return catching([&]() -> Result<std::unique_ptr<AssetsManagerPanel>> {
        if (const auto prepared = prepare(host); !prepared)
            return prepared.error();
        auto parts = std::make_unique<Parts>(host);
        if (hasOgreRenderer() && MeshPreview::isPossible())
            parts->preview = std::make_shared<CeguiPreview>(parts->services.analyser());
        const std::filesystem::path directory = directoryOf(host);
        const LayoutLocation layouts(directory);
        auto script = PanelScript::open(host, directory.string(), parts->preview);
        if (!script)
            return script.error();
        parts->script = std::move(script).value();
        return std::unique_ptr<AssetsManagerPanel>(new AssetsManagerPanel(std::move(parts)));
    });
}

AssetsManagerPanel::AssetsManagerPanel(std::unique_ptr<Parts> parts) : mParts(std::move(parts)) {}

AssetsManagerPanel::~AssetsManagerPanel() = default;

bool AssetsManagerPanel::update(float seconds)
{
    const Result<Done> updated = mParts->script->update(static_cast<double>(seconds));
    if (!updated)
        mParts->report(updated.error());
    if (!mParts->preview)
        return false;
    const Result<bool> drawn = catching([&] { return mParts->preview->preview.update(seconds); });
    if (!drawn)
        mParts->report(drawn.error());
    return drawn && drawn.value();
}

bool AssetsManagerPanel::isOpen() const
{
    return mParts->script->isOpen();
}

bool AssetsManagerPanel::isBusy() const
{
    return !mParts->services.analyser().isIdle() || (mParts->preview && mParts->preview->preview.isMoving());
}

MeshPreview* AssetsManagerPanel::preview()
{
    return mParts->preview ? &mParts->preview->preview : nullptr;
}

} // namespace lodsmith
