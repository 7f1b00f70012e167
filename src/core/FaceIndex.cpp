#include "FaceIndex.h"

#include <algorithm>

namespace lodsmith {

namespace {

constexpr std::uint32_t kLeafFaces = 4;

} // namespace

std::uint32_t FaceIndex::nearest(const Vec3& point, const std::vector<std::uint32_t>& except)
{
    refresh();
    Search search{point, except};
    visit(0, search);
    return search.face;
}

void FaceIndex::refresh()
{
    if (!mFaces.empty() && mMesh.liveFaces > mFaces.size() / 4)
        return;
    mFaces.clear();
    mFaces.reserve(mMesh.liveFaces);
    for (std::uint32_t i = 0; i < mMesh.faces.size(); ++i)
        if (!mMesh.isGone(mMesh.faces[i]))
            mFaces.push_back(i);
    mNodes.clear();
    build(0, static_cast<std::uint32_t>(mFaces.size()));
}

void FaceIndex::build(std::uint32_t first, std::uint32_t last)
{
    const std::size_t number = mNodes.size();
    mNodes.push_back(boxAround(first, last));
    if (last - first <= kLeafFaces)
        return;
    const Node& box = mNodes[number];
    int axis = 0;
    for (const int other : {1, 2})
        if (box.high[other] - box.low[other] > box.high[axis] - box.low[axis])
            axis = other;
    const auto key = [&](std::uint32_t face) {
        float sum = 0.0f;
        for (std::uint32_t wedge : mMesh.faces[face].wedge)
            sum += mMesh.vertices[mMesh.vertexOf(wedge)].position[axis];
        return sum;
    };
    const std::uint32_t middle = (first + last) / 2;
    std::nth_element(mFaces.begin() + first, mFaces.begin() + middle, mFaces.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    build(first, middle);
    mNodes[number].count = 0;
    mNodes[number].first = static_cast<std::uint32_t>(mNodes.size());
    build(middle, last);
}

FaceIndex::Node FaceIndex::boxAround(std::uint32_t first, std::uint32_t last) const
{
    Node node;
    std::fill(node.low, node.low + 3, std::numeric_limits<float>::max());
    std::fill(node.high, node.high + 3, std::numeric_limits<float>::lowest());
    for (std::uint32_t i = first; i < last; ++i)
        for (std::uint32_t wedge : mMesh.faces[mFaces[i]].wedge)
            for (int axis = 0; axis < 3; ++axis) {
                const float coordinate = mMesh.vertices[mMesh.vertexOf(wedge)].position[axis];
                node.low[axis] = std::min(node.low[axis], coordinate);
                node.high[axis] = std::max(node.high[axis], coordinate);
            }
    node.first = first;
    node.count = last - first;
    return node;
}

void FaceIndex::visit(std::uint32_t number, Search& search) const
{
    const Node& node = mNodes[number];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        consider(mFaces[i], search);
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
        if (least[i] <= search.squaredDistance) // equally near ones count
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
