#include "Weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <optional>

namespace lodsmith {

namespace {

constexpr float kLargest = 1e18f;               // the square of a length stays inside a float
constexpr float kBoneTolerance = 1.0f / 256.0f; // what exporters round away
constexpr float kOffsetTolerance = 1e-5f;       // share of the offset; what exporters round away
constexpr std::uint32_t kBlock = 32;            // triangles
constexpr std::uint32_t kExtra = 0x80000000u;   // marks a further wedge while the number of vertices is not known yet

using Position = std::array<float, 3>;

Position readPosition(const VertexBufferView& buffer, std::uint32_t index)
{
    Position p;
    buffer.positions.read(index, 3, p.data());
    return {p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f}; // -0 and 0 are one position
}

std::size_t hashOf(const Position& p)
{
    std::uint32_t bits[3];
    std::memcpy(bits, p.data(), sizeof bits);
    std::uint64_t h = bits[0] * 0x9E3779B97F4A7C15ull;
    h = (h ^ (h >> 29) ^ bits[1]) * 0xBF58476D1CE4E5B9ull;
    h = (h ^ (h >> 32) ^ bits[2]) * 0x94D049BB133111EBull;
    return static_cast<std::size_t>(h ^ (h >> 31));
}

using Triple = std::array<std::uint32_t, 3>;

/// The same whichever corner comes first.
std::uint32_t hashOf(const Triple& v)
{
    constexpr std::uint64_t k = 0x9E3779B97F4A7C15ull;
    return static_cast<std::uint32_t>(((k + v[0]) * (k + v[1]) * (k + v[2])) >> 32);
}

/// Whether two faces have the same vertices and winding.
bool sameFace(const Triple& a, const Triple& b)
{
    return a == b || a == Triple{b[1], b[2], b[0]} || a == Triple{b[2], b[0], b[1]};
}

/// Size of a hash table, a power of two.
std::size_t slotsFor(std::size_t entries)
{
    std::size_t slots = 16;
    while (slots < entries + entries / 2)
        slots *= 2;
    return slots;
}

/// Up to four floats of a vertex, with zeros for the rest, or for all when there is no stream.
std::array<float, 4> tupleAt(const FloatStream& stream, std::uint32_t index, int count)
{
    std::array<float, 4> tuple{};
    if (!stream)
        return tuple;
    switch (count) { // a copy of a size known beforehand needs no call
    case 1: stream.read(index, 1, tuple.data()); break;
    case 2: stream.read(index, 2, tuple.data()); break;
    case 3: stream.read(index, 3, tuple.data()); break;
    default: stream.read(index, 4, tuple.data()); break;
    }
    return tuple;
}

bool sameTuple(const FloatStream& stream, std::uint32_t a, std::uint32_t b, int count)
{
    return tupleAt(stream, a, count) == tupleAt(stream, b, count);
}

bool finiteTuple(const FloatStream& stream, std::uint32_t index, int count)
{
    if (!stream)
        return true;
    const std::array<float, 4> v = tupleAt(stream, index, count);
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]) && std::isfinite(v[3]);
}

float weightOf(const BoneInfluences& influences, std::uint16_t bone)
{
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i)
        if (influences.bone[i] == bone)
            sum += influences.weight[i];
    return sum;
}

bool sameBones(const BoneInfluences& a, const BoneInfluences& b)
{
    for (int i = 0; i < 4; ++i)
        if (std::abs(weightOf(a, a.bone[i]) - weightOf(b, a.bone[i])) > kBoneTolerance
            || std::abs(weightOf(a, b.bone[i]) - weightOf(b, b.bone[i])) > kBoneTolerance)
            return false;
    return true;
}

/// One buffer vertex, as the welding compares it.
struct BufferVertex {
    const VertexBufferView* buffer;
    std::uint32_t index;
};

Position offsetOf(const BufferVertex& v, std::size_t pose)
{
    Position offset{};
    if (pose < v.buffer->offsets.size() && v.buffer->offsets[pose])
        v.buffer->offsets[pose].read(v.index, 3, offset.data());
    return offset;
}

/// How far a pose moves a vertex.
Position motionOf(const BufferVertex& v, std::size_t pose)
{
    Position posed;
    positionsInPose(*v.buffer, pose).read(v.index, 3, posed.data());
    const Position rest = readPosition(*v.buffer, v.index);
    return {posed[0] - rest[0], posed[1] - rest[1], posed[2] - rest[2]};
}

bool nearlySame(const Position& a, const Position& b)
{
    for (int i = 0; i < 3; ++i)
        if (std::abs(a[i] - b[i]) > kOffsetTolerance * std::max(std::abs(a[i]), std::abs(b[i])))
            return false;
    return true;
}

