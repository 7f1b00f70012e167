#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct lua_State;

namespace CEGUI {
class Window;
} // namespace CEGUI

namespace lodsmith {

class LodDefinitionManager;
class LodManager;
class MeshPreview;
class QueuedProgressiveMeshGenerator;

/// Where the panel opens, and what it works on.
struct PanelHost {
    /// Lua 5.1, in which CEGUI's Lua script module is open: CEGUI::LuaScriptModule::create(state), and
    /// CEGUI::System::setScriptingModule().
    lua_State* lua = nullptr;
    /// The window that the panel is put into; null for the root window of CEGUI's default context, which must have one then.
    CEGUI::Window* parent = nullptr;
    LodDefinitionManager& definitions;
    LodManager& manager;
    QueuedProgressiveMeshGenerator& queue;
    /// One of CEGUI's skins, whose scheme has been loaded: the panel's widgets are of its types ("TaharezLook/Button").
    std::string skin = "TaharezLook";
    /// Where the panel's layouts and scripts are; empty for guiDirectory().
    std::filesystem::path directory = {};
    /// The panel fills the parent; off: it is a window in it that can be moved and closed.
    bool fillsParent = false;
    /// Artists may open files; off: they choose among the meshes that OGRE knows.
    bool canOpen = false;
    /// Paths of files opened lately, the last first; may be empty.
    std::function<std::vector<std::string>()> recentFiles = {};
    /// Asked before a mesh file is loaded, by its path, whether it may be; empty: all may. OGRE ends the process over some broken files.
    std::function<Result<Done>(const std::string&)> check = {};
    /// Told the path of each file that was opened; may be empty.
    std::function<void(const std::string&)> opened = {};
};

/// Where the layouts and scripts of the panel are: the environment variable LODSMITH_GUI_DIR, else beside the installed library
/// (share/lodsmith/gui-layouts), else in the source tree it was built from.
LODSMITH_API std::filesystem::path guiDirectory();

/// The assets manager's panel for levels of detail, in the CEGUI and the Lua state of any program:
///
///     auto panel = lodsmith::AssetsManagerPanel::open({state, window, definitions, manager, queue, "TaharezLook"});
///     if (!panel) log(describe(panel.error()));
///     // ... and once a frame, before CEGUI draws:
///     panel.value()->update(seconds);
///
/// It opens the Lua bindings, shares the services with scripts (LuaServices), and runs AssetsManager.lua. There is a preview where
/// MeshPreview::isPossible() and CEGUI draws with OgreRenderer. What CEGUI throws in functions that Lua calls becomes an error of
/// Lua's in that state from then on. No exception comes out of it, and errors in scripts are shown in
/// the panel and go to CEGUI's log, and those of the preview to OGRE's.
///
/// One at a time in a Lua state. Everything in PanelHost lives longer than it does. Main thread only.
class LODSMITH_API AssetsManagerPanel {
public:
    /// Errors: InvalidSetting for a host without Lua, NotFound for what is missing (CEGUI, its script module, the skin, the
    /// directory), BadFile for an error in the scripts, with OGRE's and CEGUI's words for it.
    static Result<std::unique_ptr<AssetsManagerPanel>> open(const PanelHost& host);
    /// Closes it; unsaved changes are lost. Also when the artist has closed it.
    ~AssetsManagerPanel();
    AssetsManagerPanel(const AssetsManagerPanel&) = delete;
    AssetsManagerPanel& operator=(const AssetsManagerPanel&) = delete;

    /// Returns whether the preview has another picture, which CEGUI does not know of: for programs that draw only when
    /// something has changed.
    /// @param seconds since the last call
    bool update(float seconds);
    /// False once the artist has closed it.
    bool isOpen() const;
    /// Whether something goes on that wants frames: an animation plays, or figures are on their way. For programs that draw
    /// only when something happens; the queue knows about generation.
    bool isBusy() const;
    /// Null when there is none.
    MeshPreview* preview();

private:
    struct Parts;
    explicit AssetsManagerPanel(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> mParts;
};

} // namespace lodsmith
