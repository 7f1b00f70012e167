// Cohen, Manocha, Olano: Simplifying Polygonal Models Using Successive Mappings. Visualization 1997.

#include "PatchDeviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// The point of the segment from a to b nearest to the origin.
Vec3 nearestToOrigin(const Vec3& a, const Vec3& b)
{
    const Vec3 along = b - a;
    const double squared = lengthSquared(along);
    const double t = squared > 0.0 ? std::clamp(-dot(a, along) / squared, 0.0, 1.0) : 0.0;
    return a + along * t;
}

} // namespace

double PatchDeviation::bound(const OneRing& ring, const CollapseMesh& mesh, std::uint32_t neighbour)
{
    const double edgeLength = length(ring.edge[neighbour]);
    const float* n = mesh.faces[ring.faces[0].face].normal;
    const Vec3 side{n[0], n[1], n[2]};
    Fan fan;
    std::uint32_t taken = 0;
    if (collectFan(ring, mesh, side, 0.0, fan, taken) && taken == ring.faceCount)
        return std::min(edgeLength, fanBound(ring, fan, neighbour));
    // Not one fan: perhaps the two faces of a wall.
    double largest = 0.0;
    taken = 0;
    for (const double sign : {1.0, -1.0}) {
        if (!collectFan(ring, mesh, side, sign, fan, taken))
            return edgeLength;
        if (fan.count != 0)
            largest = std::max(largest, fanBound(ring, fan, neighbour));
    }
    return std::min(edgeLength, largest);
}

/// Chains the faces on one side of a plane through the vertex (sign 0: all faces). False when they are no single fan.
bool PatchDeviation::collectFan(const OneRing& ring, const CollapseMesh& mesh, const Vec3& side, double sign, Fan& fan, std::uint32_t& taken) const
{
    std::int16_t next[OneRing::kMaxNeighbours];
    bool hasBefore[OneRing::kMaxNeighbours];
    std::fill(next, next + ring.neighbourCount, std::int16_t{-1});
    std::fill(hasBefore, hasBefore + ring.neighbourCount, false);
    fan.normal = {};
    fan.count = 0;
    fan.closed = false;
    std::uint32_t faces = 0;
    int start = -1;
    for (std::uint32_t i = 0; i < ring.faceCount; ++i) {
        const CollapseMesh::Face& face = mesh.faces[ring.faces[i].face];
        const Vec3 normal{face.normal[0], face.normal[1], face.normal[2]};
        if (sign != 0.0 && (dot(normal, side) >= 0.0) != (sign > 0.0))
            continue;
        if (next[ring.faces[i].second] >= 0 || hasBefore[ring.faces[i].third])
            return false;
        next[ring.faces[i].second] = static_cast<std::int16_t>(ring.faces[i].third);
        hasBefore[ring.faces[i].third] = true;
        fan.normal += normal * face.area;
        start = ring.faces[i].second;
        ++faces;
    }
    if (faces == 0)
        return true;
    for (std::uint32_t i = 0; i < ring.neighbourCount; ++i)
        if (next[i] >= 0 && !hasBefore[i])
            start = static_cast<int>(i);
    fan.closed = hasBefore[start];
    for (int at = start; at >= 0 && fan.count <= faces; at = next[at]) {
        if (fan.count != 0 && at == start)
            break;
        fan.spokes[fan.count++] = static_cast<std::uint32_t>(at);
    }
    taken += faces;
    return fan.count == faces + (fan.closed ? 0 : 1);
}

double PatchDeviation::fanBound(const OneRing& ring, Fan& fan, std::uint32_t neighbour)
{
    std::uint32_t* end = fan.spokes + fan.count;
    std::uint32_t* destination = std::find(fan.spokes, end, neighbour);
    if (destination == end)
        return kUnknown;
    if (!fan.closed) {
        if (destination == end - 1)
            std::reverse(fan.spokes, end);
        else if (destination != fan.spokes)
            return kUnknown;
        return cutBound(ring, fan.spokes, fan.count, false, fan.count - 1);
    }
    std::rotate(fan.spokes, destination, end);
    if (const double whole = closedBound(ring, fan); whole != kUnknown)
        return whole;
    std::uint32_t cut = 1;
    double nearest = kUnknown;
    for (std::uint32_t i = 1; i < fan.count; ++i) {
        const double distance = length(nearestToOrigin(ring.edge[neighbour], ring.edge[fan.spokes[i]]));
        if (distance < nearest) {
            nearest = distance;
            cut = i;
        }
    }
    return cutBound(ring, fan.spokes, fan.count, true, cut);
}

double PatchDeviation::closedBound(const OneRing& ring, const Fan& fan)
{
    if (!project(ring, fan.spokes, fan.count, {}, fan.normal, true))
        return kUnknown;
    return std::max(differenceAtCentre(fan.count), largestDifference(fan.count, true));
}

