#pragma once

#include <OgreRenderWindow.h>
#include <OgreRoot.h>
#include <SDL.h>

namespace lodsmith::samples {

/// The game's window: SDL's, which brings mouse and keyboard. Made before OGRE and destroyed after it.
class GameWindow {
public:
    /// Throws std::runtime_error when there is no display, or one without OpenGL, for which OGRE would end the process.
    GameWindow(unsigned width, unsigned height);
    ~GameWindow();
    GameWindow(const GameWindow&) = delete;
    GameWindow& operator=(const GameWindow&) = delete;

    /// Lets OGRE draw into it, once. The target is OGRE's.
    Ogre::RenderWindow& attach(Ogre::Root& root);

private:
    SDL_Window* mWindow = nullptr;
};

} // namespace lodsmith::samples
