#include "CommandLine.h"
#include "SampleFiles.h"

#include <gmock/gmock.h>

namespace lodsmith::cli {

namespace {

using lodsmith::test::TestDirectory;
using test::Outcome;
using test::runLodsmith;
using testing::HasSubstr;

constexpr unsigned kSegments = 12;

} // namespace

TEST(InspectCommand, countsWhatATorusIsMadeOf)
{
    const TestDirectory directory;
    const std::string mesh = directory.write("torus.mesh", test::torusMesh(kSegments));
    const Outcome outcome = runLodsmith({"inspect", mesh, "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json record = outcome.records().at(0);
    EXPECT_EQ(record["format"], "1.100");
    const nlohmann::json& statistics = record["statistics"];
    EXPECT_EQ(statistics["vertices"], kSegments * kSegments);
    EXPECT_EQ(statistics["buffer_vertices"], (kSegments + 1) * (kSegments + 1));
    EXPECT_EQ(statistics["triangles"], test::torusTriangles(kSegments));
    // Euler's formula for one hole: as many edges as vertices and faces together.
    EXPECT_EQ(statistics["edges"], kSegments * kSegments + test::torusTriangles(kSegments));
    EXPECT_EQ(statistics["border_edges"], 0);
    // One seam each way.
    EXPECT_EQ(statistics["uv_seam_edges"], 2 * kSegments);
    EXPECT_EQ(statistics["components"], 1);
    const nlohmann::json& subMesh = record["submeshes"].at(0);
    EXPECT_EQ(subMesh["material"], "Stone");
    EXPECT_EQ(subMesh["operation"], "triangle list");
    EXPECT_EQ(subMesh["index_bits"], 16);
    EXPECT_EQ(subMesh["shared_vertices"], false);
    EXPECT_EQ(record["levels"].size(), 1u);
}

TEST(InspectCommand, showsLevelsAndWhatIsMissing)
{
    const TestDirectory directory;
    const std::string mesh = directory.write("a.mesh", test::torusMesh(kSegments, "gone.skeleton"));
    const std::string box = directory.write("box.mesh", test::torusMesh(8));
    const std::string output = (directory / "out/a.mesh").string();
    ASSERT_EQ(runLodsmith({"generate", mesh, "-o", output, "--levels", "10:proportional:0.5,30:mesh:" + box}).exitCode,
              0);
    const Outcome outcome = runLodsmith({"inspect", output});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("levels by distance_sphere"));
    EXPECT_THAT(outcome.out, HasSubstr("box.mesh"));
    EXPECT_THAT(outcome.out, HasSubstr("note: skeleton 'gone.skeleton' is not there"));
}

TEST(InspectCommand, failureIsARecordToo)
{
    const TestDirectory directory;
    const Outcome outcome = runLodsmith({"inspect", directory.write("a.mesh", "x"), "--json"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.records().at(0)["error_code"], "bad_file");
}

} // namespace lodsmith::cli