/// Moves the vertex onto the segment from spokes[0] to spokes[cut], and compares the half (or, when closed, both halves)
/// of the fan that now has this segment as its straight side.
double PatchDeviation::cutBound(const OneRing& ring, const std::uint32_t* spokes, std::uint32_t count, bool closed, std::uint32_t cut)
{
    const Vec3 centre = nearestToOrigin(ring.edge[spokes[0]], ring.edge[spokes[cut]]);
    double largest = 0.0;
    std::uint32_t half[OneRing::kMaxNeighbours];
    for (int side = 0; side < (closed ? 2 : 1); ++side) {
        std::uint32_t size = 0;
        if (side == 0) {
            size = cut + 1;
            std::copy(spokes, spokes + size, half);
        } else {
            half[size++] = spokes[0];
            for (std::uint32_t i = count - 1; i >= cut; --i)
                half[size++] = spokes[i];
        }
        Vec3 normal;
        for (std::uint32_t i = 0; i + 1 < size; ++i)
            normal += cross(ring.edge[half[i]] - centre, ring.edge[half[i + 1]] - centre);
        if (size < 3)
            continue;
        if (!project(ring, half, size, centre, normal, false))
            return kUnknown;
        largest = std::max(largest, largestDifference(size, false));
    }
    return length(centre) + largest;
}

/// Lays the fan into the plane across `normal`. False unless both the old and the new faces lie there without a fold.
bool PatchDeviation::project(const OneRing& ring, const std::uint32_t* spokes, std::uint32_t count, const Vec3& centre, const Vec3& normal, bool closed)
{
    const double size = length(normal);
    if (!(size > 0.0))
        return false;
    const Vec3 n = normal * (1.0 / size);
    const Vec3 helper = std::abs(n.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    const Vec3 across = cross(n, helper);
    const Vec3 u = across * (1.0 / length(across));
    const Vec3 v = cross(n, u);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3 r = ring.edge[spokes[i]] - centre;
        mU[i] = dot(r, u);
        mV[i] = dot(r, v);
        mZ[i] = dot(r, n);
    }
    const auto turn = [this](std::uint32_t a, std::uint32_t b) { return mU[a] * mV[b] - mU[b] * mV[a]; };
    int rounds = 0;
    for (std::uint32_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
        const std::uint32_t j = i + 1 == count ? 0 : i + 1;
        if (turn(i, j) < 0.0)
            return false;
        rounds += mV[i] < 0.0 && mV[j] >= 0.0;
    }
    for (std::uint32_t j = 1; j + 1 < count; ++j)
        if ((mU[j] - mU[0]) * (mV[j + 1] - mV[0]) - (mU[j + 1] - mU[0]) * (mV[j] - mV[0]) < 0.0)
            return false;
    return rounds <= 1;
}

/// Height of the new faces over the vertex, which is the origin.
double PatchDeviation::differenceAtCentre(std::uint32_t count) const
{
    for (std::uint32_t j = 1; j + 1 < count; ++j) {
        const double w0 = mU[j] * mV[j + 1] - mU[j + 1] * mV[j];
        const double w1 = mU[j + 1] * mV[0] - mU[0] * mV[j + 1];
        const double w2 = mU[0] * mV[j] - mU[j] * mV[0];
        const double sum = w0 + w1 + w2;
        if (w0 >= 0.0 && w1 >= 0.0 && w2 >= 0.0 && sum > 0.0)
            return std::abs(w0 * mZ[0] + w1 * mZ[j] + w2 * mZ[j + 1]) / sum;
    }
    return kUnknown;
}

/// Largest difference in height where an old spoke (from the origin) crosses a new one (from spoke 0's end).
double PatchDeviation::largestDifference(std::uint32_t count, bool closed) const
{
    double largest = 0.0;
    const std::uint32_t lastNew = count - 2;
    const std::uint32_t lastOld = closed ? count - 1 : count - 2;
    for (std::uint32_t j = 2; j <= lastNew && count >= 4; ++j) {
        const double du = mU[j] - mU[0], dv = mV[j] - mV[0];
        const double reach = mU[0] * dv - du * mV[0];
        for (std::uint32_t i = 1; i <= lastOld; ++i) {
            const double across = mU[i] * dv - du * mV[i];
            if (i == j || across == 0.0)
                continue;
            const double s = reach / across;
            const double t = (mU[0] * mV[i] - mU[i] * mV[0]) / across;
            if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0)
                largest = std::max(largest, std::abs(s * mZ[i] - (mZ[0] + t * (mZ[j] - mZ[0]))));
        }
    }
    return largest;
}

} // namespace lodsmith