/// Whether two vertices move together in every pose; `motion` is one of the two above.
template <class MotionOf>
bool sameInAll(std::size_t poses, const BufferVertex& a, const BufferVertex& b, MotionOf motion)
{
    for (std::size_t pose = 0; pose < poses; ++pose)
        if (!nearlySame(motion(a, pose), motion(b, pose)))
            return false;
    return true;
}

bool sameMotion(const BufferVertex& a, const BufferVertex& b)
{
    const BoneInfluences none;
    if (!sameBones(a.buffer->bones ? a.buffer->bones[a.index] : none,
                   b.buffer->bones ? b.buffer->bones[b.index] : none))
        return false;
    if (!sameInAll(std::max(a.buffer->offsets.size(), b.buffer->offsets.size()), a, b, offsetOf))
        return false;
    const bool bonesTell = a.buffer->bones && b.buffer->bones; // with a tolerance of their own
    return bonesTell || sameInAll(std::max(a.buffer->poses.size(), b.buffer->poses.size()), a, b, motionOf);
}

bool sameAttributes(const VertexBufferView& buffer, std::uint32_t a, std::uint32_t b)
{
    return sameTuple(buffer.normals, a, b, 3) && sameTuple(buffer.colours, a, b, 4)
           && std::all_of(buffer.uvSets.begin(), buffer.uvSets.end(),
                          [&](const UvStream& uv) { return sameTuple(uv.stream, a, b, uv.components); });
}

class Welder {
public:
    explicit Welder(const MeshView& view) : mView(view) {}

    Result<CollapseMesh> run()
    {
        if (auto error = prepare())
            return *error;
        for (std::size_t s = 0; s < mView.subMeshes.size(); ++s)
            if (auto error = addSubMesh(static_cast<int>(s)))
                return *error;
        mMesh.firstFaceOfSubMesh.push_back(static_cast<std::uint32_t>(mMesh.faces.size()));
        finish();
        return std::move(mMesh);
    }

private:
    std::optional<Error> prepare()
    {
        std::size_t vertices = 0, triangles = 0;
        for (const VertexBufferView& buffer : mView.vertexBuffers) {
            vertices += buffer.vertexCount;
            mMoves |= buffer.bones != nullptr || !buffer.offsets.empty() || !buffer.poses.empty();
        }
        for (const SubMeshView& subMesh : mView.subMeshes)
            triangles += subMesh.indexCount / 3;
        if (vertices >= kExtra || triangles >= kNone / 3)
            return Error{ErrorCode::Unsupported, "more than 2^31 vertices or 2^32 indices"};
        mMesh.summary.bufferVertices = static_cast<std::uint32_t>(vertices);
        mMesh.summary.triangles = static_cast<std::uint32_t>(triangles);
        mMesh.faces.reserve(triangles);
        mMesh.vertices.reserve(vertices);
        mMesh.nextWedge.reserve(vertices);
        mMesh.wedgeSource.reserve(vertices);
        mManySubMeshes = mView.subMeshes.size() > 1;
        mWedgeOf.resize(mView.vertexBuffers.size());
        for (std::size_t b = 0; b < mView.vertexBuffers.size(); ++b)
            mWedgeOf[b].assign(mView.vertexBuffers[b].vertexCount, kNone);
        mSlots.assign(slotsFor(vertices), kNone);
        mFaceSlots.assign(slotsFor(triangles), {0, kNone});
        return std::nullopt;
    }

    std::optional<Error> addSubMesh(int number)
    {
        const SubMeshView& subMesh = mView.subMeshes[static_cast<std::size_t>(number)];
        mMesh.firstFaceOfSubMesh.push_back(static_cast<std::uint32_t>(mMesh.faces.size()));
        mFirstNew = mMesh.vertexCount();
        mFirstNewExtra = kExtra | static_cast<std::uint32_t>(mExtra.size());
        return subMesh.indexBytes == 2 ? addFaces(number, static_cast<const std::uint16_t*>(subMesh.indices))
                                       : addFaces(number, static_cast<const std::uint32_t*>(subMesh.indices));
    }

