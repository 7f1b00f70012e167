#include <lodsmith/generators/FoliageLevels.h>

#include "LayerPictures.h"
#include "LeafChoice.h"
#include "LeafForms.h"
#include "Leaves.h"

#include <lodsmith/core/Assert.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <utility>

namespace lodsmith {

namespace {

using generators::ChosenLeaf;
using generators::Foliage;
using generators::LayerPictures;
using generators::Leaf;
using generators::LeafChoice;
using generators::LeafTriangle;
using generators::Opacity;
using generators::Point;

// A leaf's pixels on average, face on: fewer make choices random, more make them slow. Many leaves even chance out.
constexpr double kMostPixelsPerLeaf = 32.0;
constexpr double kLeastPixelsPerLeaf = 6.0;
constexpr double kPixelsOfAllLeaves = 30000.0;
constexpr double kLeastPixels = 32.0; // of the sphere's diameter
constexpr double kMostPixels = 256.0;
constexpr double kLeastOpacity = 0.05;
constexpr double kWoodStep = 0.8;     // from one simplification of the wood to the next
constexpr double kEnoughKept = 0.955; // of the original's outline
// How much worse a pixel beyond the outline is than one within it that is missing: 1, more where that leaves enough,
// and less where 1 does not.
constexpr double kStrictWeights[] = {4.0, 2.0};
constexpr double kLooseWeights[] = {0.5, 0.25};
// What wood may have of a level's triangles: the best of these is taken.
constexpr double kWoodShares[] = {0.25, 0.4, 0.55, 0.7};

using IndexLists = std::vector<std::vector<std::uint32_t>>;

MeshView withIndices(MeshView view, const IndexLists& indices)
{
    for (std::size_t i = 0; i < view.subMeshes.size(); ++i) {
        view.subMeshes[i].indices = indices[i].data();
        view.subMeshes[i].indexCount = static_cast<std::uint32_t>(indices[i].size());
        view.subMeshes[i].indexBytes = 4;
    }
    return view;
}

std::uint32_t trianglesIn(const IndexLists& lists)
{
    std::size_t count = 0;
    for (const auto& list : lists)
        count += list.size() / 3;
    return static_cast<std::uint32_t>(count);
}

Point pointAt(const FloatStream& stream, std::uint32_t vertex)
{
    float values[3];
    stream.read(vertex, 3, values);
    return {values[0], values[1], values[2]};
}

/// What is no leaf, simplified so far.
struct Wood {
    IndexLists indices;
    std::uint32_t triangles = 0;
};

/// The places of vertices while leaves are enlarged.
class Vertices {
public:
    Vertices(const MeshView& mesh, FoliageLevel& level) : mMesh(mesh), mLevel(level)
    {
        for (const VertexBufferView& buffer : mesh.vertexBuffers) {
            level.positions.push_back(copy(buffer.positions, buffer.vertexCount));
            level.offsets.emplace_back();
            for (const FloatStream& offsets : buffer.offsets)
                level.offsets.back().push_back(copy(offsets, buffer.vertexCount));
        }
    }

    /// The whole leaf, in all its vertices, so that the forms have the same.
    void enlarge(const Leaf& leaf, double scale)
    {
        const auto bufferOf = [this](const LeafTriangle& triangle) {
            return mMesh.subMeshes[triangle.subMesh].vertexBuffer;
        };
        for (const LeafTriangle& triangle : leaf.forms[0])
            move(mMesh.vertexBuffers[bufferOf(triangle)].positions, mLevel.positions[bufferOf(triangle)], triangle,
                 leaf.centre, scale);
        const std::uint32_t buffer = bufferOf(leaf.forms[0][0]);
        for (std::size_t i = 0; i < mLevel.offsets[buffer].size(); ++i) {
            const FloatStream& from = mMesh.vertexBuffers[buffer].offsets[i];
            const Point centre = meanOffset(leaf, from);
            for (const LeafTriangle& triangle : leaf.forms[0])
                if (bufferOf(triangle) == buffer)
                    move(from, mLevel.offsets[buffer][i], triangle, centre, scale);
        }
    }

private:
    static std::vector<float> copy(const FloatStream& stream, std::uint32_t count)
    {
        std::vector<float> values(3 * std::size_t(count));
        for (std::uint32_t i = 0; i < count; ++i)
            stream.read(i, 3, &values[3 * std::size_t(i)]);
        return values;
    }

    static void move(const FloatStream& from, std::vector<float>& to, const LeafTriangle& triangle, const Point& centre,
                     double scale)
    {
        for (const std::uint32_t vertex : triangle.vertex) {
            const Point point = pointAt(from, vertex);
            for (std::size_t axis = 0; axis < 3; ++axis)
                to[3 * std::size_t(vertex) + axis] =
                    static_cast<float>(centre[axis] + scale * (point[axis] - centre[axis]));
        }
    }

