// Cohen, Manocha, Olano: Simplifying Polygonal Models Using Successive Mappings. Visualization 1997.
// Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin: Building an Orthonormal Basis, Revisited. JCGT 6(1), 2017.

#include "PatchDeviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

constexpr double kEdgeOn = 1e-12; // squared cosine; of a face that lies steeper, rounding hides the heights

/// Whether a face with twice this area shows its back, or its edge, to where it is seen with twice that area.
bool isHidden(double seen, double areaSquared)
{
    return (seen < 0.0) | (seen * seen < kEdgeOn * areaSquared);
}

/// The point of the segment from a to b nearest to the origin, as a share of the way.
double nearestToOrigin(const Vec3& a, const Vec3& b)
{
    const Vec3 along = b - a;
    const double squared = lengthSquared(along);
    return squared > 0.0 ? std::clamp(-dot(a, along) / squared, 0.0, 1.0) : 0.0;
}

Vec3 between(const Vec3& a, const Vec3& b, double share)
{
    return a + (b - a) * share;
}

} // namespace

void PatchDeviation::evaluate(const OneRing& ring, const CollapseMesh& mesh, std::uint32_t neighbour)
{
    mRing = &ring;
    mMesh = &mesh;
    double before = 0.0;
    for (std::uint32_t i = 0; i < ring.faceCount; ++i) {
        mBefore[i] = mesh.faces[ring.faces[i].face].deviation;
        before = std::max(before, mBefore[i]);
    }
    const double simple = before + farthestMove(neighbour);
    std::fill(mAfter, mAfter + ring.faceCount, simple);
    mLost = 0.0;
    const bool comesApart = mesh.poses.count() != 0 && !ring.isPosed;
    if (comesApart || !evaluateFans(neighbour)) {
        std::fill(mAfter, mAfter + ring.faceCount, simple);
        mLost = simple;
    }
    mLost = std::min(mLost, simple);
    mLargest = mLost;
    for (std::uint32_t i = 0; i < ring.survivorCount; ++i) {
        double& after = mAfter[ring.survivors[i]];
        after = std::min(after, simple);
        mLargest = std::max(mLargest, after);
    }
}

/// How far the vertex moves, at rest or in a pose.
double PatchDeviation::farthestMove(std::uint32_t neighbour)
{
    const double atRest = length(mRing->neighbours[neighbour].edge);
    if (mMesh->poses.count() == 0)
        return atRest;
    return std::max(atRest, mRing->isPosed ? inPoses({{neighbour, 1.0}}) : farthestSplitMove(neighbour));
}

/// How far in poses where the vertex is at several places at once.
double PatchDeviation::farthestSplitMove(std::uint32_t neighbour)
{
    if (!mWedges.build(*mMesh, *mRing, neighbour))
        return std::numeric_limits<double>::infinity();
    double largest = 0.0;
    for (std::uint32_t i = 0; i < mRing->wedgeCount; ++i) {
        const Poses::Group* from = mMesh->poses.of(mMesh->placeOf(mRing->wedges[i]));
        const Poses::Group* to = mMesh->poses.of(mMesh->placeOf(mWedges.to(i)));
        for (std::size_t group = 0; group < mMesh->poses.groups(); ++group)
            for (std::size_t k = 0; k < Poses::kLanes; ++k)
                largest = std::max(largest, length(to[group].at(k) - from[group].at(k)));
    }
    return largest;
}

/// How far from the vertex a point is, in the pose where that is farthest.
double PatchDeviation::inPoses(std::initializer_list<Share> point) const
{
    double largest = 0.0;
    for (std::size_t group = 0; group < mMesh->poses.groups(); ++group) {
        const Poses::Group& here = mRing->here[group];
        double x[Poses::kLanes] = {}, y[Poses::kLanes] = {}, z[Poses::kLanes] = {};
        for (const Share& share : point) {
            const Poses::Group& there = mRing->there[share.spoke][group];
            for (std::size_t k = 0; k < Poses::kLanes; ++k) {
                x[k] += share.weight * (double{there.position.x[k]} - double{here.position.x[k]});
                y[k] += share.weight * (double{there.position.y[k]} - double{here.position.y[k]});
                z[k] += share.weight * (double{there.position.z[k]} - double{here.position.z[k]});
            }
        }
        for (std::size_t k = 0; k < Poses::kLanes; ++k)
            largest = std::max(largest, x[k] * x[k] + y[k] * y[k] + z[k] * z[k]);
    }
    return std::sqrt(largest);
}

