#include "Game.h"

#include <cmath>

namespace lodsmith::samples {

namespace {

constexpr double kRoundSeconds = 60;
constexpr double kFiguresSeconds = 0.5;

} // namespace

Game::Game(Engine& engine, Ogre::RenderWindow& window, const GameOptions& options)
    : mRoot(engine.root()), mWindow(window), mOptions(options), mScene(engine, window, options.objects), mGui(window),
      mPanel(mGui.lua(), mGui.root(), GameGui::kSkin, mLods)
{
    if (options.opensPanel)
        mPanel.open();
}

void Game::run()
{
    for (unsigned frame = 0; mOptions.frames == 0 || frame < mOptions.frames; ++frame)
        if (!drawFrame())
            return;
    if (!mOptions.screenshot.empty())
        mWindow.writeContentsToFile(mOptions.screenshot);
}

bool Game::drawFrame()
{
    for (SDL_Event event; SDL_PollEvent(&event);)
        handle(event);
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - mLastFrame).count();
    mLastFrame = now;
    if (!mIsHalted)
        mRound += mOptions.frames ? 1.0 / mOptions.frames : seconds / kRoundSeconds;
    mScene.update(mRound - std::floor(mRound), seconds);
    if (mSinceFigures += seconds; mSinceFigures >= kFiguresSeconds) {
        mSinceFigures = 0;
        mGui.showFigures(mWindow.getStatistics().lastFPS, mWindow.getStatistics().triangleCount);
    }
    mGui.advance(float(seconds));
    mPanel.update(float(seconds));
    return mRoot.renderOneFrame() && !mIsEnding;
}

void Game::handle(const SDL_Event& event)
{
    if (event.type == SDL_QUIT)
        mIsEnding = mPanel.close();
    else if (event.type == SDL_KEYDOWN && event.key.repeat == 0)
        handleKey(event.key.keysym.sym);
    mGui.handle(event);
}

void Game::handleKey(SDL_Keycode key)
{
    if (key == SDLK_F2)
        mIsHalted = !mIsHalted;
    if (key != SDLK_F1)
        return;
    if (mPanel.isOpen())
        mPanel.close();
    else
        mPanel.open();
}

} // namespace lodsmith::samples
