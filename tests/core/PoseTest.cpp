#include "support/CheckedSimplify.h"
#include "support/MeshBuilders.h"
#include "support/SurfaceDistance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

using namespace test;

constexpr double kPi = 3.14159265358979323846;

TestMesh atRest(TestMesh mesh)
{
    for (TestBuffer& buffer : mesh.buffers)
        buffer.poses.clear();
    return mesh;
}

/// The triangles of a level, or of the mesh itself, in a pose.
std::vector<Triangle> surfaceOf(const MeshView& mesh, std::size_t pose)
{
    const MeshView posed = inPose(mesh, pose);
    std::vector<Triangle> triangles;
    for (const SubMeshView& subMesh : posed.subMeshes)
        for (std::uint32_t i = 0; i < subMesh.indexCount; ++i) {
            float position[3];
            posed.vertexBuffers[subMesh.vertexBuffer].positions.read(subMesh.index(i), 3, position);
            if (i % 3 == 0)
                triangles.emplace_back();
            triangles.back()[i % 3] = {position[0], position[1], position[2]};
        }
    return triangles;
}

/// Both ways, in the pose.
double distanceInPose(const TestMesh& mesh, const LodChainLevel& level, std::size_t pose)
{
    const std::vector<Triangle> whole = surfaceOf(mesh.view(), pose), reduced = surfaceOf(mesh.view(level), pose);
    return std::max(sampledDistance(whole, reduced, 2000, 1), sampledDistance(reduced, whole, 2000, 2));
}

/// How many of a level's vertices lie where both bones pull.
std::size_t verticesAtElbow(const TestMesh& mesh, const LodChainLevel& level)
{
    std::vector<bool> used(mesh.buffers[0].vertexCount(), false);
    for (const std::uint32_t index : level.indices[0])
        used[index] = true;
    std::size_t count = 0;
    for (std::size_t vertex = 0; vertex < used.size(); ++vertex) {
        const float upper = mesh.buffers[0].bones[vertex].weight[1];
        count += used[vertex] && upper > 0.05f && upper < 0.95f ? 1 : 0;
    }
    return count;
}

/// A flat sheet that one pose rolls up, by this angle.
TestMesh makeRolledSheet(std::uint32_t cells, double degrees)
{
    TestMesh mesh = makeGrid(cells, cells);
    TestBuffer& buffer = mesh.buffers[0];
    const double angle = degrees * kPi / 180.0;
    std::vector<float> pose;
    for (std::size_t i = 0; i < buffer.positions.size(); i += 3) {
        const double around = angle * buffer.positions[i];
        pose.push_back(static_cast<float>(std::sin(around) / angle));
        pose.push_back(buffer.positions[i + 1]);
        pose.push_back(static_cast<float>((std::cos(around) - 1.0) / angle));
    }
    buffer.poses.push_back(std::move(pose));
    return mesh;
}

/// Triangles of a rolled sheet that show their back to the outside at their corners: by more than what the corners' own normals may be
/// off at the sheet's border.
std::size_t turnedInwards(const TestMesh& mesh, const LodChainLevel& level, double degrees)
{
    constexpr double kOff = 0.25; // cosine; half a cell is ten degrees
    const double radius = 180.0 / (degrees * kPi);
    std::size_t count = 0;
    for (const Triangle& triangle : surfaceOf(mesh.view(level), 0)) {
        const Point normal = areaNormal(triangle);
        double cosines = 0.0;
        for (const Point& corner : triangle)
            cosines += dot(normal, {corner[0], 0.0, corner[2] + radius}) / (length(normal) * radius);
        count += cosines / 3.0 < -kOff ? 1 : 0;
    }
    return count;
}

TEST(Poses, AnElbowKeepsItsRings)
{
    const TestMesh tube = makeBentTube(24, 32, {100.0}), straight = atRest(tube);
    const std::vector<LevelTarget> targets = {keptTriangles(500), keptTriangles(250)};
    const LodChain bent = simplifyChecked(tube.view(), targets), plain = simplifyChecked(straight.view(), targets);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        SCOPED_TRACE(i);
        EXPECT_EQ(bent.levels[i].triangles, plain.levels[i].triangles);
        EXPECT_GT(verticesAtElbow(tube, bent.levels[i]), verticesAtElbow(tube, plain.levels[i]));
        EXPECT_LT(distanceInPose(tube, bent.levels[i], 0), 0.75 * distanceInPose(tube, plain.levels[i], 0));
    }
}

TEST(Poses, TheBoundHoldsInEveryPose)
{
    const TestMesh tubes[] = {makeBentTube(12, 16, {100.0}), makeBentTube(12, 16, {170.0, -170.0, 45.0}),
                              makeBentTube(8, 12, {30.0, 60.0, 90.0, 120.0, 150.0})};
    const std::vector<LevelTarget> targets = {removedShare(0.3), removedShare(0.7), removedShare(0.95)};
    SimplifyOptions curvature;
    curvature.metric = Metric::Curvature;
    for (const TestMesh& tube : tubes)
        for (const SimplifyOptions& options : {SimplifyOptions{}, curvature})
            simplifyChecked(tube.view(), targets, options, {2000});
}

