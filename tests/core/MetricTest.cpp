#include "support/CheckedSimplify.h"
#include "support/MeshBuilders.h"
#include "support/SurfaceDistance.h"
#include "support/WeldedMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace lodsmith {

namespace {

using namespace test;

constexpr AttributeWeights kGeometryOnly{0.0f, 0.0f, 0.0f, 0.0f};

SimplifyOptions geometryOptions(Metric metric, bool lockBorders = false)
{
    SimplifyOptions options;
    options.metric = metric;
    options.weights = kGeometryOnly;
    options.lockBorders = lockBorders;
    return options;
}

/// A pyramid on a 2 x 2 square without a floor, apex at (0, 0, height): with locked borders the apex alone may go, and all
/// four corners are the same to it.
TestMesh makePyramid(double height)
{
    TestMesh mesh;
    mesh.buffers.resize(1);
    mesh.subMeshes.resize(1);
    mesh.buffers[0].addPosition(-1, -1, 0);
    mesh.buffers[0].addPosition(1, -1, 0);
    mesh.buffers[0].addPosition(1, 1, 0);
    mesh.buffers[0].addPosition(-1, 1, 0);
    mesh.buffers[0].addPosition(0, 0, height);
    for (std::uint32_t corner = 0; corner < 4; ++corner)
        mesh.subMeshes[0].addTriangle(corner, (corner + 1) % 4, 4);
    return mesh;
}

/// The positions that the level still has.
std::set<Point> positionsIn(const TestMesh& mesh, const LodChainLevel& level)
{
    std::set<Point> positions;
    for (std::size_t s = 0; s < level.indices.size(); ++s) {
        const std::vector<float>& p = mesh.buffers[mesh.subMeshes[s].vertexBuffer].positions;
        for (const std::uint32_t index : level.indices[s])
            positions.insert({p[3 * index], p[3 * index + 1], p[3 * index + 2]});
    }
    return positions;
}

/// The one collapse that a pyramid allows costs `expected`: just less buys nothing, just more buys it.
void expectApexCost(double height, Metric metric, double expected)
{
    const TestMesh mesh = makePyramid(height);
    const SimplifyOptions options = geometryOptions(metric, true);
    const LodChain chain =
        simplifyChecked(mesh.view(), {dearestCollapse(expected * 0.999), dearestCollapse(expected * 1.001)}, options);
    EXPECT_TRUE(chain.levels[0].skipped) << "height " << height << " costs less than " << expected;
    EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached);
    EXPECT_EQ(chain.levels[1].vertices, 4u) << "height " << height << " costs more than " << expected;
    EXPECT_NEAR(chain.levels[1].cost, expected, expected * 1e-4);
    EXPECT_GE(chain.levels[1].deviation, height - 1e-6 * height);
}

TEST(QuadricMetric, InsideOfAFlatGridCostsNothing)
{
    const TestMesh mesh = makeGrid(8, 8, 8.0);
    const LodChain chain =
        simplifyChecked(mesh.view(), {dearestCollapse(1e-3)}, geometryOptions(Metric::Quadric, true));
    // From one vertex on a straight border not all others can be seen, so that a few inside may have to stay.
    EXPECT_LE(chain.levels[0].vertices, 32u + 4u) << "the border is locked, all else is free";
    EXPECT_LT(chain.levels[0].cost, 1e-3);
    EXPECT_LT(chain.levels[0].deviation, 1e-5);
}

TEST(QuadricMetric, AFlatGridIsItsFourCorners)
{
    const TestMesh mesh = makeGrid(8, 8, 8.0);
    const LodChain chain =
        simplifyChecked(mesh.view(), {dearestCollapse(1e-2), greatestDeviation(0.5)}, geometryOptions(Metric::Quadric));
    EXPECT_EQ(chain.levels[0].vertices, 4u) << "straight borders cost nothing, corners do";
    EXPECT_EQ(chain.levels[0].triangles, 2u);
    EXPECT_LT(chain.levels[0].deviation, 1e-5);
}

