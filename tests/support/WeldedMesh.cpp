#include "WeldedMesh.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>

namespace lodsmith::test {

namespace {

void append(std::string& key, float value)
{
    const float positiveZero = value == 0.0f ? 0.0f : value;
    key.append(reinterpret_cast<const char*>(&positiveZero), sizeof(float));
}

void appendOffsets(std::string& key, const VertexBufferView& buffer, std::uint32_t vertex)
{
    std::vector<float> offsets(buffer.offsets.size() * 3);
    for (std::size_t i = 0; i < buffer.offsets.size(); ++i)
        buffer.offsets[i].read(vertex, 3, &offsets[i * 3]);
    while (!offsets.empty() && offsets.back() == 0.0f)
        offsets.pop_back();
    for (float value : offsets)
        append(key, value);
}

void appendBones(std::string& key, const VertexBufferView& buffer, std::uint32_t vertex)
{
    std::map<std::uint16_t, float> weights;
    for (int i = 0; i < 4; ++i)
        weights[buffer.bones[vertex].bone[i]] += buffer.bones[vertex].weight[i];
    key += 'b';
    for (auto [bone, weight] : weights) {
        if (weight == 0.0f)
            continue;
        append(key, static_cast<float>(bone));
        append(key, weight);
    }
}

void appendPoses(std::string& key, const VertexBufferView& buffer, std::uint32_t vertex,
                 const std::array<float, 3>& rest)
{
    key += 'p';
    for (const FloatStream& stream : buffer.poses) {
        float posed[3];
        stream.read(vertex, 3, posed);
        for (std::size_t i = 0; i < 3; ++i)
            append(key, posed[i] - rest[i]);
    }
}

std::string keyOf(const VertexBufferView& buffer, std::uint32_t vertex, const std::array<float, 3>& position, Weld weld)
{
    std::string key;
    for (float value : position)
        append(key, value);
    if (weld == Weld::Rest)
        return key;
    appendOffsets(key, buffer, vertex);
    if (buffer.bones)
        appendBones(key, buffer, vertex);
    else if (!buffer.poses.empty())
        appendPoses(key, buffer, vertex, position);
    return key;
}

/// Numbers for the groups of items that were joined.
class Groups {
public:
    explicit Groups(std::size_t count) : mParents(count) { std::iota(mParents.begin(), mParents.end(), 0u); }

    std::uint32_t find(std::uint32_t item)
    {
        while (mParents[item] != item)
            item = mParents[item] = mParents[mParents[item]];
        return item;
    }

