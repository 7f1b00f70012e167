#include "SkinAliases.h"

#include <CEGUI/WindowFactoryManager.h>

namespace lodsmith {

namespace {

const char* const kWidgets[] = {
    "Button",       "Checkbox",    "Combobox",        "Editbox",        "FrameWindow",   "HorizontalScrollbar",
    "ImageButton",  "ItemListbox", "Label",           "Listbox",        "MultiColumnList", "ProgressBar",
    "RadioButton",  "ScrollablePane", "Slider",       "StaticImage",    "StaticText",    "TabControl",
    "TabButton",    "TabContentPane", "Tooltip",      "VerticalScrollbar",
};

bool exists(const std::string& type)
{
    return CEGUI::WindowFactoryManager::getSingleton().isFactoryPresent(type);
}

} // namespace

Result<Done> nameWidgetsFor(const std::string& skin)
{
    if (!exists(skin + "/Button"))
        return Error{ErrorCode::NotFound, "CEGUI has no skin \"" + skin + "\": its scheme is to be loaded first"};
    auto& factories = CEGUI::WindowFactoryManager::getSingleton();
    for (const std::string widget : kWidgets) {
        const std::string name = "Lodsmith/" + widget, target = skin + "/" + widget;
        if (exists(target) && factories.getDereferencedAliasType(name) != target)
            factories.addWindowTypeAlias(name, target);
    }
    return Done{};
}

} // namespace lodsmith
