#include "Invariants.h"

#include "SurfaceDistance.h"
#include "WeldedMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace lodsmith::test {

namespace {

using PositionSet = std::set<std::uint32_t>;

PositionSet positionsOf(const std::vector<WeldedTriangle>& triangles)
{
    PositionSet positions;
    for (const WeldedTriangle& triangle : triangles)
        positions.insert(triangle.positions.begin(), triangle.positions.end());
    return positions;
}

std::vector<Triangle> corners(const std::vector<WeldedTriangle>& triangles, const WeldedPositions& welded)
{
    std::vector<Triangle> result;
    for (const WeldedTriangle& triangle : triangles)
        result.push_back({welded.points[triangle.positions[0]], welded.points[triangle.positions[1]],
                          welded.points[triangle.positions[2]]});
    return result;
}

std::vector<Triangle> cornersInPose(const MeshView& mesh, const std::vector<WeldedTriangle>& triangles,
                                    std::size_t pose)
{
    const MeshView posed = inPose(mesh, pose);
    std::vector<Triangle> result;
    for (const WeldedTriangle& triangle : triangles) {
        const VertexBufferView& buffer = posed.vertexBuffers[posed.subMeshes[triangle.subMesh].vertexBuffer];
        Triangle& corners = result.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner) {
            float position[3];
            buffer.positions.read(triangle.vertices[corner], 3, position);
            corners[corner] = {position[0], position[1], position[2]};
        }
    }
    return result;
}

std::vector<float> attributesOf(const VertexBufferView& buffer, std::uint32_t vertex)
{
    std::vector<float> values;
    const auto append = [&](const FloatStream& stream, int count) {
        values.resize(values.size() + 4);
        if (stream)
            stream.read(vertex, count, &values[values.size() - 4]);
    };
    append(buffer.normals, 3);
    append(buffer.colours, 4);
    for (const UvStream& set : buffer.uvSets)
        append(set.stream, set.components);
    return values;
}

/// Whether two triangles, of whatever submesh and winding, lie on the same three positions.
bool hasDoubledFace(const std::vector<WeldedTriangle>& triangles)
{
    std::set<std::array<std::uint32_t, 3>> faces;
    return !std::all_of(triangles.begin(), triangles.end(),
                        [&](const WeldedTriangle& triangle) { return faces.insert(triangle.sorted()).second; });
}

/// Triangles and how they hang together, under one way of welding.
struct WeldedSurface {
    WeldedSurface(const WeldedPositions& welded, const std::vector<WeldedTriangle>& source)
        : triangles(source), connectivity(triangles), clean(connectivity.manifold() && !hasDoubledFace(triangles))
    {
        for (const WeldedTriangle& triangle : triangles) {
            for (std::uint32_t position : triangle.positions) {
                for (double coordinate : welded.points[position])
                    extent = std::max(extent, std::abs(coordinate));
            }
        }
        for (const auto& [edge, count] : connectivity.edges)
            greatestDegree = std::max(greatestDegree, count);
    }

    std::vector<WeldedTriangle> triangles;
    Connectivity connectivity;
    bool clean;
    std::uint32_t greatestDegree = 0; ///< triangles on one edge
    double extent = 0.0;              ///< greatest coordinate, for the rounding of distances
};

/// `triangles` with positions welded in another way.
std::vector<WeldedTriangle> rewelded(const MeshView& mesh, const WeldedPositions& welded,
                                     std::vector<WeldedTriangle> triangles)
{
    for (WeldedTriangle& triangle : triangles) {
        for (int i = 0; i < 3; ++i)
            triangle.positions[i] = welded.of[mesh.subMeshes[triangle.subMesh].vertexBuffer][triangle.vertices[i]];
    }
    return triangles;
}

/// The input as the checks need it: welded and cleaned.
struct Input {
    explicit Input(const MeshView& view)
        : mesh(view), welded(weldPositions(view)), weldedMotion(weldPositions(view, Weld::Motion)),
          all(weldedTriangles(view, welded, indexLists(view))), atRest(welded, cleaned(all, report)),
          inMotion(weldedMotion, rewelded(view, weldedMotion, atRest.triangles))
    {
        for (const WeldedTriangle& triangle : all) {
            for (std::uint32_t vertex : triangle.vertices)
                used.emplace(triangle.subMesh, vertex);
        }
    }

