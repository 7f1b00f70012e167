#pragma once

#include <lodsmith/core/Result.h>
#include <lodsmith/panel/AssetsManagerPanel.h>

#include <memory>
#include <string>

struct lua_State;

namespace lodsmith {

struct CeguiPreview;

/// The panel's side in Lua: AssetsManager.lua and the table that its open() returns. What is thrown or raised in there ends here.
class PanelScript {
public:
    /// Whether the state has CEGUI's script module, and no open panel. Errors: NotFound.
    static Result<Done> check(lua_State* state);

    /// Errors: BadFile.
    /// @param preview null for none
    static Result<std::unique_ptr<PanelScript>> open(const PanelHost& host, const std::string& directory,
                                                     const std::shared_ptr<CeguiPreview>& preview);
    /// Calls the panel's close().
    ~PanelScript();
    PanelScript(const PanelScript&) = delete;
    PanelScript& operator=(const PanelScript&) = delete;

    /// Calls the panel's update(). Errors: BadFile.
    Result<Done> update(double seconds);
    /// Whether the panel still has its window.
    bool isOpen() const;

    /// Shows an error in the panel.
    void tell(const std::string& message);

private:
    PanelScript(const PanelHost& host, const std::shared_ptr<CeguiPreview>& preview);

    struct Opening;
    struct Update;
    struct Answer;
    static int openInLua(lua_State* state);
    static int closeInLua(lua_State* state);
    static int updateInLua(lua_State* state);
    static int isOpenInLua(lua_State* state);
    static int recentFilesForLua(lua_State* state);
    static int openedForLua(lua_State* state);
    static int checkForLua(lua_State* state);
    static void pushPanel(lua_State* state, void* script);
    static PanelScript* ofUpvalue(lua_State* state);
    void pushOptions();

    lua_State* mState;
    PanelHost mHost;
    std::shared_ptr<CeguiPreview> mPreview;
};

} // namespace lodsmith
