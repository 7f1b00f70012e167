#include "Leaves.h"

#include "../analysis/EdgeUses.h"
#include "../analysis/WeldedMesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace lodsmith::generators {

namespace {

using analysis::EdgeUse;
using analysis::PositionTable;
using analysis::Repetition;
using analysis::WeldedTriangle;

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr std::size_t kMostLeafTriangles = 64;
constexpr std::size_t kLeastLeaves = 8;
constexpr double kMostExtent = 0.75;  // of the mesh's radius
constexpr double kLeastShare = 0.5;   // of the mesh's area
constexpr double kMostOfLeaves = 0.2; // of the area of all leaves

/// Sets of triangles, named for their first one.
class TriangleSets {
public:
    explicit TriangleSets(std::size_t count) : mParent(count) { std::iota(mParent.begin(), mParent.end(), 0u); }

    std::uint32_t find(std::uint32_t triangle)
    {
        while (mParent[triangle] != triangle)
            triangle = mParent[triangle] = mParent[mParent[triangle]];
        return triangle;
    }

    void unite(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        mParent[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> mParent;
};

/// What tells whether a piece is a leaf. Triangles that repeat another one, whichever way round, are backs, and no
/// faces.
struct Piece {
    std::vector<std::uint32_t> triangles;
    std::int64_t vertices = 0;
    std::int64_t edges = 0;
    std::int64_t faces = 0;
    bool isOpen = false;

    bool isDisc() const { return isOpen && vertices - edges + faces == 1; }
};

double distance(const Point& a, const Point& b)
{
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

Leaf makeLeaf(std::vector<LeafTriangle> triangles)
{
    Leaf leaf;
    for (const LeafTriangle& triangle : triangles) {
        const double area = areaOf(triangle.corner);
        leaf.area += area;
        for (std::size_t axis = 0; axis < 3; ++axis)
            leaf.centre[axis] +=
                area * (triangle.corner[0][axis] + triangle.corner[1][axis] + triangle.corner[2][axis]) / 3.0;
    }
    if (leaf.area > 0.0)
        for (double& component : leaf.centre)
            component /= leaf.area;
    leaf.forms.push_back(std::move(triangles));
    return leaf;
}

/// How far a leaf extends from the middle of its bounding box, at most.
double extentOf(const Leaf& leaf)
{
    Point low = leaf.forms[0][0].corner[0], high = low;
    for (const LeafTriangle& triangle : leaf.forms[0])
        for (const Point& corner : triangle.corner)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], corner[axis]);
                high[axis] = std::max(high[axis], corner[axis]);
            }
    return distance(low, high) / 2.0;
}

class LeafFinder {
public:
    LeafFinder(const MeshView& mesh, const FoliageOptions& options) : mMesh(mesh), mOptions(options) {}

    Result<Foliage> find()
    {
        Result<std::vector<WeldedTriangle>> welded = weldTriangles(mMesh, mTable);
        if (!welded)
            return welded.error();
        mTriangles = std::move(welded).value();
        measure();
        gatherPieces();
        mFoliage.wood.resize(mMesh.subMeshes.size());
        for (const Piece& piece : mPieces)
            sortOut(piece);
        if (!isFoliage())
            return Foliage{};
        return std::move(mFoliage);
    }

private:
    Point point(std::uint32_t position) const
    {
        const analysis::Position& p = mTable.positions()[position];
        return {p[0], p[1], p[2]};
    }