/// False when the faces around the vertex are neither one fan nor the two faces of a wall.
bool PatchDeviation::evaluateFans(std::uint32_t neighbour)
{
    Fan fan;
    if (mRing->isFan && walkFan(fan, neighbour))
        return evaluateFan(fan);
    const Vec3 side = CollapseMesh::normalOf(mMesh->faces[mRing->faces[0].face]);
    std::uint32_t taken = 0;
    if (collectFan(side, 0.0, fan, taken) && taken == mRing->faceCount)
        return startAt(fan, neighbour) && evaluateFan(fan);
    for (const double sign : {1.0, -1.0})
        if (!collectFan(side, sign, fan, taken) || (fan.count != 0 && !(startAt(fan, neighbour) && evaluateFan(fan))))
            return false;
    return true;
}

/// The common case, where the ring knows the order. False when there are several fans.
bool PatchDeviation::walkFan(Fan& fan, std::uint32_t neighbour) const
{
    fan.closed = true;
    std::uint32_t at = neighbour;
    do {
        fan.spokes[fan.count] = at;
        fan.faces[fan.count++] = at;
        at = mRing->faces[at].third;
    } while (at != neighbour);
    return fan.count == mRing->faceCount;
}

/// Chains the faces on one side of a plane through the vertex (sign 0: all faces). False when they are no single fan.
bool PatchDeviation::collectFan(const Vec3& side, double sign, Fan& fan, std::uint32_t& taken) const
{
    constexpr std::int16_t none = -1;
    std::int16_t faceFrom[OneRing::kMaxNeighbours]; // the face that has the neighbour as its second corner
    bool hasBefore[OneRing::kMaxNeighbours];
    std::fill(faceFrom, faceFrom + mRing->neighbourCount, none);
    std::fill(hasBefore, hasBefore + mRing->neighbourCount, false);
    std::uint32_t faces = 0, start = 0;
    for (std::uint32_t i = 0; i < mRing->faceCount; ++i) {
        const OneRing::RingFace& face = mRing->faces[i];
        if (sign != 0.0 && (dot(CollapseMesh::normalOf(mMesh->faces[face.face]), side) >= 0.0) != (sign > 0.0))
            continue;
        if (faceFrom[face.second] != none || hasBefore[face.third])
            return false;
        faceFrom[face.second] = static_cast<std::int16_t>(i);
        hasBefore[face.third] = true;
        start = face.second;
        ++faces;
    }
    fan.count = 0;
    fan.closed = fan.reversed = false;
    if (faces == 0)
        return true;
    for (std::uint32_t i = 0; i < mRing->neighbourCount; ++i)
        if (faceFrom[i] != none && !hasBefore[i])
            start = i;
    fan.closed = hasBefore[start];
    std::uint32_t at = start;
    do {
        fan.spokes[fan.count] = at;
        if (faceFrom[at] == none) {
            ++fan.count;
            break;
        }
        fan.faces[fan.count++] = static_cast<std::uint32_t>(faceFrom[at]);
        at = mRing->faces[faceFrom[at]].third;
    } while (at != start && fan.count <= faces);
    taken += faces;
    return fan.count == faces + (fan.closed ? 0 : 1);
}

/// Turns the fan so that the destination is its first spoke. False when it is none, or lies inside an open fan.
bool PatchDeviation::startAt(Fan& fan, std::uint32_t neighbour) const
{
    const std::uint32_t* end = fan.spokes + fan.count;
    const auto at = std::find(fan.spokes, fan.spokes + fan.count, neighbour) - fan.spokes;
    if (fan.spokes + at == end)
        return false;
    if (fan.closed) {
        std::rotate(fan.spokes, fan.spokes + at, fan.spokes + fan.count);
        std::rotate(fan.faces, fan.faces + at, fan.faces + fan.count);
        return true;
    }
    if (fan.spokes + at == end - 1) {
        std::reverse(fan.spokes, fan.spokes + fan.count);
        std::reverse(fan.faces, fan.faces + fan.count - 1);
        fan.reversed = true;
        return true;
    }
    return at == 0;
}

bool PatchDeviation::evaluateFan(const Fan& fan)
{
    if (!fan.closed)
        return evaluateCut(fan, fan.count - 1);
    return evaluateClosed(fan) || evaluateCut(fan, nearestCut(fan));
}

bool PatchDeviation::evaluateClosed(const Fan& fan)
{
    mIsMoved = false;
    if (!project(fan, {}) || !compareAtCentre(fan))
        return false;
    compareAtCrossings(fan);
    settle(fan, 0.0);
    return true;
}

