#include "GuiSession.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
#include <CEGUI/CEGUI.h>
#pragma GCC diagnostic pop

#include <gtest/gtest.h>

#include <filesystem>

namespace lodsmith::test {
namespace {

class LayoutsInSkin : public testing::TestWithParam<std::string> {};

TEST_P(LayoutsInSkin, load)
{
    const GuiSession session(GetParam());
    int loaded = 0;
    for (const auto& entry : std::filesystem::directory_iterator(LODSMITH_GUI_LAYOUTS)) {
        if (entry.path().extension() != ".layout") {
            continue;
        }
        const std::string name = entry.path().filename().string();
        CEGUI::Window* window = nullptr;
        ASSERT_NO_THROW(window = CEGUI::WindowManager::getSingleton().loadLayoutFromFile(name)) << name;
        EXPECT_EQ(window->getName(), entry.path().stem().string().c_str());
        ++loaded;
    }
    EXPECT_GT(loaded, 5);
    EXPECT_TRUE(session.errors().empty()) << session.errors().front();
}

INSTANTIATE_TEST_SUITE_P(All, LayoutsInSkin, testing::ValuesIn(skins()), [](const auto& info) { return info.param; });

} // namespace
} // namespace lodsmith::test
