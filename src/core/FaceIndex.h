#pragma once

#include "CollapseMesh.h"

#include <limits>
#include <vector>

namespace lodsmith {

/// Finds the face nearest to a point: a hierarchy of boxes around the faces, halved along their longest side.
///
/// It is made by the first search (most meshes are one piece and never need it) and again when half of the faces are gone.
/// In between faces grow out of their boxes. Distances are always those of the faces as they are, but one that was
/// somewhere else when the boxes were made may be missed.
class FaceIndex {
public:
    explicit FaceIndex(const CollapseMesh& mesh) : mMesh(mesh) {}

    /// The nearest face that is none of `except`, or any other that is as near as `enough`; the lowest number of equally
    /// near ones. kNone when there is no other.
    std::uint32_t nearest(const Vec3& point, double enough, const std::vector<std::uint32_t>& except);

private:
    struct Entry {
        float centre[3];
        std::uint32_t face;
    };

    struct Node {
        float low[3], high[3];
        std::uint32_t first,
            count; ///< its range of mFaces when a leaf; otherwise count is 0 and first the second child
    };

    struct Search {
        Vec3 point;
        double squaredEnough;
        const std::vector<std::uint32_t>& except;
        double squaredDistance = std::numeric_limits<double>::infinity();
        std::uint32_t face = kNone;
    };

    void refresh();
    void build(std::uint32_t first, std::uint32_t last, Node part);
    static Node emptyBox();
    static void extend(Node& node, const float* low, const float* high);
    void visit(std::uint32_t node, Search& search) const;
    void consider(std::uint32_t face, Search& search) const;
    static double squaredDistance(const Node& node, const Vec3& point);

    const CollapseMesh& mMesh;
    std::vector<Entry> mFaces;
    std::vector<Node> mNodes; ///< the first child follows its parent
};

} // namespace lodsmith