    /// How far a leaf's centre moves, which is where its surface is on average.
    static Point meanOffset(const Leaf& leaf, const FloatStream& offsets)
    {
        Point mean = {};
        for (const LeafTriangle& triangle : leaf.forms[0])
            for (const std::uint32_t vertex : triangle.vertex)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    mean[axis] += pointAt(offsets, vertex)[axis] * generators::areaOf(triangle.corner) / 3.0;
        for (double& component : mean)
            component /= leaf.area;
        return mean;
    }

    const MeshView& mMesh;
    FoliageLevel& mLevel;
};

analysis::SilhouetteFrame frameFor(const Foliage& foliage)
{
    double area = 0.0;
    for (const Leaf& leaf : foliage.leaves)
        area += leaf.area;
    const auto count = static_cast<double>(foliage.leaves.size());
    const double pixelsPerLeaf = std::clamp(kPixelsOfAllLeaves / count, kLeastPixelsPerLeaf, kMostPixelsPerLeaf);
    const double unitsPerPixel = std::sqrt(area / count / pixelsPerLeaf);
    const double pixels = std::clamp(2.0 * foliage.radius / unitsPerPixel, kLeastPixels, kMostPixels);
    return {foliage.centre, pixels / (2.0 * foliage.radius), static_cast<std::size_t>(1.25 * pixels)};
}

class FoliageMaker {
public:
    FoliageMaker(const MeshView& mesh, const FoliageOptions& options, Foliage foliage, Progress* progress)
        : mMesh(mesh), mOptions(options), mFoliage(std::move(foliage)), mProgress(progress), mFrame(frameFor(mFoliage)),
          mOpacity(options.leafOpacity), mOriginal(mFrame), mCandidates(mFoliage.leaves.size())
    {
        std::iota(mCandidates.begin(), mCandidates.end(), 0u);
    }

    Result<FoliageLevels> make(const std::vector<std::uint32_t>& budgets)
    {
        drawWood(mOriginal, mFoliage.wood);
        for (Leaf& leaf : mFoliage.leaves) {
            for (const LeafTriangle& triangle : leaf.forms[0])
                mOriginal.addLeaf(generators::project(mFrame, triangle.corner));
            if (auto added = addForms(mMesh, mOptions.simplify, leaf); !added)
                return added.error();
        }
        if (auto simplified = simplifyWood(); !simplified)
            return simplified.error();
        FoliageLevels levels;
        levels.leaves = static_cast<std::uint32_t>(mFoliage.leaves.size());
        for (const std::uint32_t budget : budgets) {
            levels.levels.push_back(makeLevel(budget));
            if (mProgress && mProgress->cancelled())
                return Error{ErrorCode::Cancelled, "cancelled"};
            if (mProgress)
                mProgress->report(static_cast<float>(levels.levels.size()) / static_cast<float>(budgets.size()));
        }
        return levels;
    }

private:
    Result<Done> simplifyWood()
    {
        mWood.push_back({mFoliage.wood, trianglesIn(mFoliage.wood)});
        std::vector<LevelTarget> targets;
        double count = kWoodStep * mWood[0].triangles;
        while (count >= 1.0) {
            targets.push_back({LevelTarget::Kind::Triangles, count});
            count *= kWoodStep;
        }
        if (targets.empty())
            return Done{};
        Result<LodChain> chain = simplify(withIndices(mMesh, mFoliage.wood), targets, mOptions.simplify, mProgress);
        if (!chain)
            return chain.error();
        for (LodChainLevel& level : chain.value().levels)
            if (!level.skipped)
                mWood.push_back({std::move(level.indices), level.triangles});
        return Done{};
    }

    void drawWood(LayerPictures& pictures, const IndexLists& indices) const
    {
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const FloatStream& positions = mMesh.vertexBuffers[mMesh.subMeshes[i].vertexBuffer].positions;
            for (std::size_t k = 0; k < indices[i].size(); k += 3)
                pictures.addWood(generators::project(mFrame, {pointAt(positions, indices[i][k]),
                                                              pointAt(positions, indices[i][k + 1]),
                                                              pointAt(positions, indices[i][k + 2])}));
        }
    }

    /// The simplifications of the wood that are worth a try for so many triangles; none when even the last has more.
    std::vector<const Wood*> woodFor(std::uint32_t budget) const
    {
        std::vector<const Wood*> woods;
        for (const double share : kWoodShares) {
            const auto fits = [&](const Wood& wood) { return wood.triangles <= share * budget; };
            const auto wood = std::find_if(mWood.begin(), mWood.end(), fits);
            if (wood != mWood.end() && (woods.empty() || woods.back() != &*wood))
                woods.push_back(&*wood);
        }
        if (woods.empty() && mWood.back().triangles <= budget)
            woods.push_back(&mWood.back());
        return woods;
    }

