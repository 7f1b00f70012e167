#include "Window.h"

#include <OgreCamera.h>
#include <OgreSceneManager.h>
#include <OgreViewport.h>

#include <SDL_syswm.h>

#include <algorithm>
#include <cstdlib>

namespace lodsmith::editor {

namespace {

constexpr int kUsualWidth = 1280;
constexpr int kUsualHeight = 960;
// No screen reaches as far; SDL's sums overflow beyond.
constexpr int kFarthest = 1 << 16;

Error unavailable(const std::string& what)
{
    return {ErrorCode::Unsupported, what + " (" + SDL_GetError() + ")"};
}

/// Whether so much of it is on one of the screens that it can be seen and moved.
bool isVisible(const WindowPlace& place)
{
    const SDL_Rect wanted{place.x, place.y, place.width, place.height};
    for (int display = 0; display < SDL_GetNumVideoDisplays(); ++display) {
        SDL_Rect bounds, seen;
        if (SDL_GetDisplayUsableBounds(display, &bounds) == 0 && SDL_IntersectRect(&bounds, &wanted, &seen)
            && seen.w >= place.width / 2 && seen.h >= place.height / 2)
            return true;
    }
    return false;
}

WindowPlace usualPlace()
{
    SDL_Rect screen{0, 0, kUsualWidth, kUsualHeight};
    SDL_GetDisplayUsableBounds(0, &screen);
    const int width = std::clamp(kUsualWidth, std::min(Window::kMinWidth, screen.w), screen.w);
    const int height = std::clamp(kUsualHeight, std::min(Window::kMinHeight, screen.h), screen.h);
    return {screen.x + (screen.w - width) / 2, screen.y + (screen.h - height) / 2, width, height, false};
}

WindowPlace startingPlace(const std::optional<WindowPlace>& before)
{
    if (before && std::abs(before->x) < kFarthest && std::abs(before->y) < kFarthest
        && std::max(before->width, before->height) < kFarthest && before->width >= Window::kMinWidth
        && before->height >= Window::kMinHeight && isVisible(*before))
        return *before;
    return usualPlace();
}

/// OGRE ends the process where there is no OpenGL. SDL says so.
bool hasOpenGl(SDL_Window* window)
{
    SDL_GLContext context = SDL_GL_CreateContext(window);
    if (context)
        SDL_GL_DeleteContext(context);
    return context != nullptr;
}

} // namespace

Result<std::unique_ptr<Window>> Window::open(const std::optional<WindowPlace>& before)
{
    // OGRE's windows on Linux are those of X.
    SDL_SetHint(SDL_HINT_VIDEODRIVER, "x11");
    // Ctrl+C at the terminal ends the program at once, also while a script runs in circles; a question would keep it.
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (SDL_Init(SDL_INIT_VIDEO) != 0)
        return unavailable("there is no X display to open a window on; is DISPLAY set?");
    const WindowPlace place = startingPlace(before);
    SDL_Window* const sdlWindow = SDL_CreateWindow("Lodsmith", place.x, place.y, place.width, place.height,
                                                   SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE
                                                       | (place.maximised ? Uint32(SDL_WINDOW_MAXIMIZED) : 0U));
    if (!sdlWindow || !hasOpenGl(sdlWindow)) {
        Error error = unavailable("the display has no OpenGL");
        if (sdlWindow)
            SDL_DestroyWindow(sdlWindow);
        SDL_Quit();
        return error;
    }
    SDL_SetWindowMinimumSize(sdlWindow, std::min(kMinWidth, place.width), std::min(kMinHeight, place.height));
    std::unique_ptr<Window> window(new Window(sdlWindow));
    window->mRestored = place;
    return window;
}

Window::~Window()
{
    if (mTarget) {
        Ogre::Root& root = Ogre::Root::getSingleton();
        mTarget->removeAllViewports();
        root.destroySceneManager(mBackground);
        root.destroyRenderTarget(mTarget);
    }
    SDL_DestroyWindow(mWindow);
    SDL_Quit();
}

void Window::attach(Ogre::Root& root)
{
    SDL_SysWMinfo info;
    SDL_VERSION(&info.version);
    SDL_GetWindowWMInfo(mWindow, &info);
    int width = 0, height = 0;
    SDL_GetWindowSize(mWindow, &width, &height);
    const Ogre::NameValuePairList parameters{{"externalWindowHandle", std::to_string(info.info.x11.window)}};
    mTarget = root.createRenderWindow("Lodsmith", unsigned(width), unsigned(height), false, &parameters);
    mBackground = root.createSceneManager();
    mTarget->addViewport(mBackground->createCamera("background"));
}

void Window::resized()
{
    mTarget->windowMovedOrResized();
}

WindowPlace Window::place() const
{
    const bool maximised = SDL_GetWindowFlags(mWindow) & SDL_WINDOW_MAXIMIZED;
    if (!maximised) {
        SDL_GetWindowPosition(mWindow, &mRestored.x, &mRestored.y);
        SDL_GetWindowSize(mWindow, &mRestored.width, &mRestored.height);
    }
    mRestored.maximised = maximised;
    return mRestored;
}

Result<Done> Window::screenshot(const std::filesystem::path& file)
{
    try {
        mTarget->writeContentsToFile(file.string());
        // OGRE does not notice a full disk.
        std::error_code error;
        if (std::filesystem::file_size(file, error) == 0 || error)
            return Error{ErrorCode::Io, "could not be written", file.string()};
        return Done{};
    } catch (const Ogre::Exception& exception) {
        return Error{ErrorCode::Io, exception.getDescription(), file.string()};
    }
}

} // namespace lodsmith::editor
