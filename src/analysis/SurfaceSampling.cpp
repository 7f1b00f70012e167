#include "SurfaceSampling.h"

#include <cmath>
#include <numeric>

namespace lodsmith::analysis {

namespace {

/// SplitMix64 (Steele, Lea and Flood 2014): the standard library's distributions differ from one library to the next.
class Random {
public:
    explicit Random(std::uint64_t seed) : mState(seed) {}

    /// 0 <= x < 1
    double uniform()
    {
        mState += 0x9e3779b97f4a7c15ull;
        std::uint64_t z = mState;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t mState;
};

/// Evenly distributed over the triangle.
Barycentric randomWeights(Random& random)
{
    const double apart = std::sqrt(random.uniform());
    const double along = random.uniform();
    return {1.0 - apart, apart * (1.0 - along), apart * along};
}

/// The area of the triangles up to and including each.
std::vector<double> cumulatedAreas(const Surface& surface)
{
    std::vector<double> sums(surface.triangleCount());
    double sum = 0.0;
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i)
        sums[i] = sum += length(surface.faceNormal(i)) / 2.0;
    if (sum == 0.0)
        std::iota(sums.begin(), sums.end(), 1.0);
    return sums;
}

} // namespace

std::vector<SurfaceSample> sampleArea(const Surface& surface, std::uint32_t count, std::uint64_t seed)
{
    const std::vector<double> sums = cumulatedAreas(surface);
    const double share = sums.back() / count;
    Random random(seed);
    std::vector<SurfaceSample> samples(count);
    std::uint32_t triangle = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double place = (i + random.uniform()) * share;
        while (triangle + 1 < sums.size() && sums[triangle] <= place)
            ++triangle;
        samples[i] = {triangle, randomWeights(random)};
    }
    return samples;
}

std::vector<SurfaceSample> sampleVertices(const Surface& surface)
{
    std::vector<std::vector<bool>> sampled;
    for (const VertexBufferView& buffer : surface.mesh().vertexBuffers)
        sampled.emplace_back(buffer.vertexCount, false);
    std::vector<SurfaceSample> samples;
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i)
        for (int corner = 0; corner < 3; ++corner) {
            auto done = sampled[surface.vertexBuffer(i)][surface.triangle(i).vertex[corner]];
            if (done)
                continue;
            done = true;
            Barycentric weights{};
            weights[corner] = 1.0;
            samples.push_back({i, weights});
        }
    return samples;
}

} // namespace lodsmith::analysis
