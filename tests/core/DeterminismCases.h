#pragma once

#include "support/MeshBuilders.h"

#include <lodsmith/core/Simplify.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace lodsmith::test {

/// Meshes of every kind whose chains are compared between runs, threads and builds.
inline std::vector<std::pair<std::string, TestMesh>> determinismMeshes()
{
    return {{"terrain", makeTerrain(48)},
            {"grid with equal costs", makeGrid(24, 24)},
            {"sphere", makeUvSphere(32, 20)},
            {"faceted torus", flatShaded(makeTorus(24, 16))},
            {"jittered icosphere", jittered(makeIcosphere(3), 0.05)},
            {"cube", makeCube(8)},
            {"wall", makeTwoSidedWall(10)},
            {"lips", makeClosedLips(12)},
            {"skinned tube", makeSkinnedTube(24, 16)},
            {"bent tube", makeBentTube(24, 16, {40.0, 80.0, 120.0, -120.0, 160.0})},
            {"two materials", makeTwoMaterials(12, false)},
            {"leaf cards", makeLeafCards(100)},
            {"soup", makeSoup(100)},
            {"tiny", scaled(makeTerrain(16), 1e-30)},
            {"huge", scaled(makeTerrain(16), 1e17)}};
}

inline const std::vector<LevelTarget> kDeterminismTargets = {{LevelTarget::Kind::Proportional, 0.4},
                                                             {LevelTarget::Kind::Proportional, 0.8},
                                                             {LevelTarget::Kind::Triangles, 12.0}};

/// Everything in a chain, byte for byte.
inline std::string bytesOf(const LodChain& chain)
{
    std::string bytes;
    const auto append = [&](const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); };
    const std::uint32_t counts[] = {chain.vertices,
                                    chain.bufferVertices,
                                    chain.triangles,
                                    chain.cleaned.degenerateTriangles,
                                    chain.cleaned.repeatedTriangles,
                                    chain.cleaned.unreferencedVertices};
    append(counts, sizeof counts);
    append(&chain.radius, sizeof chain.radius);
    for (const LodChainLevel& level : chain.levels) {
        const std::uint32_t figures[] = {level.vertices, level.triangles, static_cast<std::uint32_t>(level.stop),
                                         static_cast<std::uint32_t>(level.skipped)};
        append(figures, sizeof figures);
        append(&level.deviation, sizeof level.deviation);
        append(&level.cost, sizeof level.cost);
        for (const std::vector<std::uint32_t>& list : level.indices) {
            const std::size_t size = list.size();
            append(&size, sizeof size);
            append(list.data(), size * sizeof(std::uint32_t));
        }
    }
    return bytes;
}

/// A chain's bytes, or the error as text.
inline std::string outcomeOf(const TestMesh& mesh, const SimplifyOptions& options)
{
    const Result<LodChain> result = simplify(mesh.view(), kDeterminismTargets, options);
    return result.ok() ? bytesOf(result.value()) : describe(result.error());
}

inline std::string outcomeOf(const TestMesh& mesh, Metric metric)
{
    SimplifyOptions options;
    options.metric = metric;
    return outcomeOf(mesh, options);
}

} // namespace lodsmith::test
