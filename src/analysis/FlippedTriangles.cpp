#include "FlippedTriangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace lodsmith::analysis {

namespace {

constexpr double kSameDirection = 0.05; // radians
constexpr double kAgreement = 0.7;      // cosine with the original at a corner that clears a triangle: 45 degrees
constexpr double kAgainst = -0.02;      // mean cosine below which a triangle faces against: 91 degrees

double longestSide(const Corners& corners)
{
    return std::max(
        {length(corners[1] - corners[0]), length(corners[2] - corners[1]), length(corners[0] - corners[2])});
}

bool isThin(const Surface& surface, std::uint32_t triangle)
{
    return length(surface.faceNormal(triangle)) <= longestSide(surface.corners(triangle)) * kTolerance;
}

Vec3 direction(const Vec3& v)
{
    return v * (1.0 / length(v));
}

double angleAt(const Corners& corners, std::uint32_t corner)
{
    const Vec3 a = corners[(corner + 1) % 3] - corners[corner], b = corners[(corner + 2) % 3] - corners[corner];
    return std::atan2(length(cross(a, b)), dot(a, b));
}

/// The angle, up to a right one and for small ones, by which a triangle misses a direction that starts from the point
/// of it closest to `from`.
double missedAngle(const Surface& surface, std::uint32_t triangle, const Vec3& from, const Vec3& towards)
{
    constexpr double kStep = 0.5; // of the triangle's least height, so that only the sides at the start matter
    const Corners& corners = surface.corners(triangle);
    const Vec3 start = pointAt(corners, closestPointOnTriangle(from, corners).weights);
    const double step = kStep * length(surface.faceNormal(triangle)) / longestSide(corners);
    return std::sqrt(closestPointOnTriangle(start + towards * step, corners).squaredDistance) / step;
}

/// The original's triangles at each position that the simplified surface uses.
class OriginalAtCorners {
public:
    OriginalAtCorners(const Surface& simplified, const SurfaceIndex& original)
        : mOriginal(original.surface()), mPoints(simplified.points()), mAround(mPoints.size())
    {
        enum class Use : unsigned char { None, Simplified, Both };
        std::vector<Use> uses(mPoints.size(), Use::None);
        for (std::uint32_t i = 0; i < simplified.triangleCount(); ++i)
            for (const std::uint32_t position : simplified.triangle(i).position)
                uses[position] = Use::Simplified;
        for (std::uint32_t i = 0; i < mOriginal.triangleCount(); ++i)
            for (std::uint32_t corner = 0; corner < 3; ++corner) {
                Use& use = uses[mOriginal.triangle(i).position[corner]];
                if (use == Use::None)
                    continue;
                use = Use::Both;
                add(mOriginal.triangle(i).position[corner], i, angleAt(mOriginal.corners(i), corner));
            }
        for (std::uint32_t position = 0; position < uses.size(); ++position)
            if (uses[position] == Use::Simplified)
                addClosest(position, original);
        seal();
    }

    /// The mean cosine with all triangles at a position.
    double cosineAround(std::uint32_t position, const Vec3& normal) const { return dot(normal, mAround[position]); }

    /// The best cosine with the triangles that leave a position towards a point.
    double cosineTowards(std::uint32_t position, const Vec3& point, const Vec3& normal) const
    {
        const Vec3 towards = direction(point - mPoints[position]);
        const auto before = [](const Touch& touch, std::uint32_t number) { return touch.position < number; };
        const auto begin = std::lower_bound(mTouches.begin(), mTouches.end(), position, before);
        double least = std::numeric_limits<double>::infinity();
        std::vector<std::pair<double, double>> found; // missed angle, cosine
        for (auto touch = begin; touch != mTouches.end() && touch->position == position; ++touch) {
            const double missed = missedAngle(mOriginal, touch->triangle, mPoints[position], towards);
            found.push_back({missed, dot(normal, direction(mOriginal.faceNormal(touch->triangle)))});
            least = std::min(least, missed);
        }
        if (found.empty())
            return 0.0;
        double cosine = -1.0;
        for (const auto& [missed, along] : found)
            if (missed <= least + kSameDirection)
                cosine = std::max(cosine, along);
        return cosine;
    }

private:
    struct Touch {
        std::uint32_t position, triangle;
        double weight;
    };

    void add(std::uint32_t position, std::uint32_t triangle, double weight)
    {
        if (!isThin(mOriginal, triangle))
            mTouches.push_back({position, triangle, weight});
    }

    void addClosest(std::uint32_t position, const SurfaceIndex& original)
    {
        const ClosestHit hit = original.closest(mPoints[position], mGuess);
        mGuess = hit.triangle;
        original.visitWithin(mPoints[position], hit.distance() + kTolerance,
                             [&](std::uint32_t triangle, const TrianglePoint&) {
                                 add(position, triangle, 1.0);
                                 return true;
                             });
    }

    void seal()
    {
        std::sort(mTouches.begin(), mTouches.end(), [](const Touch& a, const Touch& b) {
            return std::tie(a.position, a.triangle) < std::tie(b.position, b.triangle);
        });
        std::vector<double> weights(mAround.size(), 0.0);
        for (const Touch& touch : mTouches) {
            mAround[touch.position] += direction(mOriginal.faceNormal(touch.triangle)) * touch.weight;
            weights[touch.position] += touch.weight;
        }
        for (std::size_t i = 0; i < mAround.size(); ++i)
            if (weights[i] > 0.0)
                mAround[i] = mAround[i] * (1.0 / weights[i]);
    }

    const Surface& mOriginal;
    const std::vector<Vec3>& mPoints;
    std::vector<Touch> mTouches; ///< sorted by position
    std::vector<Vec3> mAround;   ///< weighted mean of normals
    std::uint32_t mGuess = 0;
};

bool isFlipped(const Surface& simplified, std::uint32_t triangle, const OriginalAtCorners& original)
{
    if (isThin(simplified, triangle))
        return false;
    const Corners& corners = simplified.corners(triangle);
    const Vec3 normal = direction(simplified.faceNormal(triangle));
    const Vec3 centre = (corners[0] + corners[1] + corners[2]) * (1.0 / 3.0);
    const auto& positions = simplified.triangle(triangle).position;
    double around = 0.0, towards = 0.0;
    for (const std::uint32_t position : positions)
        around += original.cosineAround(position, normal);
    if (around / 3.0 >= kAgainst)
        return false;
    for (const std::uint32_t position : positions) {
        const double cosine = original.cosineTowards(position, centre, normal);
        if (cosine > kAgreement)
            return false;
        towards += cosine;
    }
    return towards / 3.0 < kAgainst;
}

} // namespace

Result<std::uint32_t> countFlippedTriangles(const Surface& simplified, const SurfaceIndex& original,
                                            ComparisonProgress& progress)
{
    const OriginalAtCorners atCorners(simplified, original);
    std::uint32_t flipped = 0;
    for (std::uint32_t i = 0; i < simplified.triangleCount(); ++i) {
        if (!progress.step())
            return ComparisonProgress::cancelled();
        flipped += isFlipped(simplified, i, atCorners) ? 1 : 0;
    }
    return flipped;
}

} // namespace lodsmith::analysis