/// The spoke whose connection with the destination passes nearest to the vertex.
std::uint32_t PatchDeviation::nearestCut(const Fan& fan) const
{
    std::uint32_t cut = 1;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 1; i < fan.count; ++i) {
        const Vec3 &from = mRing->neighbours[fan.spokes[0]].edge, &to = mRing->neighbours[fan.spokes[i]].edge;
        const double distance = lengthSquared(between(from, to, nearestToOrigin(from, to)));
        if (distance < nearest) {
            nearest = distance;
            cut = i;
        }
    }
    return cut;
}

/// Moves the vertex onto the segment from the destination to spoke `cut`, and compares the half (or, of a closed fan, both
/// halves) that now has this segment as its straight side.
bool PatchDeviation::evaluateCut(const Fan& fan, std::uint32_t cut)
{
    const Vec3 &from = mRing->neighbours[fan.spokes[0]].edge, &to = mRing->neighbours[fan.spokes[cut]].edge;
    mIsMoved = true;
    mCut = fan.spokes[cut];
    mTowards = nearestToOrigin(from, to);
    const Vec3 centre = between(from, to, mTowards);
    double shift = length(centre);
    if (mRing->isPosed)
        shift = std::max(shift, inPoses({{fan.spokes[0], 1.0 - mTowards}, {mCut, mTowards}}));
    Fan half;
    half.reversed = fan.reversed;
    for (const bool second : {false, true}) {
        if (second && !fan.closed)
            break;
        half.count = 0;
        if (!second) {
            std::copy(fan.faces, fan.faces + cut, half.faces);
            std::copy(fan.spokes, fan.spokes + cut + 1, half.spokes);
            half.count = cut + 1;
        } else {
            half.reversed = true;
            half.spokes[half.count++] = fan.spokes[0];
            for (std::uint32_t i = fan.count - 1; i >= cut; --i) {
                half.faces[half.count - 1] = fan.faces[i];
                half.spokes[half.count++] = fan.spokes[i];
            }
        }
        if (half.count < 3) {
            mLost = std::max(mLost, mBefore[half.faces[0]] + shift);
            continue;
        }
        if (!project(half, centre))
            return false;
        // The vertex lies on the last new face's side, so that all old faces touch that one there.
        for (std::uint32_t i = 0; i + 1 < half.count; ++i)
            cover(half.count - 2, 0.0, mOld[i]);
        compareAtCrossings(half);
        settle(half, shift);
    }
    return true;
}

/// Lays the fan into the plane across its normal. False unless both the old and the new faces lie there without a fold, and
/// none of them on edge.
bool PatchDeviation::project(const Fan& fan, const Vec3& centre)
{
    const std::uint32_t count = fan.count, faces = fan.closed ? count : count - 1;
    if (!faceOn(fan, centre))
        return false;
    // A closed fan comes once to where it begins; an open one has to end before that.
    const auto side = [&](std::uint32_t i) { return fan.closed ? mV[i] : mU[0] * mV[i] - mU[i] * mV[0]; };
    int rounds = 0;
    for (std::uint32_t i = 0; i < faces; ++i) {
        const std::uint32_t j = i + 1 == count ? 0 : i + 1;
        const Vec3 area = cross(Vec3{mU[i], mV[i], mZ[i]}, Vec3{mU[j], mV[j], mZ[j]});
        if (isHidden(area.z, lengthSquared(area)))
            return false;
        rounds += int(side(i) < 0.0) & int(side(j) >= 0.0);
        mOld[i] = mBefore[fan.faces[i]];
        mCovered[i] = mDifference[i] = 0.0;
    }
    return rounds <= (fan.closed ? 1 : 0);
}

