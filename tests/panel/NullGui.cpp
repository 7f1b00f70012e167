#include "NullGui.h"

#include <CEGUI/CEGUI.h>
#include <CEGUI/RendererModules/Null/Renderer.h>

namespace lodsmith::test {

NullGui::NullGui() : mRenderer(CEGUI::NullRenderer::create())
{
    mRenderer.setDisplaySize(CEGUI::Sizef(1280, 1024));
    CEGUI::System::setDefaultImageCodecName("FreeImageImageCodec");
    CEGUI::System::create(mRenderer, &mFiles, nullptr, nullptr, nullptr, "",
                          (mDirectory.path() / "CEGUI.log").string());
    for (const char* group : {"schemes", "imagesets", "fonts", "looknfeel", "layouts"})
        mFiles.setResourceGroupDirectory(group, LODSMITH_CEGUI_DATA_DIR "/" + CEGUI::String(group));
    CEGUI::Scheme::setDefaultResourceGroup("schemes");
    CEGUI::ImageManager::setImagesetDefaultResourceGroup("imagesets");
    CEGUI::Font::setDefaultResourceGroup("fonts");
    CEGUI::WidgetLookManager::setDefaultResourceGroup("looknfeel");
    CEGUI::WindowManager::setDefaultResourceGroup("layouts");
    CEGUI::SchemeManager::getSingleton().createFromFile("TaharezLook.scheme");
}

NullGui::~NullGui()
{
    CEGUI::System::destroy();
    CEGUI::NullRenderer::destroy(mRenderer);
}

} // namespace lodsmith::test
