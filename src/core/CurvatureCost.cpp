#include "CurvatureCost.h"

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

constexpr double kLeastBend = 0.001; // so that on a flat surface short edges go first
constexpr double kOffBorder = 1.0;   // leaving a border costs as much as a right angle and more
constexpr double kOffSeam = 1.0;     // in 2012 the bounding radius, which made the result depend on the unit of length

} // namespace

void CurvatureCost::begin(const CollapseMesh& mesh, const OneRing& ring)
{
    mMesh = &mesh;
    mRing = &ring;
    mIsBorder = ring.isBorder();
    const double factor = mesh.importance.empty() ? 1.0 : 1.0 / (1.0 - mesh.importance[ring.vertex]);
    for (std::uint32_t i = 0; i < ring.neighbourCount; ++i)
        mCosts[i] = mWedges.build(mesh, ring, i) ? (bend(i) + seamPenalty(i)) * length(ring.neighbours[i].edge) * factor
                                                 : kImpossible;
}

Candidate CurvatureCost::cheapest()
{
    const double* best = std::min_element(mCosts, mCosts + mRing->neighbourCount);
    return *best == kImpossible ? Candidate{} : Candidate{static_cast<int>(best - mCosts), finite(*best)};
}

double CurvatureCost::bend(std::uint32_t neighbour) const
{
    return mIsBorder ? borderBend(neighbour) : interiorBend(neighbour);
}

double CurvatureCost::borderBend(std::uint32_t neighbour) const
{
    if (mRing->neighbours[neighbour].faces != 1)
        return kOffBorder;
    double most = kLeastBend;
    const Vec3& along = mRing->neighbours[neighbour].edge;
    for (std::uint32_t i = 0; i < mRing->neighbourCount; ++i) {
        if (i == neighbour || mRing->neighbours[i].faces != 1)
            continue;
        const double cosine =
            dot(along, mRing->neighbours[i].edge) / (length(along) * length(mRing->neighbours[i].edge));
        most = std::max(most, 0.5 * (cosine + 1.002));
    }
    return most;
}

double CurvatureCost::interiorBend(std::uint32_t neighbour) const
{
    double most = kLeastBend;
    for (std::uint32_t t = 0; t < mRing->faceCount; ++t) {
        double least = 1.0;
        for (std::uint32_t u = 0; u < mRing->faceCount; ++u)
            if (mRing->contains(mRing->faces[u], neighbour)) {
                const double cosine = dot(CollapseMesh::normalOf(mMesh->faces[mRing->faces[t].face]),
                                          CollapseMesh::normalOf(mMesh->faces[mRing->faces[u].face]));
                least = std::min(least, 0.5 * (1.002 - cosine));
            }
        most = std::max(most, least);
    }
    return most;
}

double CurvatureCost::seamPenalty(std::uint32_t neighbour) const
{
    if (!mRing->isSeam())
        return 0.0;
    const bool toSeam = mMesh->vertices[mRing->neighbours[neighbour].vertex].hasSeam;
    return toSeam ? 0.5 * kOffSeam : kOffSeam;
}

} // namespace lodsmith
