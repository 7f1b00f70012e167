#include "NullGui.h"

#include <lodsmith/panel/Graph.h>

#include <CEGUI/BasicImage.h>
#include <CEGUI/ImageManager.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace lodsmith::test {
namespace {

CEGUI::Sizef sizeOf(const std::string& image)
{
    return CEGUI::ImageManager::getSingleton().get(image).getRenderedSize();
}

std::unique_ptr<Graph> makeGraph(const std::string& name)
{
    auto graph = Graph::create(name);
    EXPECT_TRUE(graph) << describe(graph.error());
    return std::move(graph).value();
}

TEST(GraphTest, IsAnImageOfItsSize)
{
    const NullGui gui;
    const auto graph = makeGraph("test/graph");
    EXPECT_EQ(graph->image(), "test/graph");
    graph->resize(200, 90);
    ASSERT_TRUE(graph->draw());
    EXPECT_EQ(sizeOf("test/graph"), CEGUI::Sizef(200, 90));
    graph->resize(300, 50);
    ASSERT_TRUE(graph->draw());
    EXPECT_EQ(sizeOf("test/graph"), CEGUI::Sizef(300, 50));
}

TEST(GraphTest, NoSizeAndHugeOnesAreLimited)
{
    const NullGui gui;
    const auto graph = makeGraph("test/graph");
    graph->resize(0, 0);
    ASSERT_TRUE(graph->draw());
    EXPECT_EQ(sizeOf("test/graph"), CEGUI::Sizef(1, 1));
    graph->resize(4000000000u, 1);
    ASSERT_TRUE(graph->draw());
    EXPECT_EQ(sizeOf("test/graph"), CEGUI::Sizef(4096, 1));
}

TEST(GraphTest, PointsThatAreNoNumbersAreLeftOut)
{
    const NullGui gui;
    const auto graph = makeGraph("test/graph");
    graph->resize(64, 64);
    graph->setCurve({{0, 0}, {std::nanf(""), 0.5f}, {INFINITY, 1}, {-1e30f, 1e30f}, {1, 1}});
    graph->setMarkers({{{std::nanf(""), 0}, true}, {{0.5f, 0.5f}, true}});
    graph->setTicks({std::nanf(""), 0.5f}, {INFINITY, 7});
    EXPECT_TRUE(graph->draw());
}

TEST(GraphTest, TakenNameIsAnError)
{
    const NullGui gui;
    auto graph = makeGraph("test/graph");
    const auto second = Graph::create("test/graph");
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, ErrorCode::InvalidSetting);
    graph.reset();
    EXPECT_TRUE(Graph::create("test/graph"));
}

TEST(GraphTest, OutlivesCegui)
{
    auto gui = std::make_unique<NullGui>();
    const auto graph = makeGraph("test/graph");
    gui.reset();
    const auto drawn = graph->draw();
    ASSERT_FALSE(drawn);
    EXPECT_EQ(drawn.error().code, ErrorCode::NotFound);
    const auto another = Graph::create("test/other");
    ASSERT_FALSE(another);
    EXPECT_EQ(another.error().code, ErrorCode::NotFound);
}

} // namespace
} // namespace lodsmith::test
