#include "ClosestPoint.h"

#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lodsmith;
using lodsmith::test::TestRandom;

namespace {

const Corners kTriangle{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 3, 0}};

double distanceTo(const Vec3& point, const Corners& corners)
{
    return std::sqrt(closestPointOnTriangle(point, corners).squaredDistance);
}

Vec3 randomPoint(TestRandom& random)
{
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    return {x, y, z};
}

/// A point q of a convex set is the closest to p exactly when no corner lies nearer to p along p - q than q does.
void expectClosest(const Vec3& point, const Corners& corners)
{
    const TrianglePoint found = closestPointOnTriangle(point, corners);
    const Vec3 q = pointAt(corners, found.weights);
    double sum = 0.0;
    for (const double weight : found.weights) {
        EXPECT_GE(weight, 0.0);
        sum += weight;
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_NEAR(found.squaredDistance, lengthSquared(point - q), 1e-15);
    for (const Vec3& corner : corners)
        EXPECT_LE(dot(point - q, corner - q), 1e-11);
}

/// The least value of a convex function on 0..1, by ternary search.
template <class Function>
double leastValue(Function function)
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 80; ++i) {
        const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
        (function(a) < function(b) ? high : low) = function(a) < function(b) ? b : a;
    }
    return function((low + high) / 2.0);
}

/// The distance to a triangle, found without any thought of planes or regions: convex in both coordinates together.
double searchedDistance(const Vec3& point, const Corners& corners)
{
    const Vec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    return leastValue([&](double b) {
        return leastValue([&](double c) { return length(point - corners[0] - ab * b - ac * (c * (1.0 - b))); });
    });
}

} // namespace

TEST(ClosestPoint, RegionsOfATriangle)
{
    EXPECT_DOUBLE_EQ(distanceTo({1, 1, 5}, kTriangle), 5.0);   // face
    EXPECT_DOUBLE_EQ(distanceTo({2, -2, 0}, kTriangle), 2.0);  // side along x
    EXPECT_DOUBLE_EQ(distanceTo({-3, 1, 4}, kTriangle), 5.0);  // side along y
    EXPECT_DOUBLE_EQ(distanceTo({4, 3, 0}, kTriangle), 2.4);   // long side: 3 * 4 / 5
    EXPECT_DOUBLE_EQ(distanceTo({-3, -4, 0}, kTriangle), 5.0); // corner
    EXPECT_DOUBLE_EQ(distanceTo({4, 0, 0}, kTriangle), 0.0);   // on a corner
    EXPECT_DOUBLE_EQ(distanceTo({7, 0, -4}, kTriangle), 5.0);  // beyond a corner, along a side
}

TEST(ClosestPoint, TriangleWithoutAreaIsASegmentOrAPoint)
{
    EXPECT_DOUBLE_EQ(distanceTo({1, 2, 0}, {Vec3{0, 0, 0}, Vec3{3, 0, 0}, Vec3{1, 0, 0}}), 2.0);
    EXPECT_DOUBLE_EQ(distanceTo({5, 0, 0}, {Vec3{0, 0, 0}, Vec3{3, 0, 0}, Vec3{1, 0, 0}}), 2.0);
    EXPECT_DOUBLE_EQ(distanceTo({3, 4, 0}, {Vec3{0, 0, 0}, Vec3{0, 0, 0}, Vec3{0, 0, 0}}), 5.0);
    EXPECT_DOUBLE_EQ(distanceTo({1, 2, 0}, {Vec3{0, 0, 0}, Vec3{0, 0, 0}, Vec3{3, 0, 0}}), 2.0);
}

TEST(ClosestPoint, OptimalOnRandomTriangles)
{
    TestRandom random(7);
    for (int i = 0; i < 20000; ++i) {
        const Corners corners{randomPoint(random), randomPoint(random), randomPoint(random)};
        expectClosest(randomPoint(random), corners);
    }
}

TEST(ClosestPoint, SliversOfEveryThickness)
{
    TestRandom random(8);
    for (double thickness = 1.0; thickness > 1e-18; thickness /= 10.0)
        for (int i = 0; i < 10; ++i) {
            const Vec3 a = randomPoint(random), b = randomPoint(random);
            const Vec3 c = a + (b - a) * random.uniform(-0.5, 1.5) + randomPoint(random) * thickness;
            const Vec3 anywhere = randomPoint(random);
            // Near the sliver's plane a badly conditioned normal does most harm.
            const Vec3 inPlane = (a + b + c) * (1.0 / 3.0) + (b - a) * random.uniform(-1, 1);
            for (const Vec3& point : {anywhere, inPlane})
                EXPECT_NEAR(distanceTo(point, {a, b, c}), searchedDistance(point, {a, b, c}), 1e-8) << thickness;
        }
}

TEST(ClosestPoint, BoxIsNeverFartherThanTheTriangle)
{
    TestRandom random(9);
    for (int i = 0; i < 10000; ++i) {
        const Corners corners{randomPoint(random), randomPoint(random), randomPoint(random)};
        const Vec3 point = randomPoint(random) * 2.0;
        EXPECT_FALSE(boxIsFarther(point, corners, closestPointOnTriangle(point, corners).squaredDistance));
    }
    EXPECT_TRUE(boxIsFarther({6, 0, 0}, kTriangle, 3.9));
    EXPECT_FALSE(boxIsFarther({6, 0, 0}, kTriangle, 4.0));
}
