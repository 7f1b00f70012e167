#pragma once

#include <OgreLogManager.h>
#include <OgreRoot.h>

#include <filesystem>
#include <memory>

namespace lodsmith::editor {

/// OGRE with the render system RenderSystem_GL, which is the one that CEGUI 0.8 draws with. It has to outlive what it throws:
/// the types of many exceptions are in plugins, which it unloads.
class Engine {
public:
    /// @param log file for all messages; empty for none. Warnings and errors go to the terminal too.
    explicit Engine(const std::filesystem::path& log);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Loads the plugins and starts the render system. Throws Ogre::Exception.
    void start();

    Ogre::Root& root();

private:
    class Root;
    class Terminal;

    std::unique_ptr<Ogre::LogListener> mTerminal;
    Ogre::LogManager mLogs;
    std::unique_ptr<Root> mRoot;
};

} // namespace lodsmith::editor
