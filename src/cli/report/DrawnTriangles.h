#pragma once

#include <vector>

namespace lodsmith::cli {

/// What is drawn from a distance on.
struct DrawnLevel {
    double distance = 0.0; ///< world units, >= 0
    double triangles = 0.0;
};

/// Triangles drawn on average between two distances, every doubling of the distance counting the same.
///
/// @param levels level 0 first, at distance 0; of those beyond a distance the last counts, as with OGRE
/// @param near   > 0
/// @param far    > near
double meanTriangles(const std::vector<DrawnLevel>& levels, double near, double far);

/// How many times as many triangles as `other` a chain draws where that is worst between two distances; where it begins
/// to be so goes to `from`.
double worstExcess(const std::vector<DrawnLevel>& levels, const std::vector<DrawnLevel>& other, double near, double far,
                   double& from);

/// A point of a curve of deviation over triangles.
struct CurvePoint {
    double triangles = 0.0;
    double deviation = 0.0;
};

/// How many times as many triangles a curve needs as another one for the same deviation: the geometric mean over its
/// points with 3 % to 60 % of its first point's triangles. 1 when the two have nothing in common. Curves begin with the
/// most triangles.
double trianglesFactor(const std::vector<CurvePoint>& curve, const std::vector<CurvePoint>& other);

} // namespace lodsmith::cli
