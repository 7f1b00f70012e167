#include "MeshChunks.h"

#include "FileCursor.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <set>
#include <utility>

namespace lodsmith {

namespace {

// The numbers of OGRE's mesh format, as its header file OgreMeshFileFormat.h documents them.
enum Chunk : std::uint32_t {
    kMesh = 0x3000,
    kSubMesh = 0x4000,
    kSubMeshOperation = 0x4010,
    kSubMeshBoneAssignment = 0x4100,
    kSubMeshTextureAlias = 0x4200,
    kGeometry = 0x5000,
    kVertexDeclaration = 0x5100,
    kVertexElement = 0x5110,
    kVertexBuffer = 0x5200,
    kVertexBufferData = 0x5210,
    kOldNormals = 0x5100, // the formats before 1.30
    kOldColours = 0x5200,
    kOldTexCoords = 0x5300,
    kSkeletonLink = 0x6000,
    kBoneAssignment = 0x7000,
    kLevels = 0x8000,
    kLevelUsage = 0x8100,
    kManualLevel = 0x8110,
    kGeneratedLevel = 0x8120,
    kBounds = 0x9000,
    kSubMeshNames = 0xA000,
    kEdgeLists = 0xB000,
    kPoses = 0xC000,
    kAnimations = 0xD000,
    kExtremes = 0xE000,
};

constexpr unsigned kFloatBytes = 4;
constexpr unsigned kBoneAssignmentBytes = 10;
constexpr unsigned kVertexElementBytes = 10;
constexpr unsigned kBoundsBytes = 7 * kFloatBytes;
constexpr std::uint32_t kOwnBuffer = 0xffffffff;

/// What a level draws of an index buffer.
struct BufferUse {
    unsigned level = 0;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

/// An index buffer in the list of levels, where the levels' shares may lie in each other's entries.
struct LevelBuffer {
    std::size_t begin = 0; ///< in the file
    std::uint64_t count = 0;
    unsigned width = 2;
    unsigned level = 0; ///< in whose entry it is stored
    std::vector<BufferUse> uses;
};

bool isOneOf(const std::string& version, std::initializer_list<const char*> versions)
{
    return std::find(versions.begin(), versions.end(), version) != versions.end();
}

/// Parts of a buffer of which each has one owner: the nearest level that draws it, or else the one that stores it.
std::vector<FileSpan> ownedParts(const LevelBuffer& buffer)
{
    struct Edge {
        std::uint64_t index;
        bool begins;
        unsigned level;
    };
    std::vector<Edge> edges{{buffer.count, false, buffer.level}};
    for (const BufferUse& use : buffer.uses) {
        const std::uint64_t end = std::min(use.first + use.count, buffer.count);
        if (use.first >= end)
            continue;
        edges.push_back({use.first, true, use.level});
        edges.push_back({end, false, use.level});
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.index < b.index; });

    std::vector<FileSpan> parts;
    std::multiset<unsigned> drawing;
    std::uint64_t done = 0;
    for (const Edge& edge : edges) {
        const unsigned owner = drawing.empty() ? buffer.level : *drawing.begin();
        if (edge.index > done)
            parts.push_back({buffer.begin + done * buffer.width, buffer.begin + edge.index * buffer.width, owner});
        done = edge.index;
        if (edge.begins)
            drawing.insert(edge.level);
        else if (const auto ended = drawing.find(edge.level); ended != drawing.end())
            drawing.erase(ended);
    }
    return parts;
}

/// Reads one file.
class ChunkWalk {
public:
    ChunkWalk(std::string_view bytes, const MeshHeader& header)
        : mFileBytes(bytes.size()), mCursor(bytes, header.bigEndian),
          mOldGeometry(isOneOf(header.version, {"1.10", "1.20"})),
          mNamesStrategy(!isOneOf(header.version, {"1.10", "1.20", "1.30", "1.40"})),
          mMixesLevels(header.version == "1.100")
    {
    }

