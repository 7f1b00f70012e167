#include "Weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

namespace lodsmith {

namespace {

constexpr float kLargest = 1e18f;               // the square of a length stays inside a float
constexpr float kBoneTolerance = 1.0f / 256.0f; // what exporters round away
constexpr float kOffsetTolerance = 1e-5f;       // share of the offset; what exporters round away
constexpr std::uint32_t kExtra = 0x80000000u;   // marks a further wedge while the number of vertices is not known yet

using Position = std::array<float, 3>;

Position readPosition(const VertexBufferView& buffer, std::uint32_t index)
{
    Position p;
    buffer.positions.read(index, 3, p.data());
    for (float& coordinate : p)
        coordinate += 0.0f; // -0 and 0 are one position
    return p;
}

using Triple = std::array<std::uint32_t, 3>;

/// The same face beginning at its lowest vertex.
Triple rotated(const Triple& v)
{
    if (v[0] < v[1] && v[0] < v[2])
        return v;
    return v[1] < v[2] ? Triple{v[1], v[2], v[0]} : Triple{v[2], v[0], v[1]};
}

std::size_t hashOf(const Triple& bits)
{
    std::uint64_t h = bits[0] * 0x9E3779B97F4A7C15ull;
    h = (h ^ (h >> 29) ^ bits[1]) * 0xBF58476D1CE4E5B9ull;
    h = (h ^ (h >> 32) ^ bits[2]) * 0x94D049BB133111EBull;
    return static_cast<std::size_t>(h ^ (h >> 31));
}

std::size_t hashOf(const Position& p)
{
    Triple bits;
    std::memcpy(bits.data(), p.data(), sizeof bits);
    return hashOf(bits);
}

/// Size of a hash table, a power of two.
std::size_t slotsFor(std::size_t entries)
{
    std::size_t slots = 16;
    while (slots < entries + entries / 2)
        slots *= 2;
    return slots;
}

bool sameTuple(const FloatStream& stream, std::uint32_t a, std::uint32_t b, int count)
{
    if (!stream)
        return true;
    float va[4], vb[4];
    stream.read(a, count, va);
    stream.read(b, count, vb);
    return std::equal(va, va + count, vb);
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

bool sameMotion(const BufferVertex& a, const BufferVertex& b)
{
    const BoneInfluences none;
    if (!sameBones(a.buffer->bones ? a.buffer->bones[a.index] : none,
                   b.buffer->bones ? b.buffer->bones[b.index] : none))
        return false;
    const std::size_t poses = std::max(a.buffer->offsets.size(), b.buffer->offsets.size());
    for (std::size_t pose = 0; pose < poses; ++pose) {
        const Position pa = offsetOf(a, pose), pb = offsetOf(b, pose);
        for (int i = 0; i < 3; ++i)
            if (std::abs(pa[i] - pb[i]) > kOffsetTolerance * std::max(std::abs(pa[i]), std::abs(pb[i])))
                return false;
    }
    return true;
}

bool sameAttributes(const VertexBufferView& buffer, std::uint32_t a, std::uint32_t b)
{
    return sameTuple(buffer.normals, a, b, 3) && sameTuple(buffer.colours, a, b, 4)
           && std::all_of(buffer.uvSets.begin(), buffer.uvSets.end(),
                          [&](const UvStream& uv) { return sameTuple(uv.stream, a, b, uv.components); });
}

bool finiteTuple(const FloatStream& stream, std::uint32_t index, int count)
{
    if (!stream)
        return true;
    float v[4];
    stream.read(index, count, v);
    return std::all_of(v, v + count, [](float f) { return std::isfinite(f); });
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
            mMoves |= buffer.bones != nullptr || !buffer.offsets.empty();
        }
        for (const SubMeshView& subMesh : mView.subMeshes)
            triangles += subMesh.indexCount / 3;
        if (vertices >= kExtra || triangles >= kNone / 3)
            return Error{ErrorCode::Unsupported, "more than 2^31 vertices or 2^32 indices"};
        mMesh.summary.bufferVertices = static_cast<std::uint32_t>(vertices);
        mMesh.summary.triangles = static_cast<std::uint32_t>(triangles);
        mMesh.faces.reserve(triangles);
        mMesh.vertices.reserve(vertices);
        mWedgeOf.resize(mView.vertexBuffers.size());
        for (std::size_t b = 0; b < mView.vertexBuffers.size(); ++b)
            mWedgeOf[b].assign(mView.vertexBuffers[b].vertexCount, kNone);
        mSlots.assign(slotsFor(vertices), kNone);
        mFaceSlots.assign(slotsFor(triangles), kNone);
        return std::nullopt;
    }

