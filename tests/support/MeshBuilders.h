#pragma once

#include <lodsmith/core/LodChain.h>
#include <lodsmith/core/MeshView.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

/// Meshes built in code for the tests of every room: small, owned, without any file or engine.
namespace lodsmith::test {

/// A vertex buffer with its own memory. A stream that is empty is absent from the view.
struct TestBuffer {
    std::vector<float> positions;            ///< 3 floats a vertex
    std::vector<float> normals;              ///< 3 floats a vertex
    std::vector<std::vector<float>> uvSets;  ///< 2 floats a vertex each
    std::vector<float> colours;              ///< 4 floats a vertex
    std::vector<BoneInfluences> bones;       ///< one entry a vertex
    std::vector<std::vector<float>> offsets; ///< 3 floats a vertex each
    std::vector<std::vector<float>> poses;   ///< 3 floats a vertex each
    std::vector<float> importance;           ///< 1 float a vertex

    std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(positions.size() / 3); }
    /// Appends a vertex and returns its number. The other streams are the caller's to keep in step.
    std::uint32_t addPosition(double x, double y, double z);
    void addNormal(double x, double y, double z);
    void addUv(double u, double v, std::size_t set = 0);
};

struct TestSubMesh {
    std::uint32_t vertexBuffer = 0;
    std::vector<std::uint32_t> indices;

    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    /// Two triangles; corners counter-clockwise, split from `a` to `c`.
    void addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
};

/// A mesh with its own memory. Views on it live as long as it does and is not changed.
struct TestMesh {
    std::vector<TestBuffer> buffers;
    std::vector<TestSubMesh> subMeshes;

    MeshView view() const;
    /// The same vertex buffers drawn with the indices of a level, which must outlive the view.
    MeshView view(const LodChainLevel& level) const;
    std::size_t triangleCount() const;
};

using Point = std::array<double, 3>;

/// A surface as a function of (u, v) in 0..1 x 0..1.
using Shape = std::function<Point(double u, double v)>;

/// `columns` x `rows` quads over a shape; UVs are u and v, normals are those of the neighbouring faces, smoothed.
TestMesh makePatch(std::uint32_t columns, std::uint32_t rows, const Shape& shape);
/// A flat square of `columns` x `rows` quads, corners (0,0,0) and (size,size,0), facing +z.
TestMesh makeGrid(std::uint32_t columns, std::uint32_t rows, double size = 1.0);
/// Smooth hills of height about 0.1 over the unit square, the same for every resolution.
TestMesh makeTerrain(std::uint32_t cells);

/// A sphere with a UV seam from pole to pole and one wedge a sector at each pole; smooth normals, watertight once
/// welded. One vertex at each pole is used by no triangle; poles mix +0 and -0 coordinates.
TestMesh makeUvSphere(std::uint32_t sectors, std::uint32_t rings, double radius = 1.0);
/// An icosahedron split `subdivisions` times: 20 * 4^subdivisions triangles, every vertex on the sphere; normals, no
/// UVs.
TestMesh makeIcosphere(std::uint32_t subdivisions, double radius = 1.0);
/// A ring around the z axis with a UV seam both ways; smooth normals, watertight once welded, genus 1.
TestMesh makeTorus(std::uint32_t sectors, std::uint32_t sides, double majorRadius = 1.0, double minorRadius = 0.3);
/// A tube around the z axis from z = 0 to `height`, open at both ends, with one UV seam; smooth normals.
TestMesh makeCylinder(std::uint32_t sectors, std::uint32_t stacks, double radius = 1.0, double height = 2.0);
/// A cube from -size/2 to size/2 with `cells` x `cells` quads a side: hard normals, so 3 wedges at each corner; UVs
/// 0..1 a side.
TestMesh makeCube(std::uint32_t cells = 1, double size = 2.0);
/// Four vertices, four triangles, faces outward; neither normals nor UVs.
TestMesh makeTetrahedron();

/// A unit square wall in z = 0 seen from both sides: each side has its own vertices, at equal positions.
TestMesh makeTwoSidedWall(std::uint32_t cells);
/// Two strips that touch along y = 0 at rest and open in the single pose (upper by +0.2, lower by -0.2 at that line):
/// they must not be welded there.
TestMesh makeClosedLips(std::uint32_t cells);
/// The same shut mouth, opened by bones instead: upper strip on bone 1, lower on bone 2.
TestMesh makeSkinnedLips(std::uint32_t cells);
/// A tube around the z axis whose lower half follows bone 0, upper half bone 1, blended around the middle.
TestMesh makeSkinnedTube(std::uint32_t sectors, std::uint32_t stacks);
/// The same with a pose for each angle, by which bone 1 is turned about an axis along x through the tube's middle.
TestMesh makeBentTube(std::uint32_t sectors, std::uint32_t stacks, const std::vector<double>& degrees);

/// `triangles` around one centre, a closed disc in z = 0.
TestMesh makeFan(std::uint32_t triangles);
/// `pages` triangles that share one edge: non-manifold from 3 on.
TestMesh makeBook(std::uint32_t pages);
/// `count` tetrahedra in a row, 3 units apart.
TestMesh makeIslands(std::uint32_t count);
/// `count` leaf cards (two-triangle quads with UVs 0..1) scattered in the unit cube.
TestMesh makeLeafCards(std::uint32_t count, std::uint32_t seed = 1);
/// Triangles that share nothing, corners anywhere in the unit cube.
TestMesh makeSoup(std::uint32_t triangles, std::uint32_t seed = 1);
/// A flat grid whose left half is submesh 0 and right half submesh 1; with own buffers they meet at equal positions.
TestMesh makeTwoMaterials(std::uint32_t cells, bool sharedBuffer);

/// Every triangle gets vertices of its own with the normal of its face: the worst case for wedges.
TestMesh flatShaded(const TestMesh& mesh);
/// Every submesh of `second` after those of `first`, with buffers of its own.
TestMesh joined(const TestMesh& first, const TestMesh& second);
/// Positions (and offsets and poses) times `factor`.
TestMesh scaled(TestMesh mesh, double factor);
TestMesh translated(TestMesh mesh, double x, double y, double z);
/// Winding turned over; normals stay.
TestMesh turnedInsideOut(TestMesh mesh);
/// Positions moved by up to `amount` along each axis, equal positions by the same.
TestMesh jittered(TestMesh mesh, double amount, std::uint32_t seed = 1);

/// Numbers that are the same with every standard library.
class TestRandom {
public:
    explicit TestRandom(std::uint32_t seed) : mState(seed * 0x9e3779b97f4a7c15ull + 0x632be59bd9b4e019ull) {}

    std::uint32_t bits();
    double uniform(); ///< 0 <= x < 1
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

private:
    std::uint64_t mState;
};

} // namespace lodsmith::test