    struct Plan {
        const Wood* wood = nullptr;
        LeafChoice choice;
    };

    Plan plan(const Wood& wood, std::uint32_t budget, double excessWeight) const
    {
        LayerPictures pictures(mFrame);
        drawWood(pictures, wood.indices);
        return {&wood, generators::chooseLeaves({mFrame, mOpacity, mFoliage.leaves, mCandidates, mOriginal, pictures,
                                                 budget - wood.triangles, excessWeight},
                                                mProgress)};
    }

    /// The wood that serves best, then as little beyond the outline as leaves enough of what is inside.
    Plan bestPlan(std::uint32_t budget) const
    {
        Plan best;
        for (const Wood* wood : woodFor(budget)) {
            Plan tried = plan(*wood, budget, 1.0);
            if (!best.wood || tried.choice.value > best.choice.value)
                best = std::move(tried);
        }
        if (!best.wood)
            return best;
        if (best.choice.kept < kEnoughKept) {
            for (const double weight : kLooseWeights)
                if (best.choice.kept < kEnoughKept)
                    best = plan(*best.wood, budget, weight);
            return best;
        }
        for (const double weight : kStrictWeights) {
            Plan tried = plan(*best.wood, budget, weight);
            if (tried.choice.kept >= kEnoughKept)
                return tried;
        }
        return best;
    }

    FoliageLevel makeLevel(std::uint32_t budget)
    {
        FoliageLevel level;
        const Plan plan = bestPlan(budget);
        if (!plan.wood)
            return level;
        level.made = true;
        level.indices = plan.wood->indices;
        Vertices vertices(mMesh, level);
        for (const ChosenLeaf& choice : plan.choice.leaves) {
            const Leaf& leaf = mFoliage.leaves[choice.leaf];
            const double scale = generators::kLeafScales[choice.scale];
            vertices.enlarge(leaf, scale);
            for (const LeafTriangle& triangle : leaf.forms[choice.form]) {
                auto& indices = level.indices[triangle.subMesh];
                indices.insert(indices.end(), triangle.vertex.begin(), triangle.vertex.end());
            }
            level.leaves.push_back(choice.leaf);
            level.largestScale = std::max(level.largestScale, scale);
        }
        level.triangles = trianglesIn(level.indices);
        mCandidates = level.leaves;
        return level;
    }

    const MeshView& mMesh;
    const FoliageOptions& mOptions;
    Foliage mFoliage;
    Progress* mProgress;
    analysis::SilhouetteFrame mFrame;
    Opacity mOpacity;
    LayerPictures mOriginal; // the whole mesh
    std::vector<Wood> mWood; // less and less of it
    std::vector<std::uint32_t> mCandidates;
};

Result<Done> checkOptions(const MeshView& mesh, const FoliageOptions& options)
{
    if (!(options.leafOpacity >= kLeastOpacity && options.leafOpacity <= 1.0))
        return Error{ErrorCode::InvalidSetting, "the opacity of leaves is from 0.05 to 1"};
    if (!options.leafSubMeshes.empty() && options.leafSubMeshes.size() != mesh.subMeshes.size())
        return Error{ErrorCode::InvalidSetting, "leafSubMeshes needs an entry for each submesh"};
    return Done{};
}

} // namespace

MeshView FoliageLevel::view(const MeshView& original) const
{
    LODSMITH_ASSERT(made, "a level that was not made has no view");
    MeshView view = withIndices(original, indices);
    for (std::size_t i = 0; i < view.vertexBuffers.size(); ++i) {
        VertexBufferView& buffer = view.vertexBuffers[i];
        buffer.positions = {positions[i].data(), 3 * sizeof(float)};
        buffer.poses.clear(); // which show the leaves as they were
        for (std::size_t k = 0; k < buffer.offsets.size(); ++k)
            buffer.offsets[k] = {offsets[i][k].data(), 3 * sizeof(float)};
    }
    return view;
}

Result<FoliageLevels> foliageLevels(const MeshView& mesh, const std::vector<std::uint32_t>& triangles,
                                    const FoliageOptions& options, Progress* progress)
{
    LODSMITH_ASSERT(std::is_sorted(triangles.rbegin(), triangles.rend()), "levels have fewer and fewer triangles");
    if (auto checked = checkOptions(mesh, options); !checked)
        return checked.error();
    try {
        Result<Foliage> foliage = generators::findLeaves(mesh, options);
        if (!foliage)
            return foliage.error();
        if (foliage.value().leaves.empty() || triangles.empty())
            return FoliageLevels{static_cast<std::uint32_t>(foliage.value().leaves.size()), {}};
        return FoliageMaker(mesh, options, std::move(foliage).value(), progress).make(triangles);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "there is not enough memory for the levels of the foliage"};
    }
}

} // namespace lodsmith