    const MeshView& mesh;
    WeldedPositions welded;
    WeldedPositions weldedMotion;
    std::vector<WeldedTriangle> all;
    CleaningReport report;
    WeldedSurface atRest;
    WeldedSurface inMotion;
    std::set<std::pair<std::uint32_t, std::uint32_t>> used; ///< submesh, vertex
};

PositionSet lockedPositions(const Input& input, const SimplifyOptions& options)
{
    PositionSet locked;
    std::map<std::uint32_t, std::vector<float>> attributes;
    for (const WeldedTriangle& triangle : input.atRest.triangles) {
        const VertexBufferView& buffer = input.mesh.vertexBuffers[input.mesh.subMeshes[triangle.subMesh].vertexBuffer];
        for (int i = 0; i < 3; ++i) {
            float importance = 0.0f;
            if (buffer.importance)
                buffer.importance.read(triangle.vertices[i], 1, &importance);
            const std::vector<float> values = attributesOf(buffer, triangle.vertices[i]);
            const bool seam = attributes.emplace(triangle.positions[i], values).first->second != values;
            if (importance == 1.0f || (options.lockSeams && seam))
                locked.insert(triangle.positions[i]);
        }
    }
    if (options.lockBorders) {
        for (const auto& [position, border] : input.atRest.connectivity.borderOf)
            locked.insert(position);
    }
    return locked;
}

/// Collects sentences about one level.
class LevelCheck {
public:
    LevelCheck(const Input& input, std::size_t number, std::vector<std::string>& broken)
        : mInput(input), mNumber(number), mBroken(broken)
    {
    }

    template <class... Parts>
    void require(bool holds, const Parts&... parts)
    {
        if (holds)
            return;
        std::ostringstream text;
        text.precision(17);
        text << "level " << mNumber + 1 << ": ";
        (text << ... << parts);
        mBroken.push_back(text.str());
    }

    bool indices(const LodChainLevel& level)
    {
        require(level.indices.size() == mInput.mesh.subMeshes.size(), level.indices.size(), " index lists");
        if (level.indices.size() != mInput.mesh.subMeshes.size())
            return false;
        bool usable = true;
        for (std::uint32_t subMesh = 0; subMesh < level.indices.size(); ++subMesh) {
            usable = usable && level.indices[subMesh].size() % 3 == 0;
            for (std::uint32_t index : level.indices[subMesh])
                usable = usable && mInput.used.count({subMesh, index}) != 0;
        }
        require(usable, "an index list is no triangle list, or uses a vertex that its submesh did not use");
        return usable;
    }

    void triangles(const std::vector<WeldedTriangle>& triangles, const LodChainLevel& level)
    {
        CleaningReport report;
        cleaned(triangles, report);
        require(report.degenerateTriangles == 0, report.degenerateTriangles, " degenerate triangles");
        require(report.repeatedTriangles == 0, report.repeatedTriangles, " repeated triangles");
        require(level.triangles == triangles.size(), "reports ", level.triangles, " triangles, has ", triangles.size());
        const std::uint32_t vertices = countPositions(triangles);
        require(level.vertices == vertices, "reports ", level.vertices, " vertices, has ", vertices);
    }

    /// How the level hangs together, against how the input did; `way` names the way of welding.
    void connectivity(const std::vector<WeldedTriangle>& triangles, const WeldedSurface& before, const char* way)
    {
        const Connectivity level(triangles);
        borders(level, before, way);
        nonManifoldEdges(level, before, way);
        pieces(level, before, way);
        if (before.clean)
            cleanTopology(triangles, level, before, way);
    }

    void locks(const std::vector<WeldedTriangle>& triangles, const PositionSet& locked)
    {
        const PositionSet present = positionsOf(triangles);
        for (std::uint32_t position : locked)
            require(present.count(position) != 0, "locked position ", position, " is gone");
    }

