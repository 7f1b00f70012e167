#pragma once

#include "GameGui.h"
#include "LodPanel.h"
#include "Scene.h"
#include "Window.h"

#include <chrono>
#include <string>

namespace lodsmith::samples {

struct GameOptions {
    unsigned objects = 200;
    unsigned width = 1280; ///< pixels of the window
    unsigned height = 960;
    unsigned frames =
        0; ///< after which the program ends, and which make one round of the camera; 0: for ever, a round a minute
    bool opensPanel = false;
    std::string screenshot; ///< file for the picture of the last frame
};

/// A game that an artist can open the panel in: the valley, with figures in a corner. F1 opens and closes the panel, F2 halts the
/// camera.
class Game {
public:
    /// Throws what OGRE and CEGUI throw.
    Game(Engine& engine, Ogre::RenderWindow& window, const GameOptions& options);

    /// Draws frames until the player, or the number of frames, ends it.
    void run();
    /// Passes on what mouse and keyboard did, and draws. False once it is to end.
    bool drawFrame();

    LodPanel& panel() { return mPanel; }
    GameGui& gui() { return mGui; }

private:
    using Clock = std::chrono::steady_clock;

    void handle(const SDL_Event& event);
    void handleKey(SDL_Keycode key);

    Ogre::Root& mRoot;
    Ogre::RenderWindow& mWindow;
    GameOptions mOptions;
    LibraryLods mLods;
    Scene mScene;
    GameGui mGui;
    LodPanel mPanel;
    Clock::time_point mLastFrame = Clock::now();
    double mRound = 0;        ///< where the camera is on its way
    double mSinceFigures = 0; ///< seconds
    bool mIsHalted = false;
    bool mIsEnding = false;
};

} // namespace lodsmith::samples
