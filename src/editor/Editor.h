#pragma once

#include "Control.h"
#include "Gui.h"
#include "MeshProbe.h"
#include "Options.h"
#include "Script.h"

#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/LodManager.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>
#include <lodsmith/panel/AssetsManagerPanel.h>

#include <OgreRoot.h>

#include <chrono>
#include <memory>
#include <string>

namespace lodsmith::editor {

/// The program between its first frame and its last: the panel in the window, what it works on, and the script.
class Editor {
public:
    /// Throws what OGRE and CEGUI throw. The four live longer than the editor.
    Editor(Ogre::Root& root, Window& window, Settings& settings, MeshProbe& probe);

    /// Opens the panel, the files and the script. Errors: those of AssetsManagerPanel::open() and Script::load(). Files that
    /// cannot be opened are told in the panel.
    Result<Done> open(const Options& options);
    /// Draws frames until the user, or the script, ends it. The program's exit status.
    int run();

private:
    using Clock = std::chrono::steady_clock;

    Result<Done> openPanel();
    /// Runs Lua with a string as its argument. False when something went wrong, which is shown in the panel.
    bool runInPanel(const char* code, const std::string& argument = {});
    /// Asks about unsaved changes first.
    void leave();
    /// Sleeps while nothing happens, then passes on what the user did. False when that was nothing.
    bool handleEvents();
    void handle(const SDL_Event& event);
    void takeScreenshot();
    void resumeScript();
    /// Draws where something has changed: in software, drawing takes the time that generation needs.
    void frame(bool hadEvents);
    /// All but drawing. Whether the preview has another picture.
    bool work();
    bool isBusy() const;
    /// Runs it; what it throws is told, once although it may come with every frame.
    template <class Work>
    void guard(const Work& work);
    void tell(const std::string& message);

    Ogre::Root& mRoot;
    Window& mWindow;
    Settings& mSettings;
    MeshProbe& mProbe;
    std::shared_ptr<Control> mControl;
    LodDefinitionManager mDefinitions;
    QueuedProgressiveMeshGenerator mQueue;
    LodManager mManager;
    Gui mGui;
    std::unique_ptr<AssetsManagerPanel> mPanel;
    std::unique_ptr<Script> mScript;
    Clock::time_point mLastFrame = Clock::now();
    Clock::time_point mLastDrawn;
    Clock::time_point mAwake; ///< when there was something to do, or time had passed
    std::string mLastTrouble;
};

} // namespace lodsmith::editor