    /// In blocks, so that what a block will look up in the hash tables is asked for at once.
    template <class Index>
    std::optional<Error> addFaces(int number, const Index* indices)
    {
        const SubMeshView& subMesh = mView.subMeshes[static_cast<std::size_t>(number)];
        for (std::uint32_t first = 0; subMesh.indexCount - first > 2;
             first += std::min(subMesh.indexCount - first, 3 * kBlock)) {
            const std::uint32_t end = first + std::min(subMesh.indexCount - first, 3 * kBlock);
            for (std::uint32_t at = first; at < end; ++at)
                prefetchWedge(subMesh.vertexBuffer, indices[at]);
            if (auto error = addWedges(number, indices, first, end))
                return error;
            addFaces(mWedgeOf[subMesh.vertexBuffer].data(), indices + first, end - first);
        }
        return std::nullopt;
    }

    template <class Index>
    std::optional<Error> addWedges(int number, const Index* indices, std::uint32_t first, std::uint32_t end)
    {
        const std::uint32_t buffer = mView.subMeshes[static_cast<std::size_t>(number)].vertexBuffer;
        const std::uint32_t* wedgeOf = mWedgeOf[buffer].data();
        for (std::uint32_t at = first; at < end; ++at)
            if (indices[at] >= mView.vertexBuffers[buffer].vertexCount || !isOfThisSubMesh(wedgeOf[indices[at]]))
                if (auto error = addWedge(number, at, indices[at]))
                    return error;
        return std::nullopt;
    }

    template <class Index>
    void addFaces(const std::uint32_t* wedgeOf, const Index* indices, std::uint32_t count)
    {
        Triple wedges[kBlock];
        for (std::uint32_t i = 0; i < count / 3; ++i) {
            wedges[i] = {wedgeOf[indices[3 * i]], wedgeOf[indices[3 * i + 1]], wedgeOf[indices[3 * i + 2]]};
            prefetch(&mFaceSlots[hashOf(provisionalVerticesOf(wedges[i].data())) & (mFaceSlots.size() - 1)]);
        }
        for (std::uint32_t i = 0; i < count / 3; ++i)
            addFace(wedges[i]);
    }

    void prefetchWedge(std::uint32_t bufferNumber, std::uint32_t index) const
    {
        const VertexBufferView& buffer = mView.vertexBuffers[bufferNumber];
        if (index < buffer.vertexCount && mWedgeOf[bufferNumber][index] == kNone)
            prefetch(&mSlots[hashOf(readPosition(buffer, index)) & (mSlots.size() - 1)]);
    }

    /// Each submesh has its own wedges, which are added while it is read.
    bool isOfThisSubMesh(std::uint32_t wedge) const
    {
        return wedge != kNone && wedge >= (wedge & kExtra ? mFirstNewExtra : mFirstNew);
    }

    void addFace(const Triple& wedges)
    {
        const Triple v = provisionalVerticesOf(wedges.data());
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
            ++mMesh.summary.cleaned.degenerateTriangles;
        else if (isRepeated(v))
            ++mMesh.summary.cleaned.repeatedTriangles;
        else
            std::copy(wedges.begin(), wedges.end(), mMesh.faces.emplace_back().wedge);
    }

    /// Whether this submesh has a face with these vertices and this winding already. If not, the face to be added next is
    /// taken to be it.
    bool isRepeated(const Triple& vertices)
    {
        const std::size_t mask = mFaceSlots.size() - 1;
        const std::uint32_t hash = hashOf(vertices);
        std::size_t slot = hash & mask;
        for (; mFaceSlots[slot].face != kNone; slot = (slot + 1) & mask)
            if (mFaceSlots[slot].hash == hash && mFaceSlots[slot].face >= mMesh.firstFaceOfSubMesh.back()
                && sameFace(provisionalVerticesOf(mMesh.faces[mFaceSlots[slot].face].wedge), vertices))
                return true;
        mFaceSlots[slot] = {hash, static_cast<std::uint32_t>(mMesh.faces.size())};
        return false;
    }

    /// Wedge of a buffer vertex that this submesh has not met before.
    std::optional<Error> addWedge(int subMeshNumber, std::uint32_t at, std::uint32_t index)
    {
        const std::uint32_t bufferNumber = mView.subMeshes[static_cast<std::size_t>(subMeshNumber)].vertexBuffer;
        const VertexBufferView& buffer = mView.vertexBuffers[bufferNumber];
        if (index >= buffer.vertexCount)
            return Error{ErrorCode::IndexOutOfRange,
                         "index " + std::to_string(index) + " in a buffer of " + std::to_string(buffer.vertexCount)
                             + " vertices",
                         {},
                         -1,
                         subMeshNumber,
                         at};
        const auto number = static_cast<std::uint32_t>(subMeshNumber);
        std::uint32_t& known = mWedgeOf[bufferNumber][index];
        if (known != kNone)
            known = addToVertex(provisionalVertexOf(known), number, index); // shared with an earlier submesh
        else if (const char* trouble = troubleWith(buffer, index))
            return Error{ErrorCode::InvalidGeometry, trouble, {}, -1, subMeshNumber, index};
        else
            known = addBufferVertex(number, index, readPosition(buffer, index));
        return std::nullopt;
    }

