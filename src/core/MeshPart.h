#pragma once

#include "CollapseMesh.h"
#include "Partition.h"
#include "QueueStates.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace lodsmith {

/// One part of a mesh as a small mesh of its own, which fits a cache, and which one thread collapses while others do the same
/// with other parts.
///
/// Its vertices are, in this order: inner ones, all of whose neighbours are in the part; the rim; and beyond it the rim's
/// neighbours in other parts, known by their positions alone. Only inner ones may be collapsed. So every face that changes has
/// all its corners in the part, and all else that a collapse reads is here.
class MeshPart {
public:
    /// The whole and the partition stay as they are while the part is in use, but for what other parts write.
    MeshPart(const CollapseMesh& whole, const QueueStates& states, const Partition& partition, std::size_t part);

    CollapseMesh& mesh() { return mMesh; }
    QueueStates& states() { return mStates; }
    std::uint32_t innerCount() const { return mInner; }
    std::uint32_t ownCount() const { return mOwn; } ///< inner ones and the rim

    /// Writes what became of the part into the whole, but not into its counts and face lists. No two parts touch the same
    /// entries, so that threads may do this at once.
    void writeTo(CollapseMesh& whole, QueueStates& states) const;

    /// Bounds of faces that reach into other parts, as far as they were raised here: face of the whole, bound.
    std::vector<std::pair<std::uint32_t, float>> raisedBeyond(const CollapseMesh& whole) const;

private:
    void numberVertices(const CollapseMesh& whole);
    void addVertices(const CollapseMesh& whole);
    void addWedges(const CollapseMesh& whole);
    void addFaces(const CollapseMesh& whole);
    void addStates(const QueueStates& states);
    void writeFaces(CollapseMesh& whole) const;
    bool isOwn(std::uint32_t vertex) const { return mPlace[vertex] - mFirst < mOwn; }
    bool isOwn(const CollapseMesh& whole, const CollapseMesh::Face& face) const;
    std::uint32_t numberOf(std::uint32_t vertex) const;
    std::uint32_t wedgeNumberOf(const CollapseMesh& whole, std::uint32_t wedge) const;

    CollapseMesh mMesh;
    QueueStates mStates{0};
    const std::uint32_t* mPlace;    ///< of each vertex of the whole, in the partition's list
    const std::uint32_t* mVertices; ///< of the whole, that are here
    const std::uint32_t* mFaces;    ///< likewise
    std::uint32_t mFirst;           ///< place of the first vertex
    std::uint32_t mOwn;             ///< inner vertices and the rim
    std::uint32_t mInner = 0;
    std::uint32_t mFaceCount;
    std::vector<std::uint32_t> mNumbers; ///< here, of the own vertices in the order of the list
    std::vector<std::uint32_t> mBeyond;  ///< vertices of the whole, ascending
    std::vector<std::uint32_t> mWedges;  ///< of the whole, by their numbers here
    std::vector<std::uint32_t> mShared;  ///< faces that reach into other parts, by their numbers here, ascending
};

} // namespace lodsmith
