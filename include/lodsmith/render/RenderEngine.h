#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <OgreLogManager.h>
#include <OgreRoot.h>

#include <filesystem>
#include <memory>

namespace lodsmith {

/// OGRE with the render system RenderSystem_GL, whose fixed functions draw without shaders, for as long as the object
/// lives. One at a time. It has to outlive what it throws: the types of many exceptions are in plugins, which it
/// unloads.
class LODSMITH_API RenderEngine {
public:
    /// @param log file for all messages; empty for none. Warnings and errors go to standard error too.
    explicit RenderEngine(const std::filesystem::path& log);
    ~RenderEngine();
    RenderEngine(const RenderEngine&) = delete;
    RenderEngine& operator=(const RenderEngine&) = delete;

    /// Loads the plugins and starts the render system, which makes its window later. Throws Ogre::Exception.
    void start();

    /// start(), and a window that nobody sees, for pictures in memory. Error: Unsupported without an X display. OGRE
    /// ends the process where there is a display without OpenGL.
    Result<Done> startHidden();

    Ogre::Root& root();

private:
    class Root;
    class Terminal;

    std::unique_ptr<Ogre::LogListener> mTerminal;
    Ogre::LogManager mLogs;
    std::unique_ptr<Root> mRoot;
};

} // namespace lodsmith