TEST(QuadricMetric, LinearTextureAndEqualNormalsOnAFlatGridCostNothing)
{
    const TestMesh mesh = makeGrid(8, 8, 8.0);
    SimplifyOptions options;
    options.weights = {1.0f, 1.0f, 1.0f, 1.0f};
    const LodChain chain = simplifyChecked(mesh.view(), {dearestCollapse(1e-2)}, options);
    EXPECT_EQ(chain.levels[0].vertices, 4u);
}

TEST(QuadricMetric, PyramidApexByHand)
{
    // Onto a corner: the two faces there are at distance 0, the two others, of area s = sqrt(1 + h^2) each, at 2h / s.
    // Cost 2 s (2h / s)^2 over an area of 4 s: as a length sqrt(2) h / s.
    for (const double height : {0.1, 0.5, 1.0, 2.0})
        expectApexCost(height, Metric::Quadric, std::sqrt(2.0) * height / std::sqrt(1.0 + height * height));
}

/// The cheapest allowed collapse of a closed mesh by the definition: planes of the faces around the source, weighted by
/// area and three tenths of the mean face's, as a length. A face must not turn by more than a right angle.
double cheapestQuadricLength(const MeshView& view)
{
    const WeldedPositions welded = weldPositions(view);
    const std::vector<WeldedTriangle> triangles = weldedTriangles(view, welded, indexLists(view));
    std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 3>>> rings; // turned so that the source comes first
    for (const WeldedTriangle& triangle : triangles) {
        const auto& p = triangle.positions;
        for (int i = 0; i < 3; ++i)
            rings[p[i]].push_back({p[i], p[(i + 1) % 3], p[(i + 2) % 3]});
    }
    const auto corners = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return Triangle{welded.points[a], welded.points[b], welded.points[c]};
    };
    double whole = 0.0;
    for (const WeldedTriangle& triangle : triangles)
        whole += 0.5 * length(areaNormal(corners(triangle.positions[0], triangle.positions[1], triangle.positions[2])));
    const double share = 0.3 * whole / static_cast<double>(triangles.size());
    double cheapest = std::numeric_limits<double>::infinity();
    for (const auto& [source, ring] : rings) {
        for (const auto& edge : ring) {
            const std::uint32_t destination = edge[1];
            const Point step = subtract(welded.points[destination], welded.points[source]);
            double cost = 0.0, area = 0.0;
            bool flips = false;
            for (const auto& face : ring) {
                const Point normal = areaNormal(corners(face[0], face[1], face[2]));
                const double distance = dot(step, normal) / length(normal);
                const double weight = 0.5 * length(normal) + share;
                cost += weight * distance * distance;
                area += weight;
                if (face[1] != destination && face[2] != destination)
                    flips |= dot(normal, areaNormal(corners(destination, face[1], face[2]))) <= 0.0;
            }
            if (!flips)
                cheapest = std::min(cheapest, std::sqrt(cost / area));
        }
    }
    return cheapest;
}

TEST(QuadricMetric, TheFirstCollapseIsTheCheapestOfAll)
{
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        const TestMesh mesh = jittered(makeIcosphere(2), 0.05, seed);
        const double expected = cheapestQuadricLength(mesh.view());
        const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(1)}, geometryOptions(Metric::Quadric));
        EXPECT_NEAR(chain.levels[0].cost, expected, 1e-3 * expected) << "seed " << seed;
    }
}

TEST(QuadricMetric, CubeCornersAreDearerThanItsEdgesAndItsEdgesThanItsSides)
{
    const TestMesh mesh = makeCube(4);
    const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(98 - 8)}, geometryOptions(Metric::Quadric));
    for (const Point& position : positionsIn(mesh, chain.levels[0])) {
        for (const double coordinate : position)
            EXPECT_EQ(std::abs(coordinate), 1.0) << "a vertex that is no corner outlived a corner";
    }
    EXPECT_LT(chain.levels[0].deviation, 1e-5);
}