    Result<MeshChunks> run()
    {
        mCursor.skip(2);
        mCursor.text();
        mCursor.enter(kMesh);
        mCursor.skip(1);
        while (mCursor.ok() && readPart()) {
        }
        if (!mCursor.ok())
            return mCursor.error();
        collectSpans();
        return std::move(mResult);
    }

private:
    /// The next part of the mesh; false when there is none.
    bool readPart()
    {
        switch (mCursor.chunkAhead()) {
        case kGeometry: readGeometry(); return true;
        case kSubMesh: readSubMesh(); return true;
        case kSkeletonLink:
            mCursor.enter(kSkeletonLink);
            mResult.skeleton = mCursor.text();
            return true;
        case kBoneAssignment: readFixed(kBoneAssignment, kBoneAssignmentBytes); return true;
        case kLevels: readLevels(); return true;
        case kBounds: readFixed(kBounds, kBoundsBytes); return true;
        case kSubMeshNames:
        case kEdgeLists:
        case kPoses:
        case kAnimations:
        case kExtremes: return hop();
        default: return false;
        }
    }

    void readFixed(std::uint32_t chunk, unsigned bytes)
    {
        mCursor.enter(chunk);
        mCursor.skip(bytes);
    }

    /// Passes over a part of level 0 by its length. One that leads nowhere ends the walk: what is behind is level 0's
    /// all the same.
    bool hop()
    {
        const std::uint32_t length = mCursor.lengthAhead();
        if (length < FileCursor::kChunkHeaderBytes || length > mCursor.left())
            return false;
        mCursor.skip(length);
        return true;
    }

    void readBuffer(std::uint64_t bytes)
    {
        const std::size_t begin = mCursor.place();
        mCursor.skip(bytes);
        if (mCursor.ok() && bytes > 0)
            mResult.buffers.push_back({begin, mCursor.place(), 0});
    }

    void readGeometry()
    {
        mCursor.enter(kGeometry);
        const std::uint64_t vertices = mCursor.integer(4);
        if (mOldGeometry)
            return readOldGeometry(vertices);
        for (;;) {
            if (mCursor.chunkAhead() == kVertexDeclaration) {
                mCursor.enter(kVertexDeclaration);
                while (mCursor.chunkAhead() == kVertexElement)
                    readFixed(kVertexElement, kVertexElementBytes);
            } else if (mCursor.chunkAhead() == kVertexBuffer) {
                mCursor.enter(kVertexBuffer);
                mCursor.skip(2);
                const std::uint64_t vertexBytes = mCursor.integer(2);
                mCursor.enter(kVertexBufferData);
                readBuffer(vertices * vertexBytes);
            } else {
                return;
            }
        }
    }

    void readOldGeometry(std::uint64_t vertices)
    {
        readBuffer(vertices * 3 * kFloatBytes);
        for (;;) {
            switch (const std::uint32_t chunk = mCursor.chunkAhead()) {
            case kOldNormals:
                mCursor.enter(chunk);
                readBuffer(vertices * 3 * kFloatBytes);
                break;
            case kOldColours:
                mCursor.enter(chunk);
                readBuffer(vertices * 4);
                break;
            case kOldTexCoords:
                mCursor.enter(chunk);
                readBuffer(vertices * mCursor.integer(2) * kFloatBytes);
                break;
            default: return;
            }
        }
    }

    void readSubMesh()
    {
        mCursor.enter(kSubMesh);
        mCursor.text();
        const bool sharesVertices = mCursor.integer(1) != 0;
        const std::uint64_t indices = mCursor.integer(4);
        readBuffer(indices * (mCursor.integer(1) != 0 ? 4 : 2));
        if (!sharesVertices)
            readGeometry();
        ++mSubMeshes;
        for (;;) {
            switch (mCursor.chunkAhead()) {
            case kSubMeshOperation: readFixed(kSubMeshOperation, 2); break;
            case kSubMeshBoneAssignment: readFixed(kSubMeshBoneAssignment, kBoneAssignmentBytes); break;
            case kSubMeshTextureAlias:
                mCursor.enter(kSubMeshTextureAlias);
                mCursor.text();
                mCursor.text();
                break;
            default: return;
            }
        }
    }

    void readLevels()
    {
        if (mHasLevels)
            return mCursor.fail("a second list of levels");
        mHasLevels = true;
        mCursor.enter(kLevels);
        if (mNamesStrategy)
            mCursor.text();
        const unsigned count = std::max(mCursor.integer(2), 1u);
        const bool allManual = !mMixesLevels && mCursor.integer(1) != 0;
        for (unsigned level = 1; level < count && mCursor.ok(); ++level) {
            const std::size_t begin = mCursor.place();
            mResult.manual.emplace_back();
            mBufferOf.emplace_back();
            if (mMixesLevels)
                readMixedLevel(level);
            else
                readOldLevel(level, allManual);
            mEntries.push_back({begin, mCursor.place(), level});
        }
    }

