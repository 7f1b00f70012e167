#pragma once

#include "Settings.h"

#include <lodsmith/core/Result.h>

#include <OgreRenderWindow.h>
#include <OgreRoot.h>
#include <SDL.h>

#include <filesystem>
#include <memory>
#include <string>

namespace lodsmith::editor {

/// The window on the screen: SDL's, which brings mouse and keyboard, with OGRE drawing into it.
class Window {
public:
    static constexpr int kMinWidth = 1024;
    static constexpr int kMinHeight = 768;

    /// Errors: Unsupported when there is no display, or one without OpenGL.
    /// @param place where it was before; what is off the screen or too small is put right
    static Result<std::unique_ptr<Window>> open(const std::optional<WindowPlace>& place);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Lets OGRE draw into it, once, before anything below.
    void attach(Ogre::Root& root);
    Ogre::RenderWindow& target() { return *mTarget; }

    /// To be called when SDL says that it has another size.
    void resized();
    WindowPlace place() const;

    /// Writes what it shows, the kind of picture by the file's extension. Errors: Io.
    Result<Done> screenshot(const std::filesystem::path& file);

private:
    explicit Window(SDL_Window* window) : mWindow(window) {}

    SDL_Window* mWindow;
    Ogre::RenderWindow* mTarget = nullptr;
    Ogre::SceneManager* mBackground = nullptr; ///< an empty scene, whose viewport clears the window
    mutable WindowPlace mRestored;             ///< the last one that was not maximised
};

} // namespace lodsmith::editor