    void measure()
    {
        if (mTable.size() == 0)
            return;
        Point low = point(0), high = low;
        for (std::uint32_t i = 1; i < mTable.size(); ++i)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], point(i)[axis]);
                high[axis] = std::max(high[axis], point(i)[axis]);
            }
        for (std::size_t axis = 0; axis < 3; ++axis)
            mFoliage.centre[axis] = (low[axis] + high[axis]) / 2.0;
        for (std::uint32_t i = 0; i < mTable.size(); ++i)
            mFoliage.radius = std::max(mFoliage.radius, distance(mFoliage.centre, point(i)));
    }

    void gatherPieces()
    {
        std::vector<bool> collapsed;
        for (const WeldedTriangle& triangle : mTriangles)
            collapsed.push_back(triangle.collapsed());
        const std::vector<EdgeUse> uses = sortedEdgeUses(mTriangles, collapsed);
        const std::vector<bool> repeated = findRepeated(mTriangles, Repetition::AnyWinding);
        TriangleSets sets(mTriangles.size());
        forEachEdge(uses, [&](const EdgeUse* use, std::size_t count) {
            for (std::size_t i = 1; i < count; ++i)
                sets.unite(use[0].triangle, use[i].triangle);
        });
        uniteOverVertices(sets);
        numberPieces(sets);
        forEachEdge(uses, [&](const EdgeUse* use, std::size_t count) {
            Piece& piece = mPieces[mPieceOf[use[0].triangle]];
            ++piece.edges;
            piece.isOpen |=
                std::count_if(use, use + count, [&](const EdgeUse& u) { return !repeated[u.triangle]; }) == 1;
        });
        for (std::size_t i = 0; i < mTriangles.size(); ++i)
            mPieces[mPieceOf[i]].faces += repeated[i] || collapsed[i] ? 0 : 1;
        countVertices();
    }

    /// A vertex can only be in one place, so that pieces which share one are enlarged as one.
    void uniteOverVertices(TriangleSets& sets) const
    {
        std::vector<std::vector<std::uint32_t>> firstUse(mMesh.vertexBuffers.size());
        for (std::size_t i = 0; i < firstUse.size(); ++i)
            firstUse[i].resize(mMesh.vertexBuffers[i].vertexCount, kNone);
        for (std::uint32_t i = 0; i < mTriangles.size(); ++i)
            for (const std::uint32_t vertex : mTriangles[i].vertex) {
                std::uint32_t& first = firstUse[mMesh.subMeshes[mTriangles[i].subMesh].vertexBuffer][vertex];
                if (first == kNone)
                    first = i;
                else
                    sets.unite(first, i);
            }
    }

    void numberPieces(TriangleSets& sets)
    {
        mPieceOf.resize(mTriangles.size());
        for (std::uint32_t i = 0; i < mTriangles.size(); ++i) {
            const std::uint32_t first = sets.find(i);
            if (first == i) {
                mPieceOf[i] = static_cast<std::uint32_t>(mPieces.size());
                mPieces.emplace_back();
            } else
                mPieceOf[i] = mPieceOf[first];
            mPieces[mPieceOf[i]].triangles.push_back(i);
        }
    }

    void countVertices()
    {
        for (Piece& piece : mPieces) {
            std::vector<std::uint32_t> positions;
            for (const std::uint32_t triangle : piece.triangles)
                for (const std::uint32_t position : mTriangles[triangle].position)
                    positions.push_back(position);
            std::sort(positions.begin(), positions.end());
            piece.vertices = std::unique(positions.begin(), positions.end()) - positions.begin();
        }
    }

    bool maybeLeaf(const Piece& piece) const
    {
        const std::vector<bool>& allowed = mOptions.leafSubMeshes;
        return piece.isDisc() && piece.triangles.size() <= kMostLeafTriangles
               && (allowed.empty()
                   || std::all_of(piece.triangles.begin(), piece.triangles.end(),
                                  [&](std::uint32_t triangle) { return allowed[mTriangles[triangle].subMesh]; }));
    }

    void sortOut(const Piece& piece)
    {
        if (maybeLeaf(piece)) {
            std::vector<LeafTriangle> triangles;
            for (const std::uint32_t triangle : piece.triangles)
                triangles.push_back(leafTriangle(mTriangles[triangle]));
            Leaf leaf = makeLeaf(std::move(triangles));
            mArea += leaf.area;
            if (leaf.area == 0.0)
                return;
            if (extentOf(leaf) <= kMostExtent * mFoliage.radius) {
                mFoliage.leaves.push_back(std::move(leaf));
                return;
            }
            mArea -= leaf.area;
        }
        for (const std::uint32_t number : piece.triangles) {
            const WeldedTriangle& triangle = mTriangles[number];
            mArea += areaOf(leafTriangle(triangle).corner);
            auto& indices = mFoliage.wood[triangle.subMesh];
            indices.insert(indices.end(), triangle.vertex.begin(), triangle.vertex.end());
        }
    }

    LeafTriangle leafTriangle(const WeldedTriangle& triangle) const
    {
        return {triangle.subMesh,
                triangle.vertex,
                {point(triangle.position[0]), point(triangle.position[1]), point(triangle.position[2])}};
    }

    bool isFoliage() const
    {
        if (!mOptions.leafSubMeshes.empty())
            return !mFoliage.leaves.empty();
        double leaves = 0.0, largest = 0.0;
        for (const Leaf& leaf : mFoliage.leaves) {
            leaves += leaf.area;
            largest = std::max(largest, leaf.area);
        }
        return mFoliage.leaves.size() >= kLeastLeaves && leaves >= kLeastShare * mArea
               && largest <= kMostOfLeaves * leaves;
    }

    const MeshView& mMesh;
    const FoliageOptions& mOptions;
    PositionTable mTable;
    std::vector<WeldedTriangle> mTriangles;
    std::vector<Piece> mPieces;
    std::vector<std::uint32_t> mPieceOf; // by triangle
    double mArea = 0.0;                  // of the whole mesh
    Foliage mFoliage;
};

} // namespace

double areaOf(const std::array<Point, 3>& corner)
{
    Point u, v;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        u[axis] = corner[1][axis] - corner[0][axis];
        v[axis] = corner[2][axis] - corner[0][axis];
    }
    const Point normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    return distance(normal, Point{}) / 2.0;
}

Result<Foliage> findLeaves(const MeshView& mesh, const FoliageOptions& options)
{
    return LeafFinder(mesh, options).find();
}

} // namespace lodsmith::generators