    static const char* troubleWith(const VertexBufferView& buffer, std::uint32_t index)
    {
        for (float coordinate : readPosition(buffer, index))
            if (!(std::abs(coordinate) <= kLargest))
                return "a position is not finite, or beyond +-1e18";
        if (!finiteTuple(buffer.normals, index, 3))
            return "a normal is not finite";
        if (!finiteTuple(buffer.colours, index, 4))
            return "a colour is not finite";
        for (const UvStream& uv : buffer.uvSets)
            if (!finiteTuple(uv.stream, index, uv.components))
                return "a texture coordinate is not finite";
        for (const FloatStream& offset : buffer.offsets)
            if (!finiteTuple(offset, index, 3))
                return "a pose offset is not finite";
        if (buffer.bones)
            for (float weight : buffer.bones[index].weight)
                if (!std::isfinite(weight))
                    return "a bone weight is not finite";
        if (buffer.importance) {
            float importance;
            buffer.importance.read(index, 1, &importance);
            if (!(importance >= 0.0f && importance <= 1.0f))
                return "an importance is outside 0..1";
        }
        return nullptr;
    }

    /// Wedge of a buffer vertex that is met for the first time.
    std::uint32_t addBufferVertex(std::uint32_t subMesh, std::uint32_t index, const Position& position)
    {
        std::size_t slot = hashOf(position) & (mSlots.size() - 1);
        while (mSlots[slot] != kNone
               && std::memcmp(mMesh.vertices[mSlots[slot]].position, position.data(), sizeof position) != 0)
            slot = (slot + 1) & (mSlots.size() - 1);
        if (mSlots[slot] != kNone)
            return addToVertex(mSlots[slot], subMesh, index);
        const std::uint32_t vertex = mMesh.vertexCount();
        mSlots[slot] = vertex;
        CollapseMesh::Vertex record{};
        std::copy(position.begin(), position.end(), record.position);
        mMesh.vertices.push_back(record);
        addRecord({subMesh, index, kNone, vertex});
        noteImportance(vertex, subMesh, index);
        return vertex;
    }

    std::uint32_t addToVertex(std::uint32_t vertex, std::uint32_t subMesh, std::uint32_t index)
    {
        noteImportance(vertex, subMesh, index);
        const BufferVertex added{&bufferOf(subMesh), index};
        std::uint32_t motion = kNone, last = vertex;
        for (std::uint32_t wedge = vertex; wedge != kNone; wedge = recordOf(wedge).next) {
            const WedgeRecord other = recordOf(wedge);
            const bool together = !mMoves || sameMotion({&bufferOf(other.subMesh), other.index}, added);
            if (together && other.subMesh == subMesh && sameAttributes(*added.buffer, other.index, index))
                return wedge;
            if (together && motion == kNone)
                motion = other.motion;
            last = wedge;
        }
        const std::uint32_t wedge = kExtra | static_cast<std::uint32_t>(mExtra.size());
        (last & kExtra ? mExtra[last & ~kExtra].next : mMesh.nextWedge[last]) = wedge;
        mMesh.vertices[vertex].hasSeam = true;
        mSplitMotion |= motion == kNone;
        mExtra.push_back({subMesh, index, kNone, motion == kNone ? wedge : motion});
        mMesh.extraWedgeVertex.push_back(vertex);
        return wedge;
    }

    const VertexBufferView& bufferOf(std::uint32_t subMesh) const
    {
        return mView.vertexBuffers[mView.subMeshes[subMesh].vertexBuffer];
    }

    void noteImportance(std::uint32_t vertex, std::uint32_t subMesh, std::uint32_t index)
    {
        const FloatStream& stream = bufferOf(subMesh).importance;
        if (!stream)
            return;
        float importance;
        stream.read(index, 1, &importance);
        mMesh.importance.resize(mMesh.vertices.size());
        mMesh.importance[vertex] = std::max(mMesh.importance[vertex], importance);
    }

    struct FaceSlot {
        std::uint32_t hash; ///< which spares looking at most faces that are others
        std::uint32_t face; ///< kNone when the slot is free
    };

    struct WedgeRecord {
        std::uint32_t subMesh, index, next, motion;
    };

    /// Appends a wedge under its final number, which is known at once for the first wedge of a vertex.
    void addRecord(const WedgeRecord& wedge)
    {
        mMesh.nextWedge.push_back(wedge.next);
        mMesh.wedgeSource.push_back(wedge.index);
        if (mManySubMeshes)
            mMesh.wedgeSubMesh.push_back(wedge.subMesh);
    }

