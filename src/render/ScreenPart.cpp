#include "ScreenPart.h"

#include <OgreAxisAlignedBox.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace lodsmith {

namespace {

/// A share of the distance that the camera keeps from what it sees.
constexpr double kNearest = 1e-3;
/// Room before and behind what is seen, as a share of the distance.
constexpr double kDepthRoom = 0.01;

/// Points are this many world units to the right of the target, above it and nearer to the camera.
class ViewAxes {
public:
    explicit ViewAxes(const Ogre::Vector3& direction) { orientationOf(direction).ToAxes(mX, mY, mZ); }

    double x(const Ogre::Vector3& offset) const { return static_cast<double>(mX.dotProduct(offset)); }
    double y(const Ogre::Vector3& offset) const { return static_cast<double>(mY.dotProduct(offset)); }
    double z(const Ogre::Vector3& offset) const { return static_cast<double>(mZ.dotProduct(offset)); }

private:
    Ogre::Vector3 mX, mY, mZ;
};

/// Least and largest of some numbers.
struct Range {
    double least = HUGE_VAL;
    double most = -HUGE_VAL;

    void add(double number)
    {
        least = std::min(least, number);
        most = std::max(most, number);
    }
};

/// The pixels of a range, with room around, within half a screen to either side.
std::pair<int, int> spanOf(const Range& range, unsigned size)
{
    const int upwards = static_cast<int>(size / 2), downwards = upwards - static_cast<int>(size);
    const auto limited = [&](double pixel) {
        return static_cast<int>(std::clamp(pixel, double(downwards), double(upwards)));
    };
    int first = limited(std::floor(range.least) - kMargin), last = limited(std::ceil(range.most) + kMargin);
    if (first < last)
        return {first, last};
    return first < upwards ? std::pair(first, first + 1) : std::pair(first - 1, first);
}

} // namespace

Ogre::Quaternion orientationOf(const Ogre::Vector3& direction)
{
    const bool isSteep = std::abs(direction.y) > 0.9999f;
    const Ogre::Vector3 up = isSteep ? Ogre::Vector3::NEGATIVE_UNIT_Z : Ogre::Vector3::UNIT_Y;
    const Ogre::Vector3 right = up.crossProduct(direction).normalisedCopy();
    return Ogre::Quaternion(right, direction.crossProduct(right), direction);
}

ScreenPart screenPartOf(const std::vector<Ogre::Vector3>& points, const Viewpoint& viewpoint)
{
    const ViewAxes axes(viewpoint.direction);
    const double focal = pixelsOf(1.0, 1.0, viewpoint.screen);
    Range across, upwards, depth;
    for (const Ogre::Vector3& point : points) {
        const Ogre::Vector3 offset = point - viewpoint.target;
        const double pointDepth = viewpoint.distance - axes.z(offset);
        depth.add(pointDepth);
        across.add(focal * axes.x(offset) / pointDepth);
        upwards.add(focal * axes.y(offset) / pointDepth);
    }
    ScreenPart part;
    const double nearest = kNearest * viewpoint.distance, room = kDepthRoom * viewpoint.distance;
    part.near = std::max(depth.least - room, nearest);
    part.far = std::max(depth.most + room, 2 * nearest);
    if (depth.least < nearest)
        across = upwards = {-HUGE_VAL, HUGE_VAL};
    std::tie(part.left, part.right) = spanOf(across, viewpoint.screen.width);
    std::tie(part.bottom, part.top) = spanOf(upwards, viewpoint.screen.height);
    return part;
}

Viewpoint viewpointFor(const std::vector<Ogre::Vector3>& points, const Ogre::Vector3& direction, unsigned size)
{
    Ogre::AxisAlignedBox box;
    for (const Ogre::Vector3& point : points)
        box.merge(point);
    Viewpoint viewpoint;
    viewpoint.target = box.getCenter();
    viewpoint.direction = direction;
    viewpoint.screen.width = viewpoint.screen.height = size;
    const double slope = (size / 2.0 - kMargin) / pixelsOf(1.0, 1.0, viewpoint.screen);
    const ViewAxes axes(direction);
    double distance = 0;
    for (const Ogre::Vector3& point : points) {
        const Ogre::Vector3 offset = point - viewpoint.target;
        distance =
            std::max(distance, axes.z(offset) + std::max(std::abs(axes.x(offset)), std::abs(axes.y(offset))) / slope);
    }
    viewpoint.distance = distance > 0 ? distance : 1.0; // a single point
    return viewpoint;
}

} // namespace lodsmith