    void join(std::uint32_t a, std::uint32_t b) { mParents[find(a)] = find(b); }

private:
    std::vector<std::uint32_t> mParents;
};

/// The groups of positions that `edges` connect, numbered from 0.
template <class Edges>
std::map<std::uint32_t, std::uint32_t> groupsOf(const Edges& edges)
{
    std::map<std::uint32_t, std::uint32_t> local;
    for (const Edge& edge : edges) {
        local.emplace(edge.first, static_cast<std::uint32_t>(local.size()));
        local.emplace(edge.second, static_cast<std::uint32_t>(local.size()));
    }
    Groups groups(local.size());
    for (const Edge& edge : edges)
        groups.join(local[edge.first], local[edge.second]);
    for (auto& [position, number] : local)
        number = groups.find(number);
    return local;
}

template <class Values>
std::uint32_t countDistinct(const Values& values)
{
    std::set<std::uint32_t> distinct;
    for (const auto& [key, value] : values)
        distinct.insert(value);
    return static_cast<std::uint32_t>(distinct.size());
}

Edge makeEdge(std::uint32_t a, std::uint32_t b)
{
    return std::minmax(a, b);
}

/// Groups of the triangles at one position that hang together over the edges at it: `ends` holds, for each triangle,
/// its two other positions.
std::uint32_t countFans(const std::vector<Edge>& ends)
{
    return countDistinct(groupsOf(ends));
}

} // namespace

WeldedPositions weldPositions(const MeshView& mesh, Weld weld)
{
    WeldedPositions welded;
    std::unordered_map<std::string, std::uint32_t> numbers;
    for (const VertexBufferView& buffer : mesh.vertexBuffers) {
        std::vector<std::uint32_t>& of = welded.of.emplace_back(buffer.vertexCount);
        for (std::uint32_t vertex = 0; vertex < buffer.vertexCount; ++vertex) {
            std::array<float, 3> position{};
            buffer.positions.read(vertex, 3, position.data());
            const auto next = static_cast<std::uint32_t>(welded.points.size());
            const auto [found, isNew] = numbers.emplace(keyOf(buffer, vertex, position, weld), next);
            if (isNew)
                welded.points.push_back({position[0], position[1], position[2]});
            of[vertex] = found->second;
        }
    }
    return welded;
}

bool WeldedTriangle::degenerate() const
{
    return positions[0] == positions[1] || positions[1] == positions[2] || positions[2] == positions[0];
}

std::array<std::uint32_t, 3> WeldedTriangle::turned() const
{
    std::array<std::uint32_t, 3> result = positions;
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
}

std::array<std::uint32_t, 3> WeldedTriangle::sorted() const
{
    std::array<std::uint32_t, 3> result = positions;
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<WeldedTriangle> weldedTriangles(const MeshView& mesh, const WeldedPositions& welded,
                                            const IndexLists& lists)
{
    std::vector<WeldedTriangle> triangles;
    for (std::uint32_t subMesh = 0; subMesh < lists.size(); ++subMesh) {
        const std::vector<std::uint32_t>& of = welded.of[mesh.subMeshes[subMesh].vertexBuffer];
        const std::vector<std::uint32_t>& list = lists[subMesh];
        for (std::size_t i = 0; i + 2 < list.size(); i += 3) {
            triangles.push_back(
                {subMesh, {list[i], list[i + 1], list[i + 2]}, {of[list[i]], of[list[i + 1]], of[list[i + 2]]}});
        }
    }
    return triangles;
}

IndexLists indexLists(const MeshView& mesh)
{
    IndexLists lists;
    for (const SubMeshView& subMesh : mesh.subMeshes) {
        std::vector<std::uint32_t>& list = lists.emplace_back(subMesh.indexCount);
        for (std::uint32_t i = 0; i < subMesh.indexCount; ++i)
            list[i] = subMesh.index(i);
    }
    return lists;
}

std::vector<WeldedTriangle> cleaned(const std::vector<WeldedTriangle>& triangles, CleaningReport& report)
{
    std::vector<WeldedTriangle> kept;
    std::set<std::pair<std::uint32_t, std::array<std::uint32_t, 3>>> seen;
    for (const WeldedTriangle& triangle : triangles) {
        if (triangle.degenerate())
            ++report.degenerateTriangles;
        else if (!seen.emplace(triangle.subMesh, triangle.turned()).second)
            ++report.repeatedTriangles;
        else
            kept.push_back(triangle);
    }
    return kept;
}

std::uint32_t countPositions(const std::vector<WeldedTriangle>& triangles)
{
    std::set<std::uint32_t> positions;
    for (const WeldedTriangle& triangle : triangles)
        positions.insert(triangle.positions.begin(), triangle.positions.end());
    return static_cast<std::uint32_t>(positions.size());
}

Connectivity::Connectivity(const std::vector<WeldedTriangle>& source)
    : triangles(static_cast<std::uint32_t>(source.size()))
{
    std::map<std::uint32_t, std::vector<Edge>> ends;
    std::vector<Edge> all;
    std::vector<Edge> borders;
    for (const WeldedTriangle& triangle : source) {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t next = triangle.positions[(i + 1) % 3];
            const std::uint32_t last = triangle.positions[(i + 2) % 3];
            ++edges[makeEdge(triangle.positions[i], next)];
            ends[triangle.positions[i]].push_back(makeEdge(next, last));
        }
    }
    for (const auto& [edge, count] : edges) {
        all.push_back(edge);
        if (count == 1)
            borders.push_back(edge);
        oddEdges += count % 2;
        nonManifoldEdges += count > 2;
    }
    for (const auto& [position, others] : ends)
        fans[position] = countFans(others);
    borderEdges = static_cast<std::uint32_t>(borders.size());
    borderOf = groupsOf(borders);
    pieceOf = groupsOf(all);
    pieces = countDistinct(pieceOf);
}

bool Connectivity::manifold() const
{
    const auto isOne = [](const auto& entry) { return entry.second == 1; };
    return nonManifoldEdges == 0 && std::all_of(fans.begin(), fans.end(), isOne);
}

long Connectivity::eulerCharacteristic() const
{
    return static_cast<long>(fans.size()) - static_cast<long>(edges.size()) + static_cast<long>(triangles);
}

} // namespace lodsmith::test
