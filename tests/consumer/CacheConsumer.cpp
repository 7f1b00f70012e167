#include <lodsmith/cache/SimplifyCached.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

/// A program without OGRE that makes the levels of a mesh once, and takes them from the cache the second time.
int main()
{
    const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};
    const std::vector<std::uint32_t> indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
    lodsmith::MeshView mesh;
    mesh.vertexBuffers.resize(1);
    mesh.vertexBuffers[0].vertexCount = 6;
    mesh.vertexBuffers[0].positions = {positions.data(), 3 * sizeof(float)};
    mesh.subMeshes.push_back({0, indices.data(), static_cast<std::uint32_t>(indices.size()), 4});

    lodsmith::LodCache cache(std::filesystem::current_path() / "cache", 1 << 20);
    const std::vector<lodsmith::LevelTarget> targets = {{lodsmith::LevelTarget::Kind::Proportional, 0.3}};
    bool found = false;
    for (int i = 0; i < 2; ++i) {
        const auto chain = lodsmith::simplifyCached(cache, mesh, targets);
        if (!chain || chain.value().notStored) {
            const lodsmith::Error& error = chain ? *chain.value().notStored : chain.error();
            std::fprintf(stderr, "%s\n", lodsmith::describe(error).c_str());
            return 1;
        }
        found = chain.value().found;
    }
    std::printf("%s%s\n", lodsmith::toHex(lodsmith::cacheKey(mesh, targets)).c_str(), found ? "" : ": not found");
    return found ? 0 : 1;
}