    /// Distances are between double-precision points; what their rounding can add is allowed for.
    void deviation(const std::vector<Triangle>& surface, const std::vector<Triangle>& original, double bound,
                   std::uint32_t samples, const std::string& when = "")
    {
        require(std::isfinite(bound) && bound >= 0, "deviation ", bound);
        if (surface.empty() || samples == 0)
            return;
        const double rounding = 1e-12 * mInput.atRest.extent;
        const double forth = sampledDistance(surface, original, samples, 1);
        const double back = sampledDistance(original, surface, samples, 2);
        require(forth <= bound + rounding, "deviation ", bound, " but a point of the level is ", forth,
                " off the input", when);
        require(back <= bound + rounding, "deviation ", bound, " but a point of the input is ", back, " off the level",
                when);
    }

    void flips(const std::vector<Triangle>& surface, const std::vector<Triangle>& original, double reach,
               std::uint32_t samples)
    {
        if (samples == 0)
            return;
        const double rounding = 1e-12 * mInput.atRest.extent;
        for (std::size_t i = 0; i < surface.size(); i += surface.size() / samples + 1)
            require(!facesAgainstAll(surface[i], original, reach + rounding), "triangle ", i, " is flipped");
    }

private:
    void borders(const Connectivity& level, const WeldedSurface& before, const char* way)
    {
        const auto& borderOf = before.connectivity.borderOf;
        const auto isOld = [&](const Edge& edge) {
            const auto first = borderOf.find(edge.first);
            const auto second = borderOf.find(edge.second);
            return first != borderOf.end() && second != borderOf.end() && first->second == second->second;
        };
        require(level.borderEdges <= before.connectivity.oddEdges, level.borderEdges, " border edges ", way,
                ", the input had ", before.connectivity.oddEdges, " odd ones");
        for (const auto& [edge, count] : level.edges) {
            require(!before.clean || count != 1 || isOld(edge), "edge ", edge.first, "-", edge.second,
                    " is a border edge ", way, ", but no part of a border of the input");
        }
    }

    void nonManifoldEdges(const Connectivity& level, const WeldedSurface& before, const char* way)
    {
        require(level.nonManifoldEdges <= before.connectivity.nonManifoldEdges, level.nonManifoldEdges,
                " non-manifold edges ", way, ", the input had ", before.connectivity.nonManifoldEdges);
    }

    void pieces(const Connectivity& level, const WeldedSurface& before, const char* way)
    {
        const auto& pieceOf = before.connectivity.pieceOf;
        for (const auto& [edge, count] : level.edges) {
            require(pieceOf.at(edge.first) == pieceOf.at(edge.second), "edge ", edge.first, "-", edge.second,
                    " joins two pieces of the input ", way);
        }
    }

    void cleanTopology(const std::vector<WeldedTriangle>& triangles, const Connectivity& level,
                       const WeldedSurface& before, const char* way)
    {
        require(level.manifold(), "the input was manifold ", way, ", the level is not");
        require(!hasDoubledFace(triangles), "two triangles on one set of positions ", way);
        const long euler = before.connectivity.eulerCharacteristic();
        require(level.pieces != before.connectivity.pieces || level.eulerCharacteristic() >= euler,
                "Euler characteristic ", level.eulerCharacteristic(), " ", way, ", the input's was ", euler);
    }

    /// A right angle is not against: a triangle across an edge of a box may stand on both of its sides.
    static bool facesAgainstAll(const Triangle& triangle, const std::vector<Triangle>& original, double reach)
    {
        constexpr double kAgainst = -0.5;
        const Point normal = areaNormal(triangle);
        const double size = length(normal);
        Point centre{};
        for (int i = 0; i < 3; ++i)
            centre[i] = (triangle[0][i] + triangle[1][i] + triangle[2][i]) / 3;
        return size > 0 && std::none_of(original.begin(), original.end(), [&](const Triangle& other) {
                   const Point otherNormal = areaNormal(other);
                   return dot(normal, otherNormal) >= kAgainst * size * length(otherNormal)
                          && distanceToTriangle(centre, other) <= reach;
               });
    }

    const Input& mInput;
    std::size_t mNumber;
    std::vector<std::string>& mBroken;
};

bool isCount(LevelTarget::Kind kind)
{
    return kind == LevelTarget::Kind::Proportional || kind == LevelTarget::Kind::Constant
           || kind == LevelTarget::Kind::Triangles;
}

