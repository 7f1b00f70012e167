#pragma once

#include "Vec3.h"

namespace lodsmith {

/// A symmetric 3x3 matrix: a sum of squared distances to planes through the origin.
struct SymmetricMatrix {
    double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;

    /// Adds weight * n * n^T.
    void addSquare(const Vec3& n, double weight)
    {
        const Vec3 w = n * weight;
        xx += w.x * n.x;
        xy += w.x * n.y;
        xz += w.x * n.z;
        yy += w.y * n.y;
        yz += w.y * n.z;
        zz += w.z * n.z;
    }

    void addIdentity(double weight)
    {
        xx += weight;
        yy += weight;
        zz += weight;
    }

    /// e^T * this * e
    double at(const Vec3& e) const
    {
        return e.x * (xx * e.x + 2.0 * (xy * e.y + xz * e.z)) + e.y * (yy * e.y + 2.0 * yz * e.z) + zz * e.z * e.z;
    }
};

} // namespace lodsmith
