#include <lodsmith/core/Simplify.h>

#include <cstdint>
#include <cstdio>
#include <vector>

/// A program without OGRE: a flat grid in plain arrays, simplified to half of its vertices.
int main()
{
    constexpr std::uint32_t kSide = 20;
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < kSide * kSide; ++i)
        positions.insert(positions.end(), {static_cast<float>(i % kSide), static_cast<float>(i / kSide), 0.0f});
    for (std::uint32_t i = 0; i + kSide < kSide * kSide; ++i) {
        if ((i + 1) % kSide != 0)
            indices.insert(indices.end(), {i, i + 1, i + kSide, i + 1, i + kSide + 1, i + kSide});
    }

    lodsmith::MeshView mesh;
    mesh.vertexBuffers.resize(1);
    mesh.vertexBuffers[0].vertexCount = kSide * kSide;
    mesh.vertexBuffers[0].positions = {positions.data(), 3 * sizeof(float)};
    mesh.subMeshes.push_back({0, indices.data(), static_cast<std::uint32_t>(indices.size()), 4});

    const auto chain = lodsmith::simplify(mesh, {{lodsmith::LevelTarget::Kind::Proportional, 0.5}});
    if (!chain) {
        std::fprintf(stderr, "%s\n", lodsmith::describe(chain.error()).c_str());
        return 1;
    }
    std::printf("%u vertices, then %u\n", chain.value().vertices, chain.value().levels[0].vertices);
    return chain.value().levels[0].vertices < chain.value().vertices ? 0 : 1;
}
