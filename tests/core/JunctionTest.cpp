#include "support/CheckedSimplify.h"
#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace lodsmith {

namespace {

using namespace test;

using Position = std::array<float, 3>;

/// Three flat sheets of one material that meet on the x axis, two of them on each other: leaving the axis costs nothing, and
/// its way is the shortest. Positions only.
TestMesh makeJunction(std::uint32_t cells)
{
    TestMesh mesh;
    mesh.buffers.resize(1);
    mesh.subMeshes.resize(1);
    for (const double width : {1.0, -1.0, 0.93}) {
        const TestMesh sheet = makePatch(cells, cells, [width](double u, double v) {
            return Point{u, width * v, 0.0};
        });
        const std::uint32_t first = mesh.buffers[0].vertexCount();
        std::vector<float>& positions = mesh.buffers[0].positions;
        positions.insert(positions.end(), sheet.buffers[0].positions.begin(), sheet.buffers[0].positions.end());
        for (const std::uint32_t index : sheet.subMeshes[0].indices)
            mesh.subMeshes[0].indices.push_back(first + index);
    }
    return mesh;
}

Position positionOf(const TestMesh& mesh, std::uint32_t index)
{
    const float* p = &mesh.buffers[0].positions[std::size_t{3} * index];
    return {p[0], p[1], p[2]};
}

std::map<std::pair<Position, Position>, int> facesOfEdges(const TestMesh& mesh, const LodChainLevel& level)
{
    std::map<std::pair<Position, Position>, int> faces;
    const std::vector<std::uint32_t>& indices = level.indices[0];
    for (std::size_t i = 0; i < indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k)
            ++faces[std::minmax(positionOf(mesh, indices[i + k]), positionOf(mesh, indices[i + (k + 1) % 3]))];
    return faces;
}

TEST(Junction, StaysOnItsLine)
{
    const TestMesh mesh = makeJunction(16);
    const LodChain chain =
        simplifyChecked(mesh.view(), {removedShare(0.5), removedShare(0.75), removedShare(0.875), removedShare(0.95)});
    for (const LodChainLevel& level : chain.levels) {
        int onLine = 0;
        for (const auto& [edge, faces] : facesOfEdges(mesh, level)) {
            if (faces < 3)
                continue;
            EXPECT_EQ(edge.first[1], 0.0f);
            EXPECT_EQ(edge.second[1], 0.0f);
            ++onLine;
        }
        EXPECT_GE(onLine, 1) << "the sheets have come apart";
    }
}

TEST(Junction, OfATwoSidedWallStopsNothing)
{
    const TestMesh mesh = makeTwoSidedWall(16);
    const LodChain chain = simplifyChecked(mesh.view(), {removedShare(0.9)});
    EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached);
}

} // namespace

} // namespace lodsmith