/// What a count target asks for, as a real number: how it is rounded is not the checks' business.
double countGoal(const LevelTarget& target, const LodChain& chain)
{
    switch (target.kind) {
    case LevelTarget::Kind::Proportional: return chain.vertices * (1.0 - target.amount);
    case LevelTarget::Kind::Constant: return std::max(0.0, chain.vertices - target.amount);
    default: return target.amount;
    }
}

/// The level before the one that is checked, or the cleaned input.
struct Before {
    std::uint32_t vertices = 0;
    std::uint32_t triangles = 0;
    double deviation = 0.0;
    double cost = 0.0;
};

void checkMonotone(LevelCheck& check, const LodChainLevel& level, const Before& before)
{
    check.require(level.vertices <= before.vertices, "more vertices than before: ", level.vertices);
    check.require(level.triangles <= before.triangles, "more triangles than before: ", level.triangles);
    check.require(level.deviation >= before.deviation, "less deviation than before: ", level.deviation);
    check.require(level.cost >= before.cost && std::isfinite(level.cost), "cost ", level.cost, " after ", before.cost);
    check.require(level.skipped == (level.vertices == before.vertices), "skipped is ", level.skipped, " with ",
                  level.vertices, " vertices after ", before.vertices);
}

/// How many vertices or triangles one step may take away at most.
double largestStep(const Input& input, const LodChainLevel& level)
{
    constexpr double smallPiece = 17; // positions of 8 triangles that hang together
    const double collapse = input.atRest.clean ? 2.0 : 2.0 * input.atRest.greatestDegree + 1.0;
    if (level.skipped)
        return collapse;
    const Connectivity connectivity(weldedTriangles(input.mesh, input.welded, level.indices));
    const bool pieceIsGone = connectivity.pieces < input.atRest.connectivity.pieces;
    return pieceIsGone ? std::max(collapse, smallPiece) : collapse;
}

void checkCountTarget(LevelCheck& check, const LevelTarget& target, const LodChain& chain, const LodChainLevel& level,
                      const Before& before, double slack)
{
    const bool countsTriangles = target.kind == LevelTarget::Kind::Triangles;
    const double goal = countGoal(target, chain);
    const double count = countsTriangles ? level.triangles : level.vertices;
    const double start = countsTriangles ? before.triangles : before.vertices;
    if (level.stop == StopReason::TargetReached)
        check.require(count < goal + 1, "says that it reached ", goal, " with ", count);
    else
        check.require(count > std::floor(goal), "says that it did not reach ", goal, " with ", count);
    check.require(count >= std::min(start, std::floor(goal)) - slack, "went beyond ", goal, ", to ", count);
}

/// What a reported deviation has added (LodChain.h) and a target has not: rounding, and how far vertices may be apart in a pose that
/// count as one; here no more is asked than that they are in one place at rest.
double allowanceFor(const Input& input, double radius)
{
    struct Box {
        double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
    };
    double motion = 0.0, apart = 0.0;
    for (std::size_t pose = 0; pose < poseCount(input.mesh); ++pose) {
        const MeshView posed = inPose(input.mesh, pose);
        std::map<std::array<float, 3>, Box> boxes; // by position at rest
        for (const auto& [subMesh, vertex] : input.used) {
            const std::size_t buffer = input.mesh.subMeshes[subMesh].vertexBuffer;
            std::array<float, 3> from, to;
            input.mesh.vertexBuffers[buffer].positions.read(vertex, 3, from.data());
            posed.vertexBuffers[buffer].positions.read(vertex, 3, to.data());
            motion =
                std::max(motion, std::hypot(double{to[0]} - from[0], double{to[1]} - from[1], double{to[2]} - from[2]));
            Box& box = boxes[from];
            for (std::size_t i = 0; i < 3; ++i) {
                box.low[i] = std::min<double>(box.low[i], to[i]);
                box.high[i] = std::max<double>(box.high[i], to[i]);
            }
        }
        for (const auto& [position, box] : boxes)
            apart = std::max(apart,
                             std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]));
    }
    return 1.01e-7 * (radius + motion) + 2.0 * apart;
}

void checkBoundTarget(LevelCheck& check, const LevelTarget& target, const LodChainLevel& level, const Before& before,
                      double rounding)
{
    const bool isDeviation = target.kind == LevelTarget::Kind::Deviation;
    const double value = isDeviation ? level.deviation : level.cost;
    const double least = isDeviation ? before.deviation : before.cost;
    check.require(value <= std::max(target.amount, least) + rounding, value, " is beyond the bound ", target.amount);
}

