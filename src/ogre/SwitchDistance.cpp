#include <lodsmith/ogre/SwitchDistance.h>

#include "MainThread.h"

#include <OgreLodStrategy.h>

#include <cmath>

namespace lodsmith {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// Pixels that a world unit covers at a distance of one.
double pixelsOfUnit(const View& view)
{
    LODSMITH_ASSERT(view.width > 0.0 && view.height > 0.0 && view.fieldOfView > 0.0 && view.fieldOfView < kPi,
                    "a view out of range");
    return view.height / 2.0 / std::tan(view.fieldOfView / 2.0);
}

double distanceOfPixels(const Ogre::Mesh& mesh, double pixels, const View& view)
{
    return static_cast<double>(mesh.getBoundingSphereRadius()) * pixelsOfUnit(view) * std::sqrt(kPi / pixels);
}

double halfMeanExtent(const Ogre::Mesh& mesh)
{
    const Ogre::Vector3 size = mesh.getBounds().getSize();
    return (static_cast<double>(size.x) + static_cast<double>(size.y) + static_cast<double>(size.z)) / 6.0;
}

} // namespace

Result<double> switchDistance(const Ogre::Mesh& mesh, double value, const View& view)
{
    assertMainThread();
    if (!std::isfinite(value) || value < 0.0)
        return Error{ErrorCode::InvalidSetting, "a level appears at no number of at least 0", mesh.getName()};
    const Ogre::String& strategy = mesh.getLodStrategy()->getName();
    if (strategy == "distance_sphere")
        return std::hypot(value, static_cast<double>(mesh.getBoundingSphereRadius()));
    if (strategy == "distance_box")
        return value + halfMeanExtent(mesh);
    if (strategy == "pixel_count")
        return distanceOfPixels(mesh, value, view);
    if (strategy == "screen_ratio_pixel_count")
        return distanceOfPixels(mesh, value * view.width * view.height, view);
    return Error{ErrorCode::Unsupported, "what distance its strategy '" + strategy + "' means is not known",
                 mesh.getName()};
}

double pixelsAt(const Ogre::Mesh& mesh, double distance, const View& view)
{
    assertMainThread();
    LODSMITH_ASSERT(distance > 0.0, "a distance that is not above 0");
    const double radius = static_cast<double>(mesh.getBoundingSphereRadius()) / distance * pixelsOfUnit(view);
    return kPi * radius * radius;
}

} // namespace lodsmith