TEST(QuadricMetric, ATextureThatBendsCostsMore)
{
    TestMesh straight = makeGrid(6, 6, 6.0);
    TestMesh bent = straight;
    for (std::uint32_t vertex = 0; vertex < 49; ++vertex) {
        for (std::uint32_t i = 2 * vertex; i < 2 * vertex + 2; ++i)
            bent.buffers[0].uvSets[0][i] *= bent.buffers[0].uvSets[0][i];
    }
    SimplifyOptions options;
    options.weights = {0.0f, 0.5f, 0.0f, 0.0f};
    const LodChain cheap = simplifyChecked(straight.view(), {removedShare(0.6)}, options);
    const LodChain dear = simplifyChecked(bent.view(), {removedShare(0.6)}, options);
    EXPECT_GT(dear.levels[0].cost, 5.0 * cheap.levels[0].cost);
    options.weights = kGeometryOnly;
    EXPECT_EQ(simplifyChecked(bent.view(), {removedShare(0.6)}, options).levels[0].indices,
              simplifyChecked(straight.view(), {removedShare(0.6)}, options).levels[0].indices)
        << "a weight of 0 ignores the attribute";
}

/// A flat square of 8 x 8 cells whose vertices are told apart by an attribute: those up to x = 4 and those from x = 5.
/// The step is kept when every triangle with corners of both kinds lies between the two columns.
bool keepsStep(const TestMesh& mesh, const AttributeWeights& weights)
{
    SimplifyOptions options;
    options.weights = weights;
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.85)}, options);
    EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached);
    const std::vector<float>& positions = mesh.buffers[0].positions;
    const std::vector<std::uint32_t>& indices = chain.levels[0].indices[0];
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const auto [low, high] =
            std::minmax({positions[3 * indices[i]], positions[3 * indices[i + 1]], positions[3 * indices[i + 2]]});
        if (low <= 4.0f && high >= 5.0f && (low < 4.0f || high > 5.0f))
            return false;
    }
    return true;
}

TEST(QuadricMetric, AStepInColourIsKept)
{
    TestMesh mesh = makeGrid(8, 8, 8.0);
    for (std::uint32_t vertex = 0; vertex < 81; ++vertex) {
        const float shade = vertex % 9 <= 4 ? 0.0f : 1.0f;
        mesh.buffers[0].colours.insert(mesh.buffers[0].colours.end(), {shade, shade, shade, 1.0f});
    }
    EXPECT_TRUE(keepsStep(mesh, {0.0f, 0.0f, 0.5f, 0.0f}));
    EXPECT_FALSE(keepsStep(mesh, kGeometryOnly)) << "it was the colour that kept it";
}

TEST(QuadricMetric, AStepInBonesIsKept)
{
    TestMesh mesh = makeGrid(8, 8, 8.0);
    for (std::uint32_t vertex = 0; vertex < 81; ++vertex) {
        BoneInfluences influences;
        influences.bone[0] = vertex % 9 <= 4 ? 3 : 7;
        influences.weight[0] = 1.0f;
        mesh.buffers[0].bones.push_back(influences);
    }
    EXPECT_TRUE(keepsStep(mesh, {0.0f, 0.0f, 0.0f, 0.5f}));
    EXPECT_FALSE(keepsStep(mesh, kGeometryOnly)) << "it was the bones that kept it";
}

TEST(QuadricMetric, TheOrderOfBonesMeansNothing)
{
    TestMesh mesh = makeSkinnedTube(16, 12);
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.7)});
    for (std::size_t i = 0; i < mesh.buffers[0].bones.size(); i += 2) {
        BoneInfluences& influences = mesh.buffers[0].bones[i];
        std::swap(influences.bone[0], influences.bone[1]);
        std::swap(influences.weight[0], influences.weight[1]);
    }
    EXPECT_EQ(simplifyChecked(mesh.view(), {removedShare(0.7)}).levels[0].indices, chain.levels[0].indices);
}

