#include "MeshoptPeer.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace lodsmith::benchmarks {

namespace {

double keptShare(const LevelTarget& target, std::uint32_t triangles)
{
    return target.kind == LevelTarget::Kind::Triangles ? target.amount / triangles : 1.0 - target.amount;
}

} // namespace

std::vector<MeshoptPeer::Input> MeshoptPeer::makeInputs(const MeshView& view)
{
    std::vector<Input> inputs;
    for (const SubMeshView& subMesh : view.subMeshes) {
        Input& input = inputs.emplace_back();
        input.indices.resize(subMesh.indexCount);
        for (std::uint32_t i = 0; i < subMesh.indexCount; ++i)
            input.indices[i] = subMesh.index(i);
        const VertexBufferView& buffer = view.vertexBuffers[subMesh.vertexBuffer];
        input.positions.resize(std::size_t(buffer.vertexCount) * 3);
        for (std::uint32_t vertex = 0; vertex < buffer.vertexCount; ++vertex)
            buffer.positions.read(vertex, 3, &input.positions[std::size_t(vertex) * 3]);
    }
    return inputs;
}

std::vector<std::uint32_t> MeshoptPeer::simplify(const Input& input, const std::vector<std::uint32_t>& from,
                                                 std::size_t targetIndices)
{
    constexpr float kAnyError = 1e9f;
    std::vector<std::uint32_t> result(from.size());
    if (from.empty())
        return result;
    result.resize(meshopt_simplify(result.data(), from.data(), from.size(), input.positions.data(),
                                   input.positions.size() / 3, 3 * sizeof(float), targetIndices, kAnyError, 0,
                                   nullptr));
    return result;
}

double MeshoptPeer::generate(Subject& subject, const Plan& plan)
{
    const std::vector<Input> inputs = makeInputs(subject.view());
    const auto start = std::chrono::steady_clock::now();
    mLevels.assign(plan.levels.size(), LevelIndices(inputs.size()));
    for (std::size_t level = 0; level < plan.levels.size(); ++level) {
        const double kept = keptShare(plan.levels[level].target, subject.triangles());
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const auto triangles = static_cast<std::size_t>(std::lround(kept * double(inputs[i].indices.size() / 3)));
            const auto& from = level == 0 ? inputs[i].indices : mLevels[level - 1][i];
            mLevels[level][i] = simplify(inputs[i], from, std::min(3 * triangles, from.size()));
        }
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<PeerLevel> MeshoptPeer::levels(const Subject&) const
{
    std::vector<PeerLevel> levels;
    for (const LevelIndices& level : mLevels)
        levels.push_back({level, ""});
    return levels;
}

void MeshoptPeer::reset(Subject&)
{
    mLevels.clear();
}

} // namespace lodsmith::benchmarks
