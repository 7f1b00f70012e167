#include "MeshHeader.h"

#include <algorithm>
#include <cstdint>

namespace lodsmith {

namespace {

constexpr std::uint16_t kHeaderChunk = 0x1000;
constexpr std::uint16_t kMeshChunk = 0x3000;
constexpr std::size_t kChunkHeaderBytes = 6;
constexpr std::size_t kLongestVersion = 64;
constexpr std::string_view kVersionPrefix = "[MeshSerializer_v";
// OGRE's own writer miscounted in some versions: files that are whole claim up to some ten bytes a submesh too many.
constexpr std::uint64_t kMiscountedBytes = 4096;

constexpr std::string_view kVersions[] = {"1.10", "1.20", "1.30", "1.40", "1.41", "1.8", "1.100"};

Error bad(std::string message)
{
    return Error{ErrorCode::BadFile, std::move(message)};
}

std::uint64_t readInteger(std::string_view bytes, std::size_t offset, int count, bool bigEndian)
{
    std::uint64_t value = 0;
    for (int i = 0; i < count; ++i) {
        const std::size_t place = offset + static_cast<std::size_t>(bigEndian ? i : count - 1 - i);
        value = value << 8 | static_cast<unsigned char>(bytes[place]);
    }
    return value;
}

Result<Done> checkMeshChunk(std::string_view bytes, std::size_t offset, bool bigEndian)
{
    if (bytes.size() < offset + kChunkHeaderBytes)
        return bad("is cut off behind its header");
    if (readInteger(bytes, offset, 2, bigEndian) != kMeshChunk)
        return bad("is damaged: no mesh follows its header");
    const std::uint64_t end = offset + readInteger(bytes, offset + 2, 4, bigEndian);
    if (end > bytes.size() + kMiscountedBytes)
        return bad("is cut off or damaged: its mesh should end at byte " + std::to_string(end) + ", the file ends at "
                   + std::to_string(bytes.size()));
    return Done{};
}

} // namespace

Result<MeshHeader> parseMeshHeader(std::string_view bytes)
{
    if (bytes.empty())
        return bad("is empty");
    if (bytes.size() < 2)
        return bad("is no OGRE mesh: it has one byte");
    MeshHeader header;
    header.bigEndian = readInteger(bytes, 0, 2, true) == kHeaderChunk;
    if (!header.bigEndian && readInteger(bytes, 0, 2, false) != kHeaderChunk)
        return bad("is no OGRE mesh: it does not begin with a mesh header");

    const std::string_view line = bytes.substr(2, bytes.substr(2, kLongestVersion).find('\n'));
    if (line.substr(0, kVersionPrefix.size()) != kVersionPrefix || line.size() > kLongestVersion || line.back() != ']')
        return bad("is no OGRE mesh: its header names no mesh format");
    header.version = std::string(line.substr(kVersionPrefix.size(), line.size() - kVersionPrefix.size() - 1));
    if (std::find(std::begin(kVersions), std::end(kVersions), header.version) == std::end(kVersions))
        return bad("has the mesh format version '" + header.version + "', which OGRE 1.12 does not read");
    if (auto whole = checkMeshChunk(bytes, 2 + line.size() + 1, header.bigEndian); !whole)
        return whole.error();
    return header;
}

} // namespace lodsmith