TEST(CurvatureMetric, FlatSurfaceCostsAThousandthOfTheEdge)
{
    const TestMesh mesh = makeGrid(8, 8, 16.0); // edges 2 long, diagonals longer
    const LodChain chain = simplifyChecked(mesh.view(), {dearestCollapse(0.00199), dearestCollapse(0.00201)},
                                           geometryOptions(Metric::Curvature, true));
    EXPECT_TRUE(chain.levels[0].skipped);
    EXPECT_LT(chain.levels[1].vertices, 81u);
    EXPECT_NEAR(chain.levels[1].cost, 0.002, 1e-6);
}

TEST(CurvatureMetric, PyramidApexByHand)
{
    // Against the two faces on the edge, the opposite two bend least by that of neighbouring faces: cosine 1 / (1 + h^2).
    // The edge is sqrt(2 + h^2) long.
    for (const double height : {0.1, 0.5, 1.0, 2.0}) {
        const double bend = 0.5 * (1.002 - 1.0 / (1.0 + height * height));
        expectApexCost(height, Metric::Curvature, bend * std::sqrt(2.0 + height * height));
    }
}

TEST(CurvatureMetric, BordersByHand)
{
    // A flat 2 x 1 strip of two quads, all of it border. Middle vertices of the long sides: straight on, so 0.001 per
    // unit of length. Then a corner along a side of length 1: a right angle, (0 + 1.002) / 2.
    const TestMesh mesh = makePatch(2, 1, [](double u, double v) { return Point{2.0 * u, v, 0.0}; });
    const std::vector<LevelTarget> targets = {dearestCollapse(0.00099), dearestCollapse(0.00101), dearestCollapse(0.5),
                                              dearestCollapse(0.502)};
    const LodChain chain = simplifyChecked(mesh.view(), targets, geometryOptions(Metric::Curvature));
    EXPECT_TRUE(chain.levels[0].skipped);
    EXPECT_EQ(chain.levels[1].vertices, 4u);
    EXPECT_NEAR(chain.levels[1].cost, 0.001, 1e-6);
    EXPECT_TRUE(chain.levels[2].skipped);
    EXPECT_EQ(chain.levels[3].vertices, 3u);
    EXPECT_NEAR(chain.levels[3].cost, 0.501, 1e-5);
}

TEST(CurvatureMetric, SeamsComeAfterTheSurfaceAroundThem)
{
    // A flat grid with a seam down the middle: whatever is no seam goes first.
    const TestMesh flat = makeGrid(8, 8, 8.0);
    TestMesh mesh = joined(flat, flat);
    for (float& u : mesh.buffers[1].uvSets[0])
        u += 2.0f;
    for (std::size_t s = 0; s < 2; ++s) {
        std::vector<std::uint32_t> kept;
        for (std::size_t i = 0; i < flat.subMeshes[0].indices.size(); ++i) {
            if ((i / 6 % 8 < 4) == (s == 0))
                kept.push_back(flat.subMeshes[0].indices[i]);
        }
        mesh.subMeshes[s].indices = kept;
    }
    TestMesh oneBuffer = mesh;
    TestBuffer& buffer = oneBuffer.buffers[0];
    const std::uint32_t first = buffer.vertexCount();
    buffer.positions.insert(buffer.positions.end(), mesh.buffers[1].positions.begin(), mesh.buffers[1].positions.end());
    buffer.normals.insert(buffer.normals.end(), mesh.buffers[1].normals.begin(), mesh.buffers[1].normals.end());
    buffer.uvSets[0].insert(buffer.uvSets[0].end(), mesh.buffers[1].uvSets[0].begin(), mesh.buffers[1].uvSets[0].end());
    for (const std::uint32_t index : oneBuffer.subMeshes[1].indices)
        oneBuffer.subMeshes[0].indices.push_back(first + index);
    oneBuffer.subMeshes.pop_back();
    oneBuffer.buffers.pop_back();

    const LodChain chain =
        simplifyChecked(oneBuffer.view(), {removedVertices(42)}, geometryOptions(Metric::Curvature, true));
    std::size_t onSeam = 0;
    for (const Point& position : positionsIn(oneBuffer, chain.levels[0]))
        onSeam += position[0] == 4.0;
    EXPECT_EQ(chain.levels[0].vertices, 39u) << "32 on the border, 7 on the seam";
    EXPECT_EQ(onSeam, 9u);
}