TEST(Poses, ATargetOfDeviationCountsThem)
{
    const TestMesh tube = makeBentTube(24, 32, {100.0});
    const LodChain chain = simplifyChecked(tube.view(), {greatestDeviation(0.02)});
    EXPECT_LT(chain.levels[0].triangles, tube.triangleCount() / 2);
    EXPECT_LE(distanceInPose(tube, chain.levels[0], 0), 0.02);
}

TEST(Poses, NoTriangleTurnsOverInOne)
{
    constexpr double kDegrees = 330.0;
    const TestMesh sheet = makeRolledSheet(16, kDegrees), flat = atRest(sheet);
    const std::vector<LevelTarget> targets = {removedShare(0.5), removedShare(0.98)};
    SimplifyOptions curvature; // does not know of poses, but what is forbidden is forbidden
    curvature.metric = Metric::Curvature;
    for (const SimplifyOptions& options : {SimplifyOptions{}, curvature})
        for (const LodChainLevel& level : simplifyChecked(sheet.view(), targets, options).levels)
            EXPECT_EQ(turnedInwards(sheet, level, kDegrees), 0u) << level.triangles;
    const LodChain blind = simplifyChecked(flat.view(), targets);
    EXPECT_GT(turnedInwards(sheet, blind.levels[1], kDegrees), 0u) << "the sheet would be no test";
}

TEST(Poses, LipsThatPartCountWhereTheyPart)
{
    TestMesh lips = makeClosedLips(12);
    TestBuffer& buffer = lips.buffers[0];
    buffer.poses.push_back(buffer.positions);
    for (std::size_t i = 0; i < buffer.positions.size(); ++i)
        buffer.poses[0][i] += buffer.offsets[0][i];
    simplifyChecked(lips.view(), {removedShare(0.5), removedShare(0.9)}, {}, {2000});
    buffer.offsets.clear(); // the pose alone tells that they must not be joined
    simplifyChecked(lips.view(), {removedShare(0.5), removedShare(0.9)}, {}, {2000});
}

TEST(Poses, PiecesThatAreSweptAwayCountWhereTheyWere)
{
    TestMesh cards = makeLeafCards(60);
    TestBuffer& buffer = cards.buffers[0];
    TestRandom random(5);
    buffer.poses.assign(6, buffer.positions);
    for (std::vector<float>& pose : buffer.poses)
        for (std::size_t card = 0; card < pose.size(); card += 12) {
            const float shift = static_cast<float>(random.uniform(-3.0, 3.0));
            for (std::size_t i = card; i < card + 12; i += 3)
                pose[i] += shift;
        }
    const LodChain chain = simplifyChecked(cards.view(), {removedShare(0.5)}, {}, {2000});
    EXPECT_GT(chain.levels[0].deviation,
              simplifyChecked(atRest(cards).view(), {removedShare(0.5)}).levels[0].deviation);
}

TEST(Poses, SizeDoesNotMatter)
{
    const TestMesh tube = makeBentTube(12, 16, {100.0, -60.0});
    const LodChain small = simplifyChecked(tube.view(), {removedShare(0.8)}),
                   large = simplifyChecked(scaled(tube, 1024.0).view(), {removedShare(0.8)});
    EXPECT_EQ(small.levels[0].indices, large.levels[0].indices);
    EXPECT_EQ(1024.0 * small.levels[0].deviation, large.levels[0].deviation);
}

TEST(Poses, WalkingAwayChangesNothing)
{
    const TestMesh tube = makeBentTube(12, 16, {100.0});
    TestMesh away = tube;
    for (std::size_t i = 0; i < away.buffers[0].poses[0].size(); i += 3) // by a power of two, with room for every digit
        away.buffers[0].poses[0][i] = std::round(away.buffers[0].poses[0][i] * 1024.0f) / 1024.0f + 64.0f;
    TestMesh near = away;
    for (std::size_t i = 0; i < near.buffers[0].poses[0].size(); i += 3)
        near.buffers[0].poses[0][i] -= 64.0f;
    EXPECT_EQ(simplifyChecked(away.view(), {removedShare(0.8)}).levels[0].indices,
              simplifyChecked(near.view(), {removedShare(0.8)}).levels[0].indices);
}

TEST(Poses, OnesThatDrawAllTogetherHinderNothing)
{
    TestMesh tube = makeSkinnedTube(12, 16);
    tube.buffers[0].poses.assign(2, std::vector<float>(tube.buffers[0].positions.size(), 0.25f));
    const LodChain chain = simplifyChecked(tube.view(), {removedShare(0.8)});
    EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached);
}

TEST(Poses, BuffersWithoutOneStayAtRest)
{
    const TestMesh both = joined(makeBentTube(12, 16, {100.0, -60.0}), makeUvSphere(12, 8));
    simplifyChecked(both.view(), {removedShare(0.5), removedShare(0.9)});
}

TEST(Poses, BadNumbersAreRefused)
{
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e12f}) {
        TestMesh tube = makeBentTube(12, 16, {10.0, 20.0});
        tube.buffers[0].poses[1][100] = bad;
        const Result<LodChain> chain = simplify(tube.view(), {removedShare(0.5)});
        ASSERT_FALSE(chain) << bad;
        EXPECT_EQ(chain.error().code, ErrorCode::InvalidGeometry);
        EXPECT_NE(chain.error().message.find("pose 1"), std::string::npos) << chain.error().message;
    }
}

} // namespace

} // namespace lodsmith
