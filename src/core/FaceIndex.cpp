// Morton: A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing. IBM, 1966.

#include "FaceIndex.h"

namespace lodsmith {

namespace {

constexpr float kCells = 1023.0f; // of the curve along the longest side: ten bits

/// Ten bits, with two zeros between.
std::uint32_t spread(float cell)
{
    auto bits = static_cast<std::uint32_t>(cell);
    bits = (bits | bits << 16) & 0x030000FFu;
    bits = (bits | bits << 8) & 0x0300F00Fu;
    bits = (bits | bits << 4) & 0x030C30C3u;
    return (bits | bits << 2) & 0x09249249u;
}

float gap(float low, float value, float high)
{
    return std::max(std::max(low - value, value - high), 0.0f);
}

} // namespace

void FaceIndex::Group::set(std::size_t lane, const Box& box)
{
    for (int axis = 0; axis < 3; ++axis) {
        low[axis][lane] = box.low[axis];
        high[axis][lane] = box.high[axis];
    }
}

FaceIndex::Box FaceIndex::Group::all() const
{
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = *std::min_element(low[axis], low[axis] + kLanes);
        box.high[axis] = *std::max_element(high[axis], high[axis] + kLanes);
    }
    return box;
}

std::array<float, FaceIndex::kLanes> FaceIndex::Group::squaredDistances(const Vec3& point) const
{
    const auto px = static_cast<float>(point.x), py = static_cast<float>(point.y), pz = static_cast<float>(point.z);
    std::array<float, kLanes> squared;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = gap(low[0][i], px, high[0][i]), y = gap(low[1][i], py, high[1][i]),
                    z = gap(low[2][i], pz, high[2][i]);
        squared[i] = x * x + y * y + z * z;
    }
    return squared;
}

std::uint32_t FaceIndex::nearest(const Vec3& point, double enough, const std::vector<std::uint32_t>& except)
{
    refresh();
    Search search{point, enough * enough, except};
    visit(mLevels.size() - 1, 0, search);
    return search.face;
}

void FaceIndex::refresh()
{
    if (!mFaces.empty() && mMesh.liveFaces > mFaces.size() / 2)
        return;
    if (mFaces.empty())
        sortFaces();
    else
        mFaces.erase(std::remove_if(mFaces.begin(), mFaces.end(),
                                    [this](std::uint32_t face) { return mMesh.isGone(mMesh.faces[face]); }),
                     mFaces.end());
    buildLevels();
}

void FaceIndex::sortFaces()
{
    const Box bounds = boundsOfVertices();
    float size = std::numeric_limits<float>::min();
    for (int axis = 0; axis < 3; ++axis)
        size = std::max(size, bounds.high[axis] - bounds.low[axis]);
    std::vector<std::uint64_t> keys;
    keys.reserve(mMesh.liveFaces);
    for (std::uint32_t face = 0; face < mMesh.faces.size(); ++face) {
        if (mMesh.isGone(mMesh.faces[face]))
            continue;
        const float* corner = mMesh.vertices[mMesh.vertexOf(mMesh.faces[face].wedge[0])].position;
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis)
            key = key << 1 | spread((corner[axis] - bounds.low[axis]) / size * kCells);
        keys.push_back(key << 32 | face);
    }
    std::sort(keys.begin(), keys.end());
    mFaces.reserve(keys.size());
    for (const std::uint64_t key : keys)
        mFaces.push_back(static_cast<std::uint32_t>(key));
}

FaceIndex::Box FaceIndex::boundsOfVertices() const
{
    Box bounds;
    for (const CollapseMesh::Vertex& vertex : mMesh.vertices)
        if (vertex.liveFaces != 0)
            bounds.extend(vertex.position);
    return bounds;
}

void FaceIndex::buildLevels()
{
    mLevels.assign(1, std::vector<Group>((mFaces.size() + kLanes - 1) / kLanes));
    for (std::size_t i = 0; i < mFaces.size(); ++i)
        mLevels[0][i / kLanes].set(i % kLanes, boxOf(mFaces[i]));
    while (mLevels.back().size() > 1) {
        const std::vector<Group>& below = mLevels.back();
        std::vector<Group> level((below.size() + kLanes - 1) / kLanes);
        for (std::size_t i = 0; i < below.size(); ++i)
            level[i / kLanes].set(i % kLanes, below[i].all());
        mLevels.push_back(std::move(level));
    }
}

FaceIndex::Box FaceIndex::boxOf(std::uint32_t face) const
{
    Box box;
    for (std::uint32_t wedge : mMesh.faces[face].wedge)
        box.extend(mMesh.vertices[mMesh.vertexOf(wedge)].position);
    return box;
}

void FaceIndex::visit(std::size_t level, std::size_t group, Search& search) const
{
    std::array<float, kLanes> least = mLevels[level][group].squaredDistances(search.point);
    while (search.squaredDistance > search.squaredEnough) {
        const auto nearest = std::min_element(least.begin(), least.end());
        if (*nearest > search.squaredDistance)
            return;
        *nearest = kInfinity;
        const std::size_t child = group * kLanes + static_cast<std::size_t>(nearest - least.begin());
        if (level == 0)
            consider(mFaces[child], search);
        else
            visit(level - 1, child, search);
    }
}

void FaceIndex::consider(std::uint32_t number, Search& search) const
{
    const CollapseMesh::Face& face = mMesh.faces[number];
    if (mMesh.isGone(face) || std::find(search.except.begin(), search.except.end(), number) != search.except.end())
        return;
    const Corners corners = mMesh.cornersOf(face);
    const double height = dot(CollapseMesh::normalOf(face), search.point - corners[0]);
    if (height * height > search.squaredDistance)
        return; // its plane is farther already
    const double squared = closestPointOnTriangle(search.point, corners).squaredDistance;
    if (squared < search.squaredDistance) {
        search.squaredDistance = squared;
        search.face = number;
    }
}

} // namespace lodsmith
