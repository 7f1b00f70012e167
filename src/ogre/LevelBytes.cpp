#include <lodsmith/ogre/LevelBytes.h>

#include "../files/AtomicFile.h"
#include "../files/InsidePath.h"
#include "MeshChunks.h"
#include "MeshHeader.h"

#include <algorithm>
#include <deque>
#include <map>
#include <new>
#include <set>
#include <string_view>
#include <system_error>

#define ZLIB_CONST
#include <zlib.h>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

Error withFile(Error error, const fs::path& file)
{
    if (error.file.empty())
        error.file = file.string();
    return error;
}

/// Counts what compression leaves, and keeps none of it.
class ZlibCounter {
public:
    ZlibCounter()
    {
        if (deflateInit(&mStream, kZlibLevel) != Z_OK)
            throw std::bad_alloc();
    }
    ~ZlibCounter() { deflateEnd(&mStream); }
    ZlibCounter(const ZlibCounter&) = delete;
    ZlibCounter& operator=(const ZlibCounter&) = delete;

    /// Pieces are shorter than 4 GiB, as files are.
    void add(std::string_view piece)
    {
        mStream.next_in = reinterpret_cast<const Bytef*>(piece.data());
        mStream.avail_in = static_cast<uInt>(piece.size());
        run(Z_NO_FLUSH);
    }

    std::uint64_t finish()
    {
        run(Z_FINISH);
        return mBytes;
    }

private:
    void run(int flush)
    {
        Bytef block[1 << 14];
        do {
            mStream.next_out = block;
            mStream.avail_out = sizeof block;
            deflate(&mStream, flush);
            mBytes += sizeof block - mStream.avail_out;
        } while (mStream.avail_out == 0);
    }

    z_stream mStream = {};
    std::uint64_t mBytes = 0;
};

/// Collects the files of one mesh.
class ByteCount {
public:
    explicit ByteCount(const fs::path& mesh) : mDirectory(mesh.has_parent_path() ? mesh.parent_path() : ".") {}

    Result<MeshBytes> run(const fs::path& mesh)
    {
        const Result<MeshChunks> chunks = addMesh(mesh);
        if (!chunks)
            return chunks.error();
        mResult.levels.resize(chunks.value().manual.size());
        mPieces.resize(mResult.levels.size());
        mBuffers.resize(mResult.levels.size());
        take(chunks.value(), [](unsigned level) { return level; });
        addSkeleton(chunks.value().skeleton, 0);
        for (unsigned level = 1; level < mResult.levels.size(); ++level) {
            mResult.levels[level].manual = chunks.value().manual[level];
            if (const Result<Done> added = addManualLevel(level); !added)
                return added.error();
        }
        count();
        return std::move(mResult);
    }

private:
    /// Reads a file, unless it was read before: then null.
    Result<const std::string*> addFile(const fs::path& file, unsigned level)
    {
        std::error_code error;
        const fs::path canonical = fs::canonical(file, error);
        if (!error && mKnown.count(canonical) > 0)
            return static_cast<const std::string*>(nullptr);
        Result<std::string> bytes = readFile(file);
        if (!bytes)
            return withFile(bytes.error(), file);
        mKnown.insert(canonical);
        mContents.push_back(std::move(bytes).value());
        mResult.files.push_back({file, mContents.back().size(), level});
        return static_cast<const std::string*>(&mContents.back());
    }

    Result<MeshChunks> addMesh(const fs::path& file)
    {
        const Result<const std::string*> bytes = addFile(file, 0);
        if (!bytes)
            return bytes.error();
        return chunksOf(file, *bytes.value());
    }

    static Result<MeshChunks> chunksOf(const fs::path& file, const std::string& bytes)
    {
        const Result<MeshHeader> header = parseMeshHeader(bytes);
        if (!header)
            return withFile(header.error(), file);
        Result<MeshChunks> chunks = readMeshChunks(bytes, header.value());
        if (!chunks)
            return withFile(chunks.error(), file);
        return chunks;
    }

    /// Gives the parts of the file that was read last to the levels that `levelOf` says.
    template <typename LevelOf>
    void take(const MeshChunks& chunks, LevelOf levelOf)
    {
        const std::string_view bytes = mContents.back();
        for (const FileSpan& span : chunks.spans)
            mPieces[levelOf(span.level)].push_back(bytes.substr(span.begin, span.end - span.begin));
        for (const FileSpan& span : chunks.buffers)
            mBuffers[levelOf(span.level)].push_back(bytes.substr(span.begin, span.end - span.begin));
    }

    Result<Done> addManualLevel(unsigned level)
    {
        const std::string& name = mResult.levels[level].manual;
        if (name.empty())
            return Done{};
        const Result<fs::path> file = pathInside(mDirectory, name);
        if (!file)
            return withFile({ErrorCode::BadFile, "level " + std::to_string(level) + " is the mesh '" + name
                                                     + "', which does not lie below the mesh's directory"},
                            mResult.files.front().file);
        const Result<const std::string*> bytes = addFile(file.value(), level);
        if (!bytes)
            return bytes.error();
        if (!bytes.value()) {
            mResult.notes.push_back("level " + std::to_string(level) + ": the file of '" + name
                                    + "' counts with a level above");
            return Done{};
        }
        const Result<MeshChunks> chunks = chunksOf(file.value(), *bytes.value());
        if (!chunks)
            return chunks.error();
        take(chunks.value(), [level](unsigned) { return level; });
        addSkeleton(chunks.value().skeleton, level);
        return Done{};
    }

    void addSkeleton(const std::string& name, unsigned level)
    {
        if (name.empty())
            return;
        const Result<fs::path> file = pathInside(mDirectory, name);
        if (!file) {
            mResult.notes.push_back("skeleton '" + name + "' does not lie below the mesh's directory: not counted");
            return;
        }
        const Result<const std::string*> bytes = addFile(file.value(), level);
        if (!bytes)
            mResult.notes.push_back("skeleton '" + name + "' cannot be read: not counted");
        else if (bytes.value())
            mPieces[level].push_back(*bytes.value());
    }

    void count()
    {
        std::map<std::string_view, unsigned> nearest;
        for (unsigned level = 0; level < mResult.levels.size(); ++level) {
            LevelBytes& counted = mResult.levels[level];
            ZlibCounter zlib;
            for (const std::string_view piece : mPieces[level]) {
                counted.bytes += piece.size();
                zlib.add(piece);
            }
            counted.zlibBytes = zlib.finish();
            for (const std::string_view buffer : mBuffers[level])
                if (nearest.emplace(buffer, level).first->second < level)
                    counted.duplicateBytes += buffer.size();
        }
    }

    fs::path mDirectory;
    std::deque<std::string> mContents; // which the pieces show, so that none may move
    std::set<fs::path> mKnown;
    std::vector<std::vector<std::string_view>> mPieces;  ///< by level
    std::vector<std::vector<std::string_view>> mBuffers; ///< by level
    MeshBytes mResult;
};

} // namespace

Result<MeshBytes> levelBytes(const fs::path& mesh)
{
    try {
        return ByteCount(mesh).run(mesh);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "not enough memory to count its bytes", mesh.string()};
    }
}

} // namespace lodsmith