    WedgeRecord recordOf(std::uint32_t wedge) const
    {
        if (wedge & kExtra)
            return mExtra[wedge & ~kExtra];
        return {mMesh.subMeshOfWedge(wedge), mMesh.wedgeSource[wedge], mMesh.nextWedge[wedge], wedge};
    }

    Triple provisionalVerticesOf(const std::uint32_t* wedge) const
    {
        return {provisionalVertexOf(wedge[0]), provisionalVertexOf(wedge[1]), provisionalVertexOf(wedge[2])};
    }
    std::uint32_t provisionalVertexOf(std::uint32_t wedge) const
    {
        return wedge & kExtra ? mMesh.extraWedgeVertex[wedge & ~kExtra] : wedge;
    }

    void finish()
    {
        mSlots = {};
        mFaceSlots = {};
        if (!mExtra.empty())
            numberExtraWedges();
        if (!mMesh.importance.empty())
            mMesh.importance.resize(mMesh.vertices.size());
        countUnreferenced();
        mMesh.summary.vertices = mMesh.vertexCount();
        scalePositions();
    }

    void numberExtraWedges()
    {
        const std::uint32_t first = mMesh.vertexCount();
        const auto number = [first](std::uint32_t wedge) {
            return wedge == kNone || !(wedge & kExtra) ? wedge : first + (wedge & ~kExtra);
        };
        for (CollapseMesh::Face& face : mMesh.faces)
            for (std::uint32_t& wedge : face.wedge)
                wedge = number(wedge);
        for (std::uint32_t& next : mMesh.nextWedge)
            next = number(next);
        if (mSplitMotion) {
            mMesh.wedgeMotion.resize(first);
            std::iota(mMesh.wedgeMotion.begin(), mMesh.wedgeMotion.end(), 0u);
        }
        for (WedgeRecord wedge : mExtra) {
            wedge.next = number(wedge.next);
            addRecord(wedge);
            if (mSplitMotion)
                mMesh.wedgeMotion.push_back(number(wedge.motion));
        }
        mExtra = {};
    }

    void countUnreferenced()
    {
        for (const auto& wedges : mWedgeOf)
            mMesh.summary.cleaned.unreferencedVertices +=
                static_cast<std::uint32_t>(std::count(wedges.begin(), wedges.end(), kNone));
    }

    void scalePositions()
    {
        Position low, high;
        low.fill(std::numeric_limits<float>::max());
        high.fill(std::numeric_limits<float>::lowest());
        for (const CollapseMesh::Vertex& vertex : mMesh.vertices)
            for (std::size_t i = 0; i < 3; ++i) {
                low[i] = std::min(low[i], vertex.position[i]);
                high[i] = std::max(high[i], vertex.position[i]);
            }
        const auto middle = [&](std::size_t i) { return 0.5 * (double{low[i]} + double{high[i]}); };
        const Vec3 centre{middle(0), middle(1), middle(2)};
        double radiusSquared = 0.0;
        for (std::uint32_t v = 0; v < mMesh.vertexCount(); ++v)
            radiusSquared = std::max(radiusSquared, lengthSquared(mMesh.position(v) - centre));
        mMesh.summary.radius = std::sqrt(radiusSquared);
        int exponent = 0;
        std::frexp(mMesh.summary.radius, &exponent);
        mMesh.scale = std::ldexp(1.0, -exponent);
        for (CollapseMesh::Vertex& vertex : mMesh.vertices)
            for (float& coordinate : vertex.position)
                coordinate = static_cast<float>(coordinate * mMesh.scale);
    }

    const MeshView& mView;
    CollapseMesh mMesh;
    std::vector<std::vector<std::uint32_t>> mWedgeOf; ///< of each buffer's vertices, kNone when not referenced
    std::vector<std::uint32_t> mSlots;                ///< hash table of positions: vertex numbers
    std::vector<FaceSlot> mFaceSlots;                 ///< hash table of faces
    std::vector<WedgeRecord> mExtra;                  ///< wedges besides the first of a vertex
    std::uint32_t mFirstNew = 0, mFirstNewExtra = 0;  ///< first numbers of this submesh's wedges, of either kind
    bool mManySubMeshes = false;
    bool mMoves = false; ///< some vertex has bones or pose offsets
    bool mSplitMotion = false;
};

} // namespace

Result<CollapseMesh> weld(const MeshView& mesh)
{
    return Welder(mesh).run();
}

} // namespace lodsmith
