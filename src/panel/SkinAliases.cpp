#include "SkinAliases.h"

#include <CEGUI/WindowFactoryManager.h>

namespace lodsmith {

namespace {

const char* const kWidgets[] = {
    "Button",      "Checkbox",       "Combobox", "Editbox",           "FrameWindow",     "HorizontalScrollbar",
    "ImageButton", "ItemListbox",    "Label",    "Listbox",           "MultiColumnList", "ProgressBar",
    "RadioButton", "ScrollablePane", "Slider",   "StaticImage",       "StaticText",      "TabControl",
    "TabButton",   "TabContentPane", "Tooltip",  "VerticalScrollbar",
};

bool exists(const std::string& type)
{
    return CEGUI::WindowFactoryManager::getSingleton().isFactoryPresent(type);
}

/// As CEGUI names the types of widgets.
std::string typeIn(const std::string& skin, const std::string& widget)
{
    return skin + "/" + widget;
}

} // namespace

Result<Done> nameWidgetsFor(const std::string& skin)
{
    if (!exists(typeIn(skin, "Button")))
        return Error{ErrorCode::NotFound, "CEGUI has no skin \"" + skin + "\": its scheme is to be loaded first"};
    auto& factories = CEGUI::WindowFactoryManager::getSingleton();
    for (const char* widget : kWidgets) {
        const std::string name = typeIn("Lodsmith", widget), target = typeIn(skin, widget);
        if (exists(target) && factories.getDereferencedAliasType(name) != target)
            factories.addWindowTypeAlias(name, target);
    }
    return Done{};
}

} // namespace lodsmith
