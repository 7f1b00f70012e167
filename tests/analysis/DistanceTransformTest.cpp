#include "DistanceTransform.h"

#include <support/MeshBuilders.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {
namespace {

double nearestMarked(const std::vector<bool>& marked, std::size_t width, std::size_t pixel)
{
    const auto offset = [](std::size_t a, std::size_t b) {
        return static_cast<double>(std::max(a, b) - std::min(a, b));
    };
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < marked.size(); ++i) {
        const std::size_t row = i / width, pixelRow = pixel / width;
        if (marked[i])
            nearest = std::min(nearest, std::hypot(offset(i % width, pixel % width), offset(row, pixelRow)));
    }
    return nearest;
}

TEST(DistanceTransform, IsTheDistanceToTheNearest)
{
    test::TestRandom random(7);
    for (const double density : {0.0, 0.001, 0.01, 0.3, 1.0})
        for (const auto& [width, height] : {std::pair<std::size_t, std::size_t>{31, 17}, {1, 40}, {40, 1}, {1, 1}}) {
            std::vector<bool> marked(width * height);
            std::generate(marked.begin(), marked.end(), [&, share = density] { return random.uniform() < share; });
            const std::vector<double> distances = distancesToMarked(marked, width, height);
            for (std::size_t i = 0; i < marked.size(); ++i)
                ASSERT_DOUBLE_EQ(distances[i], nearestMarked(marked, width, i))
                    << width << " x " << height << ", " << i;
        }
}

} // namespace
} // namespace lodsmith
