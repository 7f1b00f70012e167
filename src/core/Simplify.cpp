#include <lodsmith/core/Simplify.h>

#include "Attributes.h"
#include "CurvatureCost.h"
#include "PartRounds.h"
#include "QuadricCost.h"
#include "Simplifier.h"
#include "Watch.h"
#include "Weld.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <optional>

namespace lodsmith {

namespace {

constexpr double kRounding = 1e-7; // share of the radius that a bound may be short of, for all the rounding behind it
constexpr double kCostRounding = 1e-4; // the same for costs, which are square roots of sums in floats
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

std::optional<Error> troubleWith(const std::vector<LevelTarget>& targets, const AttributeWeights& weights)
{
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const double amount = targets[i].amount;
        const bool isShare = targets[i].kind == LevelTarget::Kind::Proportional;
        if (!(amount >= 0.0) || std::isinf(amount) || (isShare && amount > 1.0))
            return Error{ErrorCode::InvalidSetting,
                         "level " + std::to_string(i + 1) + ": the target has to be a number "
                             + (isShare ? "from 0 to 1" : "of 0 or more") + ", not " + std::to_string(amount)};
    }
    for (const float weight : {weights.normal, weights.uv, weights.colour, weights.bone})
        if (!(weight >= 0.0f && std::isfinite(weight)))
            return Error{ErrorCode::InvalidSetting,
                         "an attribute weight has to be a number of 0 or more, not " + std::to_string(weight)};
    return std::nullopt;
}

void assertWellFormed(const MeshView& view)
{
    for (const SubMeshView& subMesh : view.subMeshes) {
        LODSMITH_ASSERT(subMesh.vertexBuffer < view.vertexBuffers.size(),
                        "a submesh names a vertex buffer that is not there");
        LODSMITH_ASSERT(subMesh.indexCount % 3 == 0, "a triangle list has three indices a triangle");
        LODSMITH_ASSERT(subMesh.indexBytes == 2 || subMesh.indexBytes == 4, "indices have two or four bytes");
        LODSMITH_ASSERT(subMesh.indexCount == 0 || subMesh.indices, "indices are missing");
    }
    for (const VertexBufferView& buffer : view.vertexBuffers) {
        LODSMITH_ASSERT(buffer.vertexCount == 0 || buffer.positions, "positions are missing");
        for (const UvStream& uv : buffer.uvSets)
            LODSMITH_ASSERT(uv.components >= 1 && uv.components <= 4,
                            "a texture coordinate has one to four components");
    }
}

std::uint32_t countLeft(std::uint32_t all, double removed)
{
    return removed >= all ? 0 : all - static_cast<std::uint32_t>(removed);
}

CollapseLimits limitsOf(const LevelTarget& target, const CollapseMesh& mesh, Metric metric)
{
    CollapseLimits limits{0, 0, kUnlimited, kUnlimited};
    const std::uint32_t vertices = mesh.summary.vertices;
    switch (target.kind) {
    case LevelTarget::Kind::Proportional:
        limits.vertices = countLeft(vertices, std::round(vertices * target.amount));
        break;
    case LevelTarget::Kind::Constant: limits.vertices = countLeft(vertices, std::floor(target.amount)); break;
    case LevelTarget::Kind::Triangles:
        limits.triangles = static_cast<std::uint32_t>(std::min<double>(target.amount, mesh.summary.triangles));
        break;
    case LevelTarget::Kind::Deviation:
        limits.deviation = target.amount * mesh.scale;
        if (metric == Metric::Quadric) // else a shape that is near enough would excuse any texture
            limits.length = limits.deviation + kCostRounding * mesh.summary.radius * mesh.scale;
        break;
    case LevelTarget::Kind::CollapseCost: limits.length = target.amount * mesh.scale; break;
    }
    return limits;
}

/// The mesh as it is now, as index lists into its own vertex buffers.
std::vector<std::vector<std::uint32_t>> snapshot(const CollapseMesh& mesh)
{
    std::vector<std::vector<std::uint32_t>> lists(mesh.firstFaceOfSubMesh.size() - 1);
    for (std::size_t s = 0; s < lists.size(); ++s) {
        const auto begin = mesh.faces.begin() + mesh.firstFaceOfSubMesh[s],
                   end = mesh.faces.begin() + mesh.firstFaceOfSubMesh[s + 1];
        lists[s].reserve(3 * std::min<std::size_t>(static_cast<std::size_t>(end - begin), mesh.liveFaces));
        for (auto face = begin; face != end; ++face)
            if (!mesh.isGone(*face))
                for (std::uint32_t wedge : face->wedge)
                    lists[s].push_back(mesh.wedgeSource[wedge]);
        lists[s].shrink_to_fit();
    }
    return lists;
}

/// Vertices that are left when all levels are made, at least.
std::uint32_t fewestVertices(const std::vector<LevelTarget>& targets, const CollapseMesh& mesh, Metric metric)
{
    std::uint32_t fewest = kNone;
    for (const LevelTarget& target : targets) {
        const CollapseLimits limits = limitsOf(target, mesh, metric);
        fewest = std::min(fewest, std::max(limits.vertices, limits.triangles / 2));
    }
    return fewest;
}

std::unique_ptr<CollapseCost> makeCost(Metric metric)
{
    if (metric == Metric::Quadric)
        return std::make_unique<QuadricCost>();
    return std::make_unique<CurvatureCost>();
}

bool isCancelled(const Progress* progress)
{
    return progress && progress->cancelled();
}

Result<LodChain> run(const MeshView& view, const std::vector<LevelTarget>& targets, const SimplifyOptions& options,
                     Progress* progress, const std::function<void()>& inputRead)
{
    const Error cancelled{ErrorCode::Cancelled, "cancelled"};
    if (isCancelled(progress))
        return cancelled;
    Result<CollapseMesh> welded = weld(view);
    if (!welded)
        return welded.error();
    CollapseMesh& mesh = welded.value();
    mesh.buildPlanes();
    if (auto error = buildPoses(mesh, view))
        return *error;
    buildAttributes(mesh, view, options.metric == Metric::Quadric ? options.weights : AttributeWeights{0, 0, 0, 0});
    if (inputRead)
        inputRead();
    if (targets.empty()) {
        if (progress)
            progress->report(1.0f);
        return mesh.summary;
    }
    if (isCancelled(progress))
        return cancelled;
    const Watch watch(progress, mesh.summary.vertices, fewestVertices(targets, mesh, options.metric));
    const VertexLocks locks{options.lockBorders, options.lockSeams};
    const auto cost = [&options] { return makeCost(options.metric); };
    QueueStates states(mesh.vertexCount());
    Simplifier simplifier(mesh, cost(), states);
    std::optional<PartRounds> rounds;
    if (PartRounds::isFor(mesh)) {
        rounds.emplace(mesh, states, cost, options.threads, watch);
        rounds->prepare(locks);
    } else {
        mesh.countFaces();
        mesh.buildFaceLists();
        simplifier.prepare(locks);
        simplifier.fillQueue();
    }
    LodChain chain = mesh.summary;
    const double radius = std::max(chain.radius, mesh.poses.radius / mesh.scale);
    const double rounding = kRounding * radius + 2.0 * mesh.poses.slack / mesh.scale;
    std::uint32_t verticesBefore = mesh.liveVertices;
    for (const LevelTarget& target : targets) {
        LodChainLevel level;
        const CollapseLimits limits = limitsOf(target, mesh, options.metric);
        simplifier.changeLimits(limits);
        if (rounds)
            rounds->run(limits, simplifier);
        if (isCancelled(progress)) // and the mesh is not ready for more
            return cancelled;
        level.stop = simplifier.run(limits, [&] { return watch.report(mesh.liveVertices); });
        if (isCancelled(progress))
            return cancelled;
        level.vertices = mesh.liveVertices;
        level.triangles = mesh.liveFaces;
        if (mesh.liveVertices
            < mesh.summary.vertices) // two points of one mesh are never farther apart than its diameter
            level.deviation = std::min(simplifier.outcome().largestDeviation / mesh.scale + rounding, 2.0 * radius);
        level.cost = simplifier.outcome().largestLength / mesh.scale;
        level.skipped = mesh.liveVertices == verticesBefore;
        if (!level.skipped)
            level.indices = snapshot(mesh);
        verticesBefore = mesh.liveVertices;
        chain.levels.push_back(std::move(level));
    }
    if (progress)
        progress->report(1.0f);
    return chain;
}

} // namespace

Result<LodChain> simplify(const MeshView& mesh, const std::vector<LevelTarget>& targets, const SimplifyOptions& options,
                          Progress* progress, const std::function<void()>& inputRead)
{
    assertWellFormed(mesh);
    if (auto error = troubleWith(targets, options.weights))
        return *error;
    try {
        return run(mesh, targets, options, progress, inputRead);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "not enough memory to simplify this mesh"};
    }
}

} // namespace lodsmith
