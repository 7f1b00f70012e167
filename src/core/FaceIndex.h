#pragma once

#include "CollapseMesh.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace lodsmith {

/// Finds the face nearest to a point: a hierarchy of boxes, eight to a group, over the faces in the order of a Morton curve.
///
/// Faces are put in order by the first search (most meshes are one piece and never need it); boxes are made then and again
/// when half of the faces are gone. In between faces grow out of their boxes. Distances are always those of the faces as
/// they are, but one that was somewhere else when the boxes were made may be missed.
class FaceIndex {
public:
    explicit FaceIndex(const CollapseMesh& mesh) : mMesh(mesh) {}

    /// The nearest face that is none of `except`, or any other that is as near as `enough`. kNone when there is no other.
    std::uint32_t nearest(const Vec3& point, double enough, const std::vector<std::uint32_t>& except);

private:
    static constexpr std::uint32_t kLanes = 8;
    static constexpr float kInfinity = std::numeric_limits<float>::infinity();

    struct Box {
        float low[3] = {kInfinity, kInfinity, kInfinity}, high[3] = {-kInfinity, -kInfinity, -kInfinity};

        void extend(const float* point)
        {
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], point[axis]);
                high[axis] = std::max(high[axis], point[axis]);
            }
        }
    };

    /// The boxes of eight faces or groups, which are measured together; empty ones where there are fewer.
    struct Group {
        Group()
        {
            std::fill_n(low[0], 3 * kLanes, kInfinity);
            std::fill_n(high[0], 3 * kLanes, -kInfinity);
        }

        void set(std::size_t lane, const Box& box);
        Box all() const;
        std::array<float, kLanes> squaredDistances(const Vec3& point) const;

        float low[3][kLanes], high[3][kLanes];
    };

    struct Search {
        Vec3 point;
        double squaredEnough;
        const std::vector<std::uint32_t>& except;
        double squaredDistance = std::numeric_limits<float>::max(); ///< less than that of an empty box
        std::uint32_t face = kNone;
    };

    void refresh();
    void sortFaces();
    void buildLevels();
    Box boundsOfVertices() const;
    Box boxOf(std::uint32_t face) const;
    void visit(std::size_t level, std::size_t group, Search& search) const;
    void consider(std::uint32_t face, Search& search) const;

    const CollapseMesh& mMesh;
    std::vector<std::uint32_t> mFaces;       ///< along the curve
    std::vector<std::vector<Group>> mLevels; ///< lane j of group i: face or group 8 i + j of below. One at last
};

} // namespace lodsmith
