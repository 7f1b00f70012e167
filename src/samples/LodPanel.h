#pragma once

#include "LibraryLods.h"

#include <lodsmith/panel/AssetsManagerPanel.h>

#include <memory>
#include <string>

namespace lodsmith::samples {

/// Lodsmith's panel as a window over the game.
class LodPanel {
public:
    /// What it is given belongs to the game and lives longer.
    LodPanel(lua_State& lua, CEGUI::Window& parent, const std::string& skin, LibraryLods& lods);

    /// Why it did not open goes to OGRE's log.
    void open();
    bool isOpen() const { return mPanel != nullptr; }
    /// Asks the artist first when there are changes that are not saved. Whether it is closed now.
    bool close();
    /// Once a frame, before it is drawn.
    void update(float seconds);

private:
    lua_State& mLua;
    CEGUI::Window& mParent;
    std::string mSkin;
    LibraryLods& mLods;
    std::unique_ptr<lodsmith::AssetsManagerPanel> mPanel;
};

} // namespace lodsmith::samples