    std::optional<Error> addSubMesh(int number)
    {
        const SubMeshView& subMesh = mView.subMeshes[static_cast<std::size_t>(number)];
        mMesh.firstFaceOfSubMesh.push_back(static_cast<std::uint32_t>(mMesh.faces.size()));
        for (std::uint32_t first = 0; first + 2 < subMesh.indexCount; first += 3) {
            CollapseMesh::Face face{};
            for (int corner = 0; corner < 3; ++corner)
                if (auto error = wedgeAt(number, first + static_cast<std::uint32_t>(corner), face.wedge[corner]))
                    return error;
            const std::uint32_t a = provisionalVertexOf(face.wedge[0]), b = provisionalVertexOf(face.wedge[1]),
                                c = provisionalVertexOf(face.wedge[2]);
            if (a == b || b == c || c == a)
                ++mMesh.summary.cleaned.degenerateTriangles;
            else if (isRepeated({a, b, c}))
                ++mMesh.summary.cleaned.repeatedTriangles;
            else
                mMesh.faces.push_back(face);
        }
        return std::nullopt;
    }

    /// Whether this submesh has a face with these vertices and this winding already. If not, the face to be added next is
    /// taken to be it.
    bool isRepeated(const Triple& vertices)
    {
        const Triple key = rotated(vertices);
        std::size_t slot = hashOf(key) & (mFaceSlots.size() - 1);
        for (; mFaceSlots[slot] != kNone; slot = (slot + 1) & (mFaceSlots.size() - 1)) {
            const std::uint32_t* wedge = mMesh.faces[mFaceSlots[slot]].wedge;
            if (mFaceSlots[slot] >= mMesh.firstFaceOfSubMesh.back()
                && rotated(
                       {provisionalVertexOf(wedge[0]), provisionalVertexOf(wedge[1]), provisionalVertexOf(wedge[2])})
                       == key)
                return true;
        }
        mFaceSlots[slot] = static_cast<std::uint32_t>(mMesh.faces.size());
        return false;
    }

