#include "Editor.h"

#include "EditorHandle.h"

#include <OgreLogManager.h>

#include <exception>
#include <iostream>
#include <utility>

namespace fs = std::filesystem;

namespace lodsmith::editor {

namespace {

// While nothing happens, time passes for tooltips and carets only.
constexpr int kIdleMilliseconds = 100;
constexpr int kBusyMilliseconds = 2;
// What changes by itself, as the bar of progress, is drawn no more often than that.
constexpr double kSecondsBetweenFrames = 0.1;

constexpr int kScriptFailed = 1;

double secondsBetween(std::chrono::steady_clock::time_point start, std::chrono::steady_clock::time_point end)
{
    return std::chrono::duration<double>(end - start).count();
}

LodPolicy editorPolicy()
{
    LodPolicy policy;
    // The panel says what a mesh gets, small ones too; hand-made levels reach the entity of the preview.
    policy.minTriangles = 0;
    policy.replaceLevels = true;
    policy.reinitialiseEntities = true;
    return policy;
}

/// The first free name of "lodsmith-1.png", "lodsmith-2.png"... in the working directory.
fs::path screenshotFile()
{
    std::error_code ignored;
    for (int number = 1;; ++number)
        if (fs::path file = "lodsmith-" + std::to_string(number) + ".png"; !fs::exists(file, ignored))
            return fs::absolute(file, ignored);
}

} // namespace

Editor::Editor(Ogre::Root& root, Window& window, Settings& settings, MeshProbe& probe)
    : mRoot(root), mWindow(window), mSettings(settings), mProbe(probe),
      mControl(std::make_shared<Control>(Control{window, settings, {}, false, 0})),
      mManager(mDefinitions, mQueue, editorPolicy()), mGui(window.target())
{
}

Result<Done> Editor::open(const Options& options)
{
    if (auto opened = openPanel(); !opened)
        return opened;
    for (const fs::path& path : options.paths)
        runInPanel("lodsmith.panel:open(...)", path.string());
    if (options.script.empty())
        return Done{};
    auto script = Script::load(mGui.lua(), options.script);
    if (!script)
        return script.error();
    mScript = std::move(script).value();
    return Done{};
}

Result<Done> Editor::openPanel()
{
    PanelHost host{mGui.lua(), &mGui.root(), mDefinitions, mManager, mQueue, Gui::kSkin};
    host.fillsParent = true;
    host.canOpen = true;
    host.check = [this](const std::string& file) { return mProbe.check(file); };
    host.recentFiles = [this] { return mSettings.recentFiles; };
    host.opened = [this](const std::string& file) { mSettings.addRecentFile(file); };
    auto panel = AssetsManagerPanel::open(host);
    if (!panel)
        return panel.error();
    mPanel = std::move(panel).value();
    return shareEditor(mGui.lua(), mControl);
}

int Editor::run()
{
    while (!mControl->isEnding) {
        const bool hadEvents = handleEvents();
        resumeScript();
        frame(hadEvents);
    }
    return mControl->status;
}

bool Editor::handleEvents()
{
    SDL_Event event;
    const bool happened = SDL_WaitEventTimeout(&event, isBusy() ? kBusyMilliseconds : kIdleMilliseconds) != 0;
    mAwake = Clock::now();
    if (!happened)
        return false;
    do
        handle(event);
    while (SDL_PollEvent(&event));
    return true;
}

bool Editor::isBusy() const
{
    return mScript || mQueue.queued() > 0 || mPanel->isBusy();
}

void Editor::handle(const SDL_Event& event)
{
    const SDL_Keycode key = event.type == SDL_KEYDOWN ? event.key.keysym.sym : SDL_Keycode(SDLK_UNKNOWN);
    if (event.type == SDL_QUIT || (key == SDLK_q && (event.key.keysym.mod & KMOD_CTRL)))
        return leave();
    if (event.type == SDL_DROPFILE) {
        runInPanel("lodsmith.panel:open(...)", event.drop.file);
        SDL_free(event.drop.file);
        return;
    }
    if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
        mWindow.resized();
        mGui.resized(event.window.data1, event.window.data2);
    }
    if (key == SDLK_F12)
        return takeScreenshot();
    guard([&] { mGui.handle(event); });
}

void Editor::takeScreenshot()
{
    const fs::path file = screenshotFile();
    const auto taken = mWindow.screenshot(file);
    if (taken)
        runInPanel("lodsmith.panel.state:say('info', 'Screenshot: ' .. ...)", file.string());
    else
        tell(describe(taken.error()));
}

void Editor::resumeScript()
{
    if (!mScript)
        return;
    const auto more = mScript->resume();
    if (more && more.value())
        return;
    mScript.reset();
    if (!more) {
        std::cerr << describe(more.error()) << std::endl;
        mControl->isEnding = true;
        mControl->status = kScriptFailed;
    }
}

void Editor::frame(bool hadEvents)
{
    const bool hasPicture = work();
    const auto worked = Clock::now();
    const bool isDue = secondsBetween(mLastDrawn, worked) > kSecondsBetweenFrames;
    if (hadEvents || hasPicture || (isDue && mGui.hasChanged())) {
        guard([&] { mRoot._updateAllRenderTargets(); });
        mLastDrawn = worked;
    }
    mRoot._fireFrameEnded();
    mControl->lastFrame = {secondsBetween(mAwake, worked), secondsBetween(worked, Clock::now())};
}

bool Editor::work()
{
    const auto now = Clock::now();
    const double seconds = secondsBetween(mLastFrame, now);
    mLastFrame = now;
    guard([&] { mGui.advance(seconds); });
    // First the injector, so that this frame shows the levels that have come.
    guard([&] { mRoot._fireFrameStarted(); });
    return mPanel->update(float(seconds));
}

void Editor::leave()
{
    // A script may have closed the panel, and with it what could ask.
    if (!runInPanel("lodsmith.panel:askToLeave(function() lodsmith.editor:quit() end)"))
        mControl->isEnding = true;
}

bool Editor::runInPanel(const char* code, const std::string& argument)
{
    const auto done = runLua(mGui.lua(), code, argument);
    if (!done)
        tell(describe(done.error()));
    return done.ok();
}

template <class Work>
void Editor::guard(const Work& work)
{
    try {
        work();
    } catch (const std::exception& exception) { // CEGUI passes errors of handlers on
        if (std::exchange(mLastTrouble, exception.what()) != exception.what())
            tell(exception.what());
    }
}

void Editor::tell(const std::string& message)
{
    Ogre::LogManager::getSingleton().logError(message);
    if (!runLua(mGui.lua(), "lodsmith.panel.state:say('error', ...)", message))
        std::cerr << message << std::endl;
}

} // namespace lodsmith::editor
