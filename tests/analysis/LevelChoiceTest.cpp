#include <lodsmith/analysis/LevelChoice.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lodsmith::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Candidates = std::vector<LevelCandidate>;

/// What chooseLevels() makes as small as it can, for any choice.
double costOf(std::uint32_t triangles, const Candidates& candidates, const std::vector<std::size_t>& choice)
{
    double cost = 0.0, shown = triangles, size = candidates.front().size;
    for (const std::size_t i : choice) {
        cost += shown / triangles * std::log2(size / candidates[i].size) + kWorthOfLevel;
        shown = candidates[i].triangles;
        size = candidates[i].size;
    }
    return cost + shown / triangles * std::log2(size / (candidates.back().size / 2.0));
}

TEST(LevelChoice, LeavesOutWhatSavesTooLittle)
{
    // Each is for twice the distance; the second and the last save next to nothing.
    const Candidates candidates{{64, 500}, {32, 490}, {16, 250}, {8, 245}};
    EXPECT_THAT(chooseLevels(1000, candidates, 8), ElementsAre(0, 2));
}

TEST(LevelChoice, ALevelThatPaysOverTwoDoublingsIsWorthIt)
{
    EXPECT_THAT(chooseLevels(1000, {{64, 960}, {32, 960}}, 8), IsEmpty()) << "0.04 for two doublings";
    EXPECT_THAT(chooseLevels(1000, {{64, 940}, {32, 940}}, 8), ElementsAre(0)) << "0.06 for two doublings";
}

TEST(LevelChoice, TakesTheBestWhenThereMayBeFew)
{
    const Candidates candidates{{64, 800}, {32, 100}, {16, 10}};
    EXPECT_THAT(chooseLevels(1000, candidates, 1), ElementsAre(1));
    EXPECT_THAT(chooseLevels(1000, candidates, 0), IsEmpty());
    EXPECT_THAT(chooseLevels(1000, candidates, 2), ElementsAre(0, 1)) << "800 for one doubling, 100 for two";
}

TEST(LevelChoice, OfNothingIsNothing)
{
    EXPECT_THAT(chooseLevels(0, {{64, 0}}, 8), IsEmpty());
    EXPECT_THAT(chooseLevels(1000, {}, 8), IsEmpty());
    EXPECT_THAT(chooseLevels(1000, {{64, 1000}, {32, 1000}}, 8), IsEmpty());
    EXPECT_THAT(chooseLevels(1000, {{64, 2000}}, 8), IsEmpty()) << "a level that is dearer than the mesh";
}

TEST(LevelChoice, NoOtherChoiceIsBetter)
{
    std::mt19937 random(1);
    for (unsigned round = 0; round < 500; ++round) {
        Candidates candidates;
        double size = 1000.0;
        for (unsigned i = 0; i < 1 + round % 9; ++i) {
            size /= 1.0 + random() % 1000 / 300.0;
            if (!candidates.empty() && size >= candidates.back().size)
                size = candidates.back().size / 1.1;
            candidates.push_back({size, static_cast<std::uint32_t>(random() % 1000)});
        }
        const std::size_t most = 1 + random() % 9;
        const double chosen = costOf(1000, candidates, chooseLevels(1000, candidates, most));
        for (unsigned set = 0; set < 1u << candidates.size(); ++set) {
            std::vector<std::size_t> choice;
            for (std::size_t i = 0; i < candidates.size(); ++i)
                if (set >> i & 1)
                    choice.push_back(i);
            if (choice.size() > most)
                continue;
            ASSERT_LE(chosen, costOf(1000, candidates, choice) + 1e-9) << "round " << round;
        }
    }
}

} // namespace
} // namespace lodsmith::test
