#pragma once

#include "Lanes.h"
#include "Vec3.h"

#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lodsmith {

/// Where the vertices of a mesh are in its poses: four poses side by side, so that they are computed together.
///
/// A place is what one position at rest becomes when it moves: a vertex has as many as it has motions. Scaled units; lanes
/// beyond the last pose are zero, where every length and area is.
class Poses {
public:
    static constexpr std::size_t kLanes = Lanes::kCount;
    static constexpr float kNormalSteps = 127.0f; ///< in one

    struct Group {
        Lanes3 position;
        std::int8_t x[kLanes], y[kLanes], z[kLanes]; ///< mean of the unit normals around, weighted by area; in steps

        Vec3 at(std::size_t lane) const { return {position.x[lane], position.y[lane], position.z[lane]}; }
        Lanes3 meanNormal() const
        {
            return {Lanes::of([this](std::size_t i) { return float(x[i]); }),
                    Lanes::of([this](std::size_t i) { return float(y[i]); }),
                    Lanes::of([this](std::size_t i) { return float(z[i]); })};
        }
    };

    Poses() = default;
    Poses(std::size_t count, std::size_t places)
        : mCount(count), mGroups((count + kLanes - 1) / kLanes), mPlaces(places * mGroups)
    {
    }

    std::size_t count() const { return mCount; }
    std::size_t groups() const { return mGroups; }

    /// The groups of a place, one after the other.
    const Group* of(std::uint32_t place) const { return mPlaces.data() + place * mGroups; }
    Group* of(std::uint32_t place) { return mPlaces.data() + place * mGroups; }

    double radius = 0.0; ///< the largest of any pose, scaled units, from the middle of its box
    /// How far apart two points are at most, in any pose, that count as one place, scaled units.
    double slack = 0.0;

private:
    std::size_t mCount = 0, mGroups = 0;
    std::vector<Group> mPlaces;
};

class CollapseMesh;

/// Fills mesh.poses from the view that the mesh was welded from. Error: InvalidGeometry for a position in a pose that is not
/// finite, and for a pose more than 100 million times as large as the mesh at rest.
std::optional<Error> buildPoses(CollapseMesh& mesh, const MeshView& view);

} // namespace lodsmith
