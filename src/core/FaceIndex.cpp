#include "FaceIndex.h"

#include <algorithm>

namespace lodsmith {

namespace {

constexpr std::uint32_t kLeafFaces = 4;

} // namespace

FaceIndex::Node FaceIndex::emptyBox()
{
    Node node{};
    std::fill(node.low, node.low + 3, std::numeric_limits<float>::max());
    std::fill(node.high, node.high + 3, std::numeric_limits<float>::lowest());
    return node;
}

void FaceIndex::extend(Node& node, const float* low, const float* high)
{
    for (int axis = 0; axis < 3; ++axis) {
        node.low[axis] = std::min(node.low[axis], low[axis]);
        node.high[axis] = std::max(node.high[axis], high[axis]);
    }
}

std::uint32_t FaceIndex::nearest(const Vec3& point, double enough, const std::vector<std::uint32_t>& except)
{
    refresh();
    Search search{point, enough * enough, except};
    visit(0, search);
    return search.face;
}

void FaceIndex::refresh()
{
    if (!mFaces.empty() && mMesh.liveFaces > mFaces.size() / 2)
        return;
    mFaces.clear();
    mFaces.reserve(mMesh.liveFaces);
    Node box = emptyBox();
    for (std::uint32_t i = 0; i < mMesh.faces.size(); ++i) {
        if (mMesh.isGone(mMesh.faces[i]))
            continue;
        mFaces.push_back({{0.0f, 0.0f, 0.0f}, i});
        for (std::uint32_t wedge : mMesh.faces[i].wedge) {
            const float* p = mMesh.vertices[mMesh.vertexOf(wedge)].position;
            extend(box, p, p);
            for (int axis = 0; axis < 3; ++axis)
                mFaces.back().centre[axis] += p[axis] / 3.0f;
        }
    }
    mNodes.clear();
    mNodes.reserve(mFaces.size());
    build(0, static_cast<std::uint32_t>(mFaces.size()), box);
}

/// Makes the node for a range of faces, whose centres lie in the given part of space, and all below it.
void FaceIndex::build(std::uint32_t first, std::uint32_t last, Node part)
{
    const std::size_t number = mNodes.size();
    mNodes.push_back(emptyBox());
    if (last - first <= kLeafFaces) {
        Node& leaf = mNodes[number];
        leaf.first = first;
        leaf.count = last - first;
        for (std::uint32_t i = first; i < last; ++i)
            for (std::uint32_t wedge : mMesh.faces[mFaces[i].face].wedge) {
                const float* p = mMesh.vertices[mMesh.vertexOf(wedge)].position;
                extend(leaf, p, p);
            }
        return;
    }
    int axis = 0;
    for (const int other : {1, 2})
        if (part.high[other] - part.low[other] > part.high[axis] - part.low[axis])
            axis = other;
    const std::uint32_t middle = (first + last) / 2;
    std::nth_element(mFaces.begin() + first, mFaces.begin() + middle, mFaces.begin() + last,
                     [axis](const Entry& a, const Entry& b) {
                         return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis] : a.face < b.face;
                     });
    Node lower = part, upper = part;
    lower.high[axis] = upper.low[axis] = mFaces[middle].centre[axis];
    build(first, middle, lower);
    const auto second = static_cast<std::uint32_t>(mNodes.size());
    build(middle, last, upper);
    Node& node = mNodes[number];
    node.first = second;
    for (const std::size_t child : {number + 1, std::size_t{second}})
        extend(node, mNodes[child].low, mNodes[child].high);
}

void FaceIndex::visit(std::uint32_t number, Search& search) const
{
    const Node& node = mNodes[number];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        consider(mFaces[i].face, search);
    if (node.count != 0)
        return;
    std::uint32_t child[2] = {number + 1, node.first};
    double least[2] = {squaredDistance(mNodes[child[0]], search.point),
                       squaredDistance(mNodes[child[1]], search.point)};
    if (least[1] < least[0]) {
        std::swap(child[0], child[1]);
        std::swap(least[0], least[1]);
    }
    for (const int i : {0, 1})
        if (least[i] <= search.squaredDistance
            && search.squaredDistance > search.squaredEnough) // equally near ones count
            visit(child[i], search);
}

void FaceIndex::consider(std::uint32_t number, Search& search) const
{
    const CollapseMesh::Face& face = mMesh.faces[number];
    if (mMesh.isGone(face) || std::find(search.except.begin(), search.except.end(), number) != search.except.end())
        return;
    const Corners corners = mMesh.cornersOf(face);
    if (boxIsFarther(search.point, corners, search.squaredDistance))
        return;
    const double squared = closestPointOnTriangle(search.point, corners).squaredDistance;
    if (squared < search.squaredDistance || (squared == search.squaredDistance && number < search.face)) {
        search.squaredDistance = squared;
        search.face = number;
    }
}

double FaceIndex::squaredDistance(const Node& node, const Vec3& point)
{
    const double coordinate[3] = {point.x, point.y, point.z};
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double gap = std::max({node.low[axis] - coordinate[axis], coordinate[axis] - node.high[axis], 0.0});
        sum += gap * gap;
    }
    return sum;
}

} // namespace lodsmith
