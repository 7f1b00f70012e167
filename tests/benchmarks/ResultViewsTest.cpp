#include "Configuration.h"
#include "RunStore.h"

#include "support/TestDirectory.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lodsmith::benchmarks {

namespace {

using testing::DoubleNear;
using testing::ElementsAre;

constexpr std::uint32_t kTriangles = 1000;

struct ShownLevel {
    double radius;        ///< on screen, pixels
    double visiblePixels; ///< that it is off there
    std::uint32_t triangles;
};

class ResultViewsTest : public testing::Test {
protected:
    /// Keeps levels of the formula of 2012, whatever they are.
    void keep(const std::string& generator, const std::vector<ShownLevel>& levels)
    {
        RunStore store(mDatabase, Machine{"cpu", 1, 1.0, "kernel"}, Build{"build", "1", "", "gcc", "Release"}, {});
        RunRecord record;
        record.generator = generator;
        record.rounds.assign(5, Round{0.1, 0.0, 0.1, 0.1});
        for (const ShownLevel& shown : levels) {
            LevelRecord level;
            level.target = {LevelTarget::Kind::CollapseCost, 1.0};
            level.pixels = std::acos(-1.0) * shown.radius * shown.radius;
            level.measured.triangles = shown.triangles;
            level.measured.deviation = Deviation{};
            level.visiblePixels = shown.visiblePixels;
            record.levels.push_back(level);
        }
        const MeshRecord mesh{"mesh", "hash", kTriangles, 500, 1.0, true, true};
        Configuration configuration;
        configuration.name = kClassic;
        store.save(store.place(mesh, configuration), record, RunStore::IfDone::Keep);
    }

    /// A column of the rows of a view, in an order.
    std::vector<double> figures(const std::string& column, const std::string& rest)
    {
        std::vector<double> values;
        mDatabase.use([&](soci::session& session) {
            const soci::rowset<double> rows = (session.prepare << "SELECT CAST(" + column + " AS REAL) FROM " + rest);
            values.assign(rows.begin(), rows.end());
        });
        return values;
    }

    const lodsmith::test::TestDirectory mDirectory;
    Database mDatabase{(mDirectory / "lab.db").string(), Database::Mode::MakeIfAbsent};
};

// A mesh of 1000 triangles has 500 from 256 pixels on and 100 from 64 on: of the 8.5 doublings from 512 pixels to 1.41 one is
// drawn whole, two by halves, five and a half by tenths. Of the distances from 1 to 50, one, six and 42.
TEST_F(ResultViewsTest, trianglesAreDrawnUntilTheNextLevelTakesOver)
{
    keep(kLodsmithCurvature, {{256.0, 1.0, 500}, {64.0, 1.0, 100}});
    EXPECT_THAT(figures("over_doublings", "drawn WHERE NOT moved"), ElementsAre(DoubleNear(2.55 / 8.5, 1e-5)));
    EXPECT_THAT(figures("over_distances", "drawn WHERE NOT moved"), ElementsAre(DoubleNear(8.2 / 49.0, 1e-9)));
}

TEST_F(ResultViewsTest, whatIsLargerThanTheSweepIsDrawnFromItsBeginning)
{
    keep(kLodsmithCurvature, {{2048.0, 1.0, 500}});
    EXPECT_THAT(figures("over_doublings", "drawn WHERE NOT moved"), ElementsAre(DoubleNear(0.5, 1e-5)));
    EXPECT_THAT(figures("over_distances", "drawn WHERE NOT moved"), ElementsAre(DoubleNear(0.5, 1e-9)));
}

// The first level is two pixels off where it is shown, the second half a pixel: both may be shown from 128 pixels on, and then
// the first one never is.
TEST_F(ResultViewsTest, movedLevelsAreShownWhereTheyAreAPixelOff)
{
    keep(kLodsmithCurvature, {{256.0, 2.0, 500}, {64.0, 0.5, 100}});
    EXPECT_THAT(figures("over_doublings", "drawn WHERE moved"), ElementsAre(DoubleNear((2.0 + 0.65) / 8.5, 1e-5)));
}

TEST_F(ResultViewsTest, othersAreComparedWithTheFormulaOf2012)
{
    keep(kLodsmithCurvature, {{512.0, 1.0, 500}});
    keep(kLodsmith, {{512.0, 1.0, 100}});
    EXPECT_THAT(figures("\"over lodsmith-curvature, classic\"", "triangles_drawn WHERE generator = 'lodsmith'"),
                ElementsAre(DoubleNear(0.2, 1e-9), DoubleNear(0.2, 1e-9)));
}

TEST_F(ResultViewsTest, sizesHaveTheMedianOfTheirLevels)
{
    keep(kLodsmithCurvature, {{256.0, 2.0, 500}, {64.0, 0.5, 100}});
    EXPECT_THAT(figures("median", "by_size ORDER BY position"), ElementsAre(50.0, 10.0));
    EXPECT_THAT(figures("\"px, median\"", "by_size ORDER BY position"), ElementsAre(2.0, 0.5));
}

} // namespace

} // namespace lodsmith::benchmarks