/// Counts of the chain itself.
void checkChain(const Input& input, const LodChain& chain, std::size_t targets, std::vector<std::string>& broken)
{
    std::uint32_t bufferVertices = 0;
    std::set<std::pair<std::uint32_t, std::uint32_t>> used;
    for (const VertexBufferView& buffer : input.mesh.vertexBuffers)
        bufferVertices += buffer.vertexCount;
    for (const auto& [subMesh, vertex] : input.used)
        used.emplace(input.mesh.subMeshes[subMesh].vertexBuffer, vertex);
    const auto require = [&](const char* what, std::size_t reported, std::size_t counted) {
        if (reported != counted)
            broken.push_back("chain: " + std::string(what) + " is " + std::to_string(reported) + ", counted "
                             + std::to_string(counted));
    };
    require("levels", chain.levels.size(), targets);
    require("vertices", chain.vertices, countPositions(input.all));
    require("bufferVertices", chain.bufferVertices, bufferVertices);
    require("triangles", chain.triangles, input.all.size());
    require("degenerateTriangles", chain.cleaned.degenerateTriangles, input.report.degenerateTriangles);
    require("repeatedTriangles", chain.cleaned.repeatedTriangles, input.report.repeatedTriangles);
    require("unreferencedVertices", chain.cleaned.unreferencedVertices, bufferVertices - used.size());
}

/// What a level's own triangles tell, whatever came before.
void checkSurface(LevelCheck& check, const Input& input, const LodChainLevel& level, const PositionSet& locked,
                  const std::vector<Triangle>& original, std::uint32_t samples)
{
    const std::vector<WeldedTriangle> triangles = weldedTriangles(input.mesh, input.welded, level.indices);
    check.triangles(triangles, level);
    check.connectivity(triangles, input.atRest, "at rest");
    check.connectivity(rewelded(input.mesh, input.weldedMotion, triangles), input.inMotion, "in motion");
    check.locks(triangles, locked);
    const std::vector<Triangle> surface = corners(triangles, input.welded);
    check.deviation(surface, original, level.deviation, samples);
    for (std::size_t pose = 0; pose < poseCount(input.mesh); ++pose)
        check.deviation(cornersInPose(input.mesh, triangles, pose),
                        cornersInPose(input.mesh, input.atRest.triangles, pose), level.deviation, samples,
                        " in pose " + std::to_string(pose));
    check.flips(surface, original, level.deviation, samples);
}

} // namespace

std::vector<std::string> brokenInvariants(const MeshView& mesh, const std::vector<LevelTarget>& targets,
                                          const SimplifyOptions& options, const LodChain& chain,
                                          const InvariantOptions& check)
{
    std::vector<std::string> broken;
    const Input input(mesh);
    checkChain(input, chain, targets.size(), broken);
    if (chain.levels.size() != targets.size())
        return broken;

    const PositionSet locked = lockedPositions(input, options);
    const double allowance = allowanceFor(input, chain.radius);
    const std::vector<Triangle> original = corners(input.atRest.triangles, input.welded);
    Before before{countPositions(input.atRest.triangles), static_cast<std::uint32_t>(input.atRest.triangles.size()),
                  0.0, 0.0};
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const LodChainLevel& level = chain.levels[i];
        LevelCheck levelCheck(input, i, broken);
        checkMonotone(levelCheck, level, before);
        if (!level.skipped && !levelCheck.indices(level))
            continue;
        if (isCount(targets[i].kind))
            checkCountTarget(levelCheck, targets[i], chain, level, before, largestStep(input, level));
        else
            checkBoundTarget(levelCheck, targets[i], level, before, allowance);
        if (level.skipped) {
            levelCheck.require(level.triangles == before.triangles, "skipped, with other triangles: ", level.triangles);
            for (const std::vector<std::uint32_t>& list : level.indices)
                levelCheck.require(list.empty(), "skipped, but it has indices");
            continue;
        }
        checkSurface(levelCheck, input, level, locked, original, check.samples);
        before = {level.vertices, level.triangles, level.deviation, level.cost};
    }
    return broken;
}

} // namespace lodsmith::test
