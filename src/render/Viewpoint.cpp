#include <lodsmith/render/Viewpoint.h>

#include <lodsmith/ogre/SwitchDistance.h>

#include <OgreLodStrategy.h>

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

constexpr double kPi = 3.14159265358979323846;

Ogre::Vector3 directionOf(double azimuth, double elevation)
{
    const double across = azimuth / 180 * kPi, up = elevation / 180 * kPi;
    return Ogre::Vector3(static_cast<Ogre::Real>(std::sin(across) * std::cos(up)),
                         static_cast<Ogre::Real>(std::sin(up)),
                         static_cast<Ogre::Real>(std::cos(across) * std::cos(up)));
}

/// Where a box is so far away from a camera that goes away from the origin.
double distanceFromBox(double value, const Ogre::AxisAlignedBox& box, const Ogre::Vector3& direction)
{
    const auto isBeyond = [&](double distance) {
        return std::sqrt(static_cast<double>(box.squaredDistance(direction * static_cast<Ogre::Real>(distance))))
               >= value;
    };
    const double reach = static_cast<double>(box.getCenter().length() + box.getHalfSize().length());
    double near = 0, far = value + reach;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = (near + far) / 2;
        (isBeyond(middle) ? far : near) = middle;
    }
    return far;
}

} // namespace

double pixelsOf(double length, double distance, const Screen& screen)
{
    return length / distance * screen.height / 2 / std::tan(screen.fieldOfView / 2);
}

const std::array<Ogre::Vector3, kViewDirections>& viewDirections()
{
    static const std::array<Ogre::Vector3, kViewDirections> directions = {
        directionOf(20, 5),  directionOf(80, 30),  directionOf(140, 5), directionOf(200, 30),
        directionOf(260, 5), directionOf(320, 30), directionOf(50, 75), directionOf(230, -30),
    };
    return directions;
}

Result<double> switchDistance(const Ogre::Mesh& mesh, unsigned level, const Ogre::Vector3& direction,
                              const Screen& screen)
{
    if (level == 0 || level >= mesh.getNumLodLevels())
        return Error{ErrorCode::InvalidSetting, "there is no switch to level " + std::to_string(level), mesh.getName()};
    const auto value = static_cast<double>(mesh.getLodLevel(static_cast<Ogre::ushort>(level)).userValue);
    const bool isOfBox = mesh.getLodStrategy()->getName() == "distance_box";
    Result<double> distance =
        isOfBox && value >= 0.0 && std::isfinite(value)
            ? distanceFromBox(value, mesh.getBounds(), direction)
            : switchDistance(mesh, value, View{double(screen.width), double(screen.height), screen.fieldOfView});
    if (distance && !(distance.value() > 0.0))
        return Error{ErrorCode::Unsupported, "level " + std::to_string(level) + " appears inside the mesh",
                     mesh.getName()};
    return distance;
}

} // namespace lodsmith
