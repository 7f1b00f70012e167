#include "Editor.h"

#include <OgreLogManager.h>

namespace lodsmith::editor {

namespace {

// While nothing happens, frames are drawn for tooltips and carets only.
constexpr int kIdleMilliseconds = 100;
constexpr int kBusyMilliseconds = 5;

} // namespace

Editor::Editor(Window& window, Ogre::Root& root, Settings& settings, const Options& options)
    : mWindow(window), mRoot(root), mSettings(settings), mManager(mDefinitions, mQueue), mGui(window.target())
{
    (void)options;
}

int Editor::run()
{
    while (!mIsEnding) {
        handleEvents();
        drawFrame();
    }
    return 0;
}

void Editor::handleEvents()
{
    SDL_Event event;
    if (!SDL_WaitEventTimeout(&event, mQueue.queued() > 0 ? kBusyMilliseconds : kIdleMilliseconds))
        return;
    do
        handle(event);
    while (SDL_PollEvent(&event));
}

void Editor::handle(const SDL_Event& event)
{
    if (event.type == SDL_QUIT) {
        mIsEnding = true;
        return;
    }
    if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
        mWindow.resized();
        mGui.resized(event.window.data1, event.window.data2);
    }
    mGui.handle(event);
}

void Editor::drawFrame()
{
    const auto now = Clock::now();
    mGui.advance(std::chrono::duration<double>(now - mLastFrame).count());
    mLastFrame = now;
    mRoot.renderOneFrame();
}

} // namespace lodsmith::editor
