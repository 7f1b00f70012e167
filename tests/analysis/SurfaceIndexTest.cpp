#include "SurfaceIndex.h"

#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace lodsmith;
using namespace lodsmith::analysis;
using namespace lodsmith::test;

namespace {

/// A mesh with everything that a SurfaceIndex needs to stay alive.
struct IndexedMesh {
    explicit IndexedMesh(const TestMesh& source)
        : mesh(source), view(mesh.view()), triangles(weldTriangles(view, table).value()), frame(table.positions()),
          points(localPoints()), surface(view, triangles, points), index(SurfaceIndex::create(surface).value())
    {
    }

    std::vector<Vec3> localPoints() const
    {
        std::vector<Vec3> local;
        for (const Position& position : table.positions())
            local.push_back(frame.toLocal(position));
        return local;
    }

    TestMesh mesh;
    MeshView view;
    PositionTable table;
    std::vector<WeldedTriangle> triangles;
    LocalFrame frame;
    std::vector<Vec3> points;
    Surface surface;
    SurfaceIndex index;
};

template <class Accept>
ClosestHit bruteForce(const Surface& surface, const Vec3& point, Accept accept)
{
    ClosestHit best;
    best.point.squaredDistance = 1e300;
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        const TrianglePoint near = closestPointOnTriangle(point, surface.corners(i));
        if (accept(i) && near.squaredDistance < best.point.squaredDistance)
            best = {near, i};
    }
    return best;
}

void expectBruteForce(const TestMesh& mesh, std::uint32_t seed)
{
    const IndexedMesh indexed(mesh);
    const Surface& surface = indexed.surface;
    TestRandom random(seed);
    for (int i = 0; i < 500; ++i) {
        const double reach = i % 2 ? 0.5 : 0.05;
        const std::uint32_t near = random.bits() % surface.triangleCount();
        const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
        const Vec3 point = surface.corners(near)[0] + Vec3{x, y, random.uniform(-reach, reach)};

        const ClosestHit expected = bruteForce(surface, point, [](std::uint32_t) { return true; });
        const ClosestHit found = indexed.index.closest(point, random.bits() % surface.triangleCount());
        EXPECT_EQ(found.point.squaredDistance, expected.point.squaredDistance);
        EXPECT_EQ(found.triangle, expected.triangle);

        const std::uint32_t subMesh = surface.subMesh(near);
        const ClosestHit expectedOwn =
            bruteForce(surface, point, [&](std::uint32_t t) { return surface.subMesh(t) == subMesh; });
        const ClosestHit foundOwn = indexed.index.closestInSubMesh(point, subMesh);
        EXPECT_EQ(foundOwn.triangle, expectedOwn.triangle);

        std::set<std::uint32_t> within, visited;
        const double radius = random.uniform(0.0, 0.3);
        for (std::uint32_t t = 0; t < surface.triangleCount(); ++t)
            if (closestPointOnTriangle(point, surface.corners(t)).squaredDistance <= radius * radius)
                within.insert(t);
        indexed.index.visitWithin(point, radius, [&](std::uint32_t triangle, const TrianglePoint&) {
            EXPECT_TRUE(visited.insert(triangle).second);
            return true;
        });
        EXPECT_EQ(visited, within);
    }
}

} // namespace

TEST(SurfaceIndex, AgreesWithBruteForceOnSoup)
{
    for (std::uint32_t seed = 1; seed <= 3; ++seed)
        expectBruteForce(makeSoup(200, seed), seed);
}

TEST(SurfaceIndex, AgreesWithBruteForceWhereManyTrianglesAreEquallyNear)
{
    expectBruteForce(makeTwoSidedWall(6), 1);
    expectBruteForce(joined(makeCube(3), makeCube(3)), 2);
    expectBruteForce(makeFan(50), 3);
}

TEST(SurfaceIndex, AgreesWithBruteForceOnSubMeshes)
{
    expectBruteForce(joined(makeLeafCards(60), makeCylinder(12, 4, 0.1, 1.0)), 4);
}

TEST(SurfaceIndex, AgreesWithBruteForceAtEverySize)
{
    for (const double scale : {1e18, 1e37, 1e-30, 1e-37})
        expectBruteForce(scaled(makeSoup(100), scale), 5);
    expectBruteForce(translated(makeSoup(100), 1e4, -3e3, 0.0), 6);
}

TEST(SurfaceIndex, AgreesWithBruteForceOnNeedles)
{
    TestMesh needles = makeSoup(200, 9);
    std::vector<float>& positions = needles.buffers[0].positions;
    for (std::size_t i = 0; i < positions.size(); i += 9)
        for (std::size_t axis = 0; axis < 3; ++axis)
            positions[i + 6 + axis] = 0.25f * positions[i + axis] + 0.75f * positions[i + 3 + axis];
    expectBruteForce(needles, 7);
}

TEST(SurfaceIndex, VisitStopsWhenAsked)
{
    const IndexedMesh indexed(makeGrid(8, 8));
    int visits = 0;
    indexed.index.visitWithin(Vec3{}, 10.0, [&](std::uint32_t, const TrianglePoint&) { return ++visits < 5; });
    EXPECT_EQ(visits, 5);
}
