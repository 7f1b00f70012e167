#include "LodPanel.h"

#include <CEGUI/FontManager.h>
#include <CEGUI/System.h>
#include <OgreLogManager.h>

#include <utility>

namespace lodsmith::samples {

LodPanel::LodPanel(lua_State& lua, CEGUI::Window& parent, const std::string& skin, LibraryLods& lods)
    : mLua(lua), mParent(parent), mSkin(skin), mLods(lods)
{
    // The panel's sizes are made for this font, not for the game's.
    CEGUI::FontManager::getSingleton().createFromFile("DejaVuSans-10-NoScale.font");
    // Hand-made levels that an artist chooses are to reach the entities of the game, which expects that.
    lodsmith::LodPolicy policy = mLods.manager.policy();
    policy.reinitialiseEntities = true;
    mLods.manager.setPolicy(policy);
}

void LodPanel::open()
{
    auto panel =
        lodsmith::AssetsManagerPanel::open({&mLua, &mParent, mLods.definitions, mLods.manager, mLods.queue, mSkin});
    if (panel)
        mPanel = std::move(panel).value();
    else
        Ogre::LogManager::getSingleton().logError(describe(panel.error()));
}

void LodPanel::update(float seconds)
{
    if (mPanel)
        mPanel->update(seconds);
    if (mPanel && !mPanel->isOpen()) // the artist has closed it
        mPanel.reset();
}

bool LodPanel::close()
{
    if (mPanel)
        CEGUI::System::getSingleton().executeScriptString(
            "lodsmith.panel:askToLeave(function() lodsmith.panel:close() end)");
    if (mPanel && !mPanel->isOpen())
        mPanel.reset();
    return !mPanel;
}

} // namespace lodsmith::samples
