#include "GameWindow.h"

#include <SDL_syswm.h>

#include <stdexcept>

namespace lodsmith::samples {

namespace {

bool hasOpenGl(SDL_Window* window)
{
    SDL_GLContext context = SDL_GL_CreateContext(window);
    if (context)
        SDL_GL_DeleteContext(context);
    return context != nullptr;
}

} // namespace

GameWindow::GameWindow(unsigned width, unsigned height)
{
    // OGRE's windows on Linux are those of X.
    SDL_SetHint(SDL_HINT_VIDEODRIVER, "x11");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (SDL_Init(SDL_INIT_VIDEO) == 0)
        mWindow = SDL_CreateWindow("A game with Lodsmith's panel", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                   int(width), int(height), SDL_WINDOW_OPENGL);
    if (mWindow && hasOpenGl(mWindow))
        return;
    const std::string reason = SDL_GetError();
    SDL_Quit();
    throw std::runtime_error("there is no X display with OpenGL to open a window on (" + reason + ")");
}

GameWindow::~GameWindow()
{
    SDL_DestroyWindow(mWindow);
    SDL_Quit();
}

Ogre::RenderWindow& GameWindow::attach(Ogre::Root& root)
{
    SDL_SysWMinfo info;
    SDL_VERSION(&info.version);
    SDL_GetWindowWMInfo(mWindow, &info);
    int width = 0, height = 0;
    SDL_GetWindowSize(mWindow, &width, &height);
    const Ogre::NameValuePairList parameters{{"externalWindowHandle", std::to_string(info.info.x11.window)}};
    return *root.createRenderWindow("game", unsigned(width), unsigned(height), false, &parameters);
}

} // namespace lodsmith::samples
