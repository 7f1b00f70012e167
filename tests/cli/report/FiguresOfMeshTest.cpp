#include "report/DrawnTriangles.h"
#include "report/ReportWarnings.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lodsmith::cli {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Json level(double triangles, double visibleError)
{
    return Json{
        {"triangles", triangles}, {"visible_error", visibleError}, {"distance", 10.0},         {"flipped_triangles", 0},
        {"new_border_edges", 0},  {"new_non_manifold_edges", 0},   {"stop", "target_reached"}, {"manual", nullptr}};
}

/// A mesh with nothing to say against it.
Json goodMesh()
{
    return Json{{"levels_from", "file"},
                {"statistics",
                 {{"triangles", 1000},
                  {"edges", 1500},
                  {"buffer_vertices", 600},
                  {"non_manifold_edges", 0},
                  {"inconsistent_edges", 0},
                  {"degenerate_triangles", 0},
                  {"repeated_triangles", 0},
                  {"unreferenced_vertices", 0},
                  {"uv_seam_edges", 40},
                  {"normal_seam_edges", 0}}},
                {"seam_factor", 1.1},
                {"drawn", {{"worst_excess", 1.2}, {"worst_excess_from", 30.0}}},
                {"levels", {level(1000, 0), level(400, 0.9), level(100, 1.0)}}};
}

std::vector<std::string> codes(const Json& mesh, double budget = 1.0)
{
    std::vector<std::string> codes;
    for (const Json& warning : warningsOf(mesh, budget))
        codes.push_back(warning["code"].get<std::string>());
    return codes;
}

} // namespace

TEST(DrawnTriangles, meansCountDoublingsOfTheDistance)
{
    // Two doublings with 100 triangles, one with 40.
    EXPECT_NEAR(meanTriangles({{0, 100}, {4, 40}}, 1.0, 8.0), (2 * 100 + 40) / 3.0, 1e-9);
    EXPECT_NEAR(meanTriangles({{0, 100}}, 1.0, 8.0), 100.0, 1e-9);
    EXPECT_NEAR(meanTriangles({{0, 100}, {0.5, 40}}, 1.0, 8.0), 40.0, 1e-9) << "it has switched before";
    EXPECT_NEAR(meanTriangles({{0, 100}, {9, 40}}, 1.0, 8.0), 100.0, 1e-9) << "it switches beyond";
}

TEST(DrawnTriangles, excessIsFoundWhereItIsWorst)
{
    double from = 0.0;
    EXPECT_DOUBLE_EQ(worstExcess({{0, 100}, {6, 10}}, {{0, 100}, {2, 50}, {4, 20}}, 1.0, 8.0, from), 5.0);
    EXPECT_DOUBLE_EQ(from, 4.0);
    EXPECT_DOUBLE_EQ(worstExcess({{0, 100}}, {{0, 100}}, 1.0, 8.0, from), 1.0);
    EXPECT_DOUBLE_EQ(worstExcess({{0, 100}}, {{0, 100}, {4, 0}}, 1.0, 8.0, from), 100.0) << "no division by nothing";
}

TEST(DrawnTriangles, aCurveThatNeedsTwiceAsManyHasFactorTwo)
{
    // Deviation = 1 / triangles, and 2 / triangles.
    std::vector<CurvePoint> curve{{1024, 0.0}}, other{{1024, 0.0}};
    for (double triangles = 512; triangles >= 1; triangles /= 2) {
        curve.push_back({triangles, 2.0 / triangles});
        other.push_back({triangles, 1.0 / triangles});
    }
    EXPECT_NEAR(trianglesFactor(curve, other), 2.0, 1e-9);
    EXPECT_NEAR(trianglesFactor(curve, curve), 1.0, 1e-9);
    EXPECT_NEAR(trianglesFactor({{10, 0}}, {{10, 0}}), 1.0, 1e-9) << "nothing to compare";
}

TEST(ReportWarnings, aGoodMeshHasNone)
{
    EXPECT_THAT(codes(goodMesh()), IsEmpty());
}

TEST(ReportWarnings, theBudgetDecidesAboutVisibleError)
{
    EXPECT_THAT(codes(goodMesh(), 0.95), ElementsAre("visible_error"));
    EXPECT_THAT(codes(goodMesh(), 0.5), ElementsAre("visible_error", "visible_error"));
    EXPECT_EQ(warningsOf(goodMesh(), 0.95)[0]["level"], 2);
}

TEST(ReportWarnings, geometryThatIsWrongIsNamed)
{
    Json mesh = goodMesh();
    mesh["statistics"]["non_manifold_edges"] = 1;
    mesh["statistics"]["inconsistent_edges"] = 144;
    mesh["statistics"]["degenerate_triangles"] = 56;
    mesh["statistics"]["repeated_triangles"] = 2;
    mesh["statistics"]["unreferenced_vertices"] = 100;
    EXPECT_THAT(codes(mesh), ElementsAre("non_manifold", "inconsistent_winding", "degenerate_triangles",
                                         "repeated_triangles", "unused_vertices"));
    EXPECT_THAT(warningsOf(mesh, 1.0)[0]["text"].get<std::string>(), testing::StartsWith("1 edge has more than two"));
}

TEST(ReportWarnings, seamsAreBlamedOnlyWhereThereAreSome)
{
    Json mesh = goodMesh();
    mesh["seam_factor"] = 3.0;
    EXPECT_THAT(codes(mesh), ElementsAre("seams"));
    mesh["statistics"]["uv_seam_edges"] = 0;
    EXPECT_THAT(codes(mesh), IsEmpty());
}

TEST(ReportWarnings, missingLevelsAreNamed)
{
    Json mesh = goodMesh();
    mesh["drawn"]["worst_excess"] = 9.0;
    EXPECT_THAT(codes(mesh), ElementsAre("missing_level"));
    mesh["levels_from"] = "automatic";
    EXPECT_THAT(codes(mesh), ElementsAre("no_levels"));
    mesh["statistics"]["triangles"] = 12;
    EXPECT_THAT(codes(mesh), IsEmpty()) << "a box needs none";
}

TEST(ReportWarnings, levelsAreComparedWithTheOneBefore)
{
    Json mesh = goodMesh();
    mesh["levels"][2]["triangles"] = 390;
    mesh["levels"][1]["stop"] = "seam";
    mesh["levels"][1]["new_border_edges"] = 3;
    mesh["levels"][2]["flipped_triangles"] = 1;
    mesh["levels"][2]["new_non_manifold_edges"] = 2;
    EXPECT_THAT(codes(mesh), ElementsAre("stopped", "cracks", "saves_little", "flipped", "new_non_manifold"));
}

TEST(ReportWarnings, aRemodelledLevelHasBordersOfItsOwn)
{
    Json mesh = goodMesh();
    mesh["levels"][1]["manual"] = "box.mesh";
    mesh["levels"][1]["new_border_edges"] = 30;
    mesh["levels"][1]["new_non_manifold_edges"] = 3;
    EXPECT_THAT(codes(mesh), IsEmpty());
}

TEST(ReportWarnings, levelsThatThinOutAreNamed)
{
    Json mesh = goodMesh();
    const auto seen = [](double coverage) { return Json{{"at_switch", {{"lit", {{"coverage", coverage}}}}}}; };
    mesh["seen"] = {seen(1.0), seen(0.99), seen(0.8)};
    EXPECT_THAT(codes(mesh), ElementsAre("thins_out"));
    EXPECT_EQ(warningsOf(mesh, 1.0)[0]["level"], 2);
}

} // namespace lodsmith::cli
