// Prints a hash of each determinism mesh and of its chains. Built several times, at different levels of optimisation; all
// builds have to print the same.

#include "DeterminismCases.h"

#include <cstdio>

namespace {

/// Fowler, Noll and Vo's hash (FNV-1a), 64 bits.
std::uint64_t hashOf(const std::string& bytes)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : bytes) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3u;
    }
    return hash;
}

std::uint64_t hashOf(const lodsmith::test::TestMesh& mesh)
{
    std::string bytes;
    for (const lodsmith::test::TestBuffer& buffer : mesh.buffers)
        bytes.append(reinterpret_cast<const char*>(buffer.positions.data()), buffer.positions.size() * sizeof(float));
    return hashOf(bytes);
}

} // namespace

int main()
{
    for (const auto& [name, mesh] : lodsmith::test::determinismMeshes()) {
        std::printf("%s: input %016llx", name.c_str(), static_cast<unsigned long long>(hashOf(mesh)));
        for (const lodsmith::Metric metric : {lodsmith::Metric::Quadric, lodsmith::Metric::Curvature})
            std::printf(" %016llx", static_cast<unsigned long long>(hashOf(lodsmith::test::outcomeOf(mesh, metric))));
        std::printf("\n");
    }
    const lodsmith::test::TestMesh large = lodsmith::test::makeTerrain(260); // that is worked on in parts
    lodsmith::SimplifyOptions options;
    options.threads = 2;
    std::printf("large: input %016llx %016llx\n", static_cast<unsigned long long>(hashOf(large)),
                static_cast<unsigned long long>(hashOf(lodsmith::test::outcomeOf(large, options))));
    return 0;
}
