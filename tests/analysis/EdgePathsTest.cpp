#include "EdgePaths.h"

#include <gtest/gtest.h>

using lodsmith::analysis::EdgePaths;

namespace {

/// A ring of edges 0-1-2-...-(count-1)-0, of rank 1.
void addRing(EdgePaths& paths, std::uint32_t count)
{
    for (std::uint32_t i = 0; i < count; ++i)
        paths.add(i, (i + 1) % count, 1);
}

} // namespace

TEST(EdgePaths, JoinAcrossRemovedVerticesOnly)
{
    const std::vector<bool> kept{true, false, false, true, false, true, false, false};
    EdgePaths paths(kept);
    addRing(paths, 8);
    paths.seal();
    EXPECT_TRUE(paths.join(0, 3, 1)); // over 1 and 2
    EXPECT_TRUE(paths.join(3, 5, 1)); // over 4
    EXPECT_TRUE(paths.join(5, 0, 1)); // over 6 and 7
}

TEST(EdgePaths, AKeptVertexOnTheWayBlocks)
{
    const std::vector<bool> kept{true, false, true, false, true, false, true, false};
    EdgePaths paths(kept);
    addRing(paths, 8);
    paths.seal();
    EXPECT_TRUE(paths.join(0, 2, 1));
    EXPECT_FALSE(paths.join(0, 4, 1));
}

TEST(EdgePaths, EdgeThatIsStillThere)
{
    const std::vector<bool> kept(4, true);
    EdgePaths paths(kept);
    addRing(paths, 4);
    paths.seal();
    EXPECT_TRUE(paths.join(1, 0, 1));
    EXPECT_FALSE(paths.join(0, 2, 1));
}

TEST(EdgePaths, RankIsTheHighestAlongThePath)
{
    const std::vector<bool> kept{true, false, true, true};
    EdgePaths paths(kept);
    paths.add(0, 1, 3);
    paths.add(1, 2, 4);
    paths.add(2, 3, 3);
    paths.seal();
    EXPECT_TRUE(paths.join(0, 2, 4));
    EXPECT_FALSE(paths.join(0, 2, 5));
    EXPECT_TRUE(paths.join(2, 3, 3));
    EXPECT_FALSE(paths.join(2, 3, 4));
}