    void readMixedLevel(unsigned level)
    {
        const bool isManual = mCursor.chunkAhead() == kManualLevel;
        readFixed(isManual ? kManualLevel : kGeneratedLevel, kFloatBytes);
        if (isManual)
            return readManualName();
        for (std::size_t i = 0; i < mSubMeshes && mCursor.ok(); ++i) {
            const std::uint64_t count = mCursor.integer(4);
            const std::uint64_t first = mCursor.integer(4);
            const std::uint32_t other = mCursor.integer(4);
            if (other == kOwnBuffer) {
                const bool isWide = mCursor.integer(1) != 0;
                readLevelBuffer(level, mCursor.integer(4), isWide);
            } else if (other >= 1 && other < level && i < mBufferOf[other].size()) {
                mBufferOf[level].push_back(mBufferOf[other][i]);
            } else {
                return mCursor.fail("a level has the indices of another level that has none");
            }
            if (mCursor.ok())
                mBuffers[mBufferOf[level].back()].uses.push_back({level, first, count});
        }
    }

    void readOldLevel(unsigned level, bool isManual)
    {
        readFixed(kLevelUsage, kFloatBytes);
        if (isManual) {
            mCursor.enter(kManualLevel);
            return readManualName();
        }
        for (std::size_t i = 0; i < mSubMeshes && mCursor.ok(); ++i) {
            mCursor.enter(kGeneratedLevel);
            const std::uint32_t count = mCursor.integer(4);
            readLevelBuffer(level, count, mCursor.integer(1) != 0);
        }
    }

    void readManualName()
    {
        mResult.manual.back() = mCursor.text();
        if (mCursor.ok() && mResult.manual.back().empty())
            mCursor.fail("a hand-made level has no name");
    }

    void readLevelBuffer(unsigned level, std::uint64_t count, bool isWide)
    {
        const unsigned width = isWide ? 4 : 2;
        mBufferOf[level].push_back(mBuffers.size());
        mBuffers.push_back({mCursor.place(), count, width, level, {}});
        mCursor.skip(count * width);
    }

    void addSpan(FileSpan span)
    {
        std::vector<FileSpan>& spans = mResult.spans;
        if (span.begin == span.end)
            return;
        if (!spans.empty() && spans.back().level == span.level)
            spans.back().end = span.end;
        else
            spans.push_back(span);
    }

    /// Entries and buffers are in the order of the file.
    void collectSpans()
    {
        std::size_t done = 0, next = 0;
        for (const FileSpan& entry : mEntries) {
            addSpan({done, entry.begin, 0});
            done = entry.begin;
            for (; next < mBuffers.size() && mBuffers[next].level == entry.level; ++next)
                for (const FileSpan& part : ownedParts(mBuffers[next])) {
                    addSpan({done, part.begin, entry.level});
                    addSpan(part);
                    mResult.buffers.push_back(part);
                    done = part.end;
                }
            addSpan({done, entry.end, entry.level});
            done = entry.end;
        }
        addSpan({done, mFileBytes, 0});
        std::stable_sort(mResult.buffers.begin(), mResult.buffers.end(),
                         [](const FileSpan& a, const FileSpan& b) { return a.level < b.level; });
    }

    std::size_t mFileBytes;
    FileCursor mCursor;
    bool mOldGeometry, mNamesStrategy;
    bool mMixesLevels; ///< each level is generated or hand-made for itself, and buffers may be shared
    std::size_t mSubMeshes = 0;
    bool mHasLevels = false;
    std::vector<FileSpan> mEntries;
    std::vector<LevelBuffer> mBuffers;
    std::vector<std::vector<std::size_t>> mBufferOf{{}}; ///< by level and submesh; none for hand-made levels
    MeshChunks mResult{{}, {}, {""}, ""};
};

} // namespace

Result<MeshChunks> readMeshChunks(std::string_view bytes, const MeshHeader& header)
{
    return ChunkWalk(bytes, header).run();
}

} // namespace lodsmith