/// Turns the plane to face the new faces, whose areas add to the same sum as the old ones'. False when one of them is hidden.
bool PatchDeviation::faceOn(const Fan& fan, const Vec3& centre)
{
    Vec3 normal;
    for (std::uint32_t j = 1; j + 1 < fan.count; ++j)
        normal += mRing->areaAfter[fan.faces[j]];
    const double size = length(normal);
    if (!(size > 0.0))
        return false;
    const Vec3 n = normal * ((fan.reversed ? -1.0 : 1.0) / size);
    for (std::uint32_t j = 1; j + 1 < fan.count; ++j)
        if (const Vec3& area = mRing->areaAfter[fan.faces[j]]; isHidden(dot(area, normal) / size, lengthSquared(area)))
            return false;
    const double sign = std::copysign(1.0, n.z), a = -1.0 / (sign + n.z), b = n.x * n.y * a;
    const Vec3 u{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, v{b, sign + n.y * n.y * a, -n.y};
    for (std::uint32_t i = 0; i < fan.count; ++i) {
        const Vec3 r = mRing->neighbours[fan.spokes[i]].edge - centre;
        mU[i] = dot(r, u);
        mV[i] = dot(r, v);
        mZ[i] = dot(r, n);
    }
    return true;
}

void PatchDeviation::cover(std::uint32_t newFace, double difference, double before)
{
    mCovered[newFace] = std::max(mCovered[newFace], before);
    mDifference[newFace] = std::max(mDifference[newFace], difference);
}

/// Height of the new faces over the vertex, which is the origin; all old faces meet there.
bool PatchDeviation::compareAtCentre(const Fan& fan)
{
    for (std::uint32_t j = 1; j + 1 < fan.count; ++j) {
        const double w0 = mU[j] * mV[j + 1] - mU[j + 1] * mV[j];
        const double w1 = mU[j + 1] * mV[0] - mU[0] * mV[j + 1];
        const double w2 = mU[0] * mV[j] - mU[j] * mV[0];
        const double sum = w0 + w1 + w2;
        if (w0 >= 0.0 && w1 >= 0.0 && w2 >= 0.0 && sum > 0.0) {
            double height = std::abs(w0 * mZ[0] + w1 * mZ[j] + w2 * mZ[j + 1]) / sum;
            if (mRing->isPosed)
                height = std::max(
                    height,
                    inPoses({{fan.spokes[0], w0 / sum}, {fan.spokes[j], w1 / sum}, {fan.spokes[j + 1], w2 / sum}}));
            cover(j, height, *std::max_element(mOld, mOld + fan.count));
            return true;
        }
    }
    return false;
}

/// Difference in height where an old spoke (from the origin) crosses a new one (from spoke 0's end): there two old faces and
/// two new ones meet.
void PatchDeviation::compareAtCrossings(const Fan& fan)
{
    const std::uint32_t lastOld = fan.closed ? fan.count - 1 : fan.count - 2;
    for (std::uint32_t j = 2; j + 1 < fan.count; ++j) {
        const double du = mU[j] - mU[0], dv = mV[j] - mV[0];
        const double reach = mU[0] * dv - du * mV[0];
        // The new spoke lies in the angle between spokes 0 and j, and so do the old ones that can cross it.
        const std::uint32_t first = reach > 0.0 ? 1 : j + 1, last = reach > 0.0 ? j - 1 : lastOld;
        for (std::uint32_t i = first; i <= last; ++i) {
            const double across = mU[i] * dv - du * mV[i];
            if (across == 0.0)
                continue;
            const double s = reach / across;
            const double t = (mU[0] * mV[i] - mU[i] * mV[0]) / across;
            if (!(s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0))
                continue;
            double difference = std::abs(s * mZ[i] - (mZ[0] + t * (mZ[j] - mZ[0])));
            if (mRing->isPosed)
                difference = std::max(difference, crossingInPoses(fan, i, s, j, t));
            const double before = std::max(mOld[i - 1], mOld[i]);
            cover(j - 1, difference, before);
            cover(j, difference, before);
        }
    }
}

/// How far the point at s of old spoke i, which begins where the vertex has been moved to, is in poses from the one at t of
/// the new spoke to j.
double PatchDeviation::crossingInPoses(const Fan& fan, std::uint32_t i, double s, std::uint32_t j, double t) const
{
    if (!mIsMoved)
        return inPoses({{fan.spokes[i], s}, {fan.spokes[0], t - 1.0}, {fan.spokes[j], -t}});
    return inPoses({{fan.spokes[i], s},
                    {fan.spokes[0], (1.0 - s) * (1.0 - mTowards) + t - 1.0},
                    {mCut, (1.0 - s) * mTowards},
                    {fan.spokes[j], -t}});
}

/// Every new face also covers some of the old one on the same edge of the fan's outline; the first and the last, of the
/// faces that go, too.
void PatchDeviation::settle(const Fan& fan, double shift)
{
    cover(1, 0.0, mOld[0]);
    if (fan.closed)
        cover(fan.count - 2, 0.0, mOld[fan.count - 1]);
    for (std::uint32_t j = 1; j + 1 < fan.count; ++j)
        mAfter[fan.faces[j]] = std::max(mCovered[j], mOld[j]) + mDifference[j] + shift;
}

} // namespace lodsmith