class AnyMetric : public testing::TestWithParam<Metric> {};

TEST_P(AnyMetric, TakesTheCheapestFirst)
{
    const double heights[] = {0.8, 0.2, 0.5};
    TestMesh mesh = makePyramid(heights[0]);
    mesh = joined(mesh, translated(makePyramid(heights[1]), 10, 0, 0));
    mesh = joined(mesh, translated(makePyramid(heights[2]), 20, 0, 0));
    const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(1), removedVertices(2), removedVertices(3)},
                                           geometryOptions(GetParam(), true));
    const auto hasApex = [&](std::size_t level, double x, double height) {
        return positionsIn(mesh, chain.levels[level]).count({x, 0.0, static_cast<float>(height)}) != 0;
    };
    EXPECT_TRUE(hasApex(0, 0, 0.8) && !hasApex(0, 10, 0.2) && hasApex(0, 20, 0.5));
    EXPECT_TRUE(hasApex(1, 0, 0.8) && !hasApex(1, 10, 0.2) && !hasApex(1, 20, 0.5));
    EXPECT_TRUE(!hasApex(2, 0, 0.8) && !hasApex(2, 10, 0.2) && !hasApex(2, 20, 0.5));
    EXPECT_LT(chain.levels[0].cost, chain.levels[1].cost);
    EXPECT_LT(chain.levels[1].cost, chain.levels[2].cost);
}

TEST_P(AnyMetric, ScaleByAPowerOfTwoChangesNothing)
{
    for (const TestMesh& mesh : {makeTerrain(16), makeUvSphere(16, 10), flatShaded(makeTorus(12, 8)), makeCube(3)}) {
        SimplifyOptions options;
        options.metric = GetParam();
        const std::vector<LevelTarget> targets = {removedShare(0.5), removedShare(0.8)};
        const LodChain chain = simplifyChecked(mesh.view(), targets, options);
        for (const double factor : {1024.0, 1.0 / 64.0}) {
            const TestMesh other = scaled(mesh, factor);
            const LodChain same = simplifyChecked(other.view(), targets, options);
            for (std::size_t i = 0; i < targets.size(); ++i) {
                EXPECT_EQ(same.levels[i].indices, chain.levels[i].indices) << "factor " << factor;
                EXPECT_EQ(same.levels[i].deviation, chain.levels[i].deviation * factor);
                EXPECT_EQ(same.levels[i].cost, chain.levels[i].cost * factor);
            }
        }
    }
}

TEST_P(AnyMetric, FlatDetailGoesBeforeShape)
{
    // A flat half and a hilly half: the flat one pays first.
    const TestMesh mesh = makePatch(24, 12, [](double u, double v) {
        const double hill = u <= 0.5 ? 0.0 : 0.15 * std::sin(20.0 * (u - 0.5)) * std::cos(15.0 * v);
        return Point{2.0 * u, v, hill};
    });
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.4)}, geometryOptions(GetParam()));
    std::size_t flat = 0, hilly = 0;
    for (const Point& position : positionsIn(mesh, chain.levels[0]))
        ++(position[0] < 1.0 ? flat : hilly);
    EXPECT_LT(4 * flat, hilly);
}

INSTANTIATE_TEST_SUITE_P(Both, AnyMetric, testing::Values(Metric::Quadric, Metric::Curvature),
                         [](const auto& info) { return info.param == Metric::Quadric ? "Quadric" : "Curvature"; });

} // namespace

} // namespace lodsmith