    std::optional<Error> wedgeAt(int subMeshNumber, std::uint32_t at, std::uint32_t& wedge)
    {
        const SubMeshView& subMesh = mView.subMeshes[static_cast<std::size_t>(subMeshNumber)];
        const VertexBufferView& buffer = mView.vertexBuffers[subMesh.vertexBuffer];
        const std::uint32_t index = subMesh.index(at);
        if (index >= buffer.vertexCount)
            return Error{ErrorCode::IndexOutOfRange,
                         "index " + std::to_string(index) + " in a buffer of " + std::to_string(buffer.vertexCount)
                             + " vertices",
                         {},
                         -1,
                         subMeshNumber,
                         at};
        std::uint32_t& known = mWedgeOf[subMesh.vertexBuffer][index];
        const auto number = static_cast<std::uint32_t>(subMeshNumber);
        if (known == kNone) {
            if (const char* trouble = troubleWith(buffer, index))
                return Error{ErrorCode::InvalidGeometry, trouble, {}, -1, subMeshNumber, index};
            known = addBufferVertex(number, index);
        } else if (record(known).subMesh != number) {
            known = addToVertex(provisionalVertexOf(known), number, index); // shared with an earlier submesh
        }
        wedge = known;
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
    std::uint32_t addBufferVertex(std::uint32_t subMesh, std::uint32_t index)
    {
        const Position position = readPosition(bufferOf(subMesh), index);
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
        mFirst.push_back({subMesh, index, kNone, vertex});
        noteImportance(vertex, subMesh, index);
        return vertex;
    }

    std::uint32_t addToVertex(std::uint32_t vertex, std::uint32_t subMesh, std::uint32_t index)
    {
        noteImportance(vertex, subMesh, index);
        const BufferVertex added{&bufferOf(subMesh), index};
        std::uint32_t motion = kNone, last = vertex;
        for (std::uint32_t wedge = vertex; wedge != kNone; wedge = record(wedge).next) {
            const WedgeRecord& other = record(wedge);
            const bool together = !mMoves || sameMotion({&bufferOf(other.subMesh), other.index}, added);
            if (together && other.subMesh == subMesh && sameAttributes(*added.buffer, other.index, index))
                return wedge;
            if (together && motion == kNone)
                motion = other.motion;
            last = wedge;
        }
        const std::uint32_t wedge = kExtra | static_cast<std::uint32_t>(mExtra.size());
        record(last).next = wedge;
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

    struct WedgeRecord {
        std::uint32_t subMesh, index, next, motion;
    };

    WedgeRecord& record(std::uint32_t wedge) { return wedge & kExtra ? mExtra[wedge & ~kExtra] : mFirst[wedge]; }
    std::uint32_t provisionalVertexOf(std::uint32_t wedge) const
    {
        return wedge & kExtra ? mMesh.extraWedgeVertex[wedge & ~kExtra] : wedge;
    }

    void finish()
    {
        mSlots = mFaceSlots = {};
        const auto number = [this](std::uint32_t wedge) {
            return wedge == kNone || !(wedge & kExtra) ? wedge : mMesh.vertexCount() + (wedge & ~kExtra);
        };
        for (CollapseMesh::Face& face : mMesh.faces)
            for (std::uint32_t& wedge : face.wedge)
                wedge = number(wedge);
        fillWedges(number);
        if (!mMesh.importance.empty())
            mMesh.importance.resize(mMesh.vertices.size());
        countUnreferenced();
        mMesh.summary.vertices = mMesh.vertexCount();
        scalePositions();
    }

    template <class Number>
    void fillWedges(const Number& number)
    {
        const bool manySubMeshes = mView.subMeshes.size() > 1;
        for (const auto* records : {&mFirst, &mExtra})
            for (const WedgeRecord& wedge : *records) {
                mMesh.nextWedge.push_back(number(wedge.next));
                mMesh.wedgeSource.push_back(wedge.index);
                if (manySubMeshes)
                    mMesh.wedgeSubMesh.push_back(wedge.subMesh);
                if (mSplitMotion)
                    mMesh.wedgeMotion.push_back(number(wedge.motion));
            }
        mFirst = {};
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
        double low[3], high[3];
        std::fill(low, low + 3, std::numeric_limits<double>::max());
        std::fill(high, high + 3, std::numeric_limits<double>::lowest());
        for (const CollapseMesh::Vertex& vertex : mMesh.vertices)
            for (int i = 0; i < 3; ++i) {
                low[i] = std::min<double>(low[i], vertex.position[i]);
                high[i] = std::max<double>(high[i], vertex.position[i]);
            }
        const Vec3 centre{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2])};
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
    std::vector<std::uint32_t> mFaceSlots;            ///< hash table of faces
    std::vector<WedgeRecord> mFirst, mExtra;
    bool mMoves = false; ///< some vertex has bones or pose offsets
    bool mSplitMotion = false;
};

} // namespace

Result<CollapseMesh> weld(const MeshView& mesh)
{
    return Welder(mesh).run();
}

} // namespace lodsmith
