#include "EntryCodec.h"

#include "ByteReader.h"
#include "ByteWriter.h"
#include "CacheFormat.h"
#include "Xxhash.h"

namespace lodsmith {

namespace {

constexpr std::string_view kMagic = "lodchain";
constexpr std::size_t kChecksumBytes = sizeof(std::uint64_t);

// The least that a list and a level take.
constexpr std::size_t kListBytes = 4;
constexpr std::size_t kLevelBytes = 4 + 4 + 8 + 8 + 1 + 1 + 4;

constexpr auto kLastStopReason = static_cast<std::uint8_t>(StopReason::Topology);

/// Everything before the payload. An entry that was cut short no longer has the length that its head states.
std::string makeHead(const CacheKey& key, std::uint64_t entryBytes)
{
    std::string head(kMagic);
    ByteWriter writer(head);
    writer.fixed(kCacheFormat);
    writer.fixed(entryBytes);
    head.append(key.bytes.begin(), key.bytes.end());
    return head;
}

/// Differences of neighbours are small on both sides of 0: 0, -1, 1, -2 ... become 0, 1, 2, 3 ...
std::uint32_t folded(std::uint32_t difference)
{
    return (difference << 1) ^ (difference >> 31 ? 0xffffffffu : 0u);
}

std::uint32_t unfolded(std::uint32_t number)
{
    return (number >> 1) ^ (number & 1 ? 0xffffffffu : 0u);
}

void writeIndices(ByteWriter& writer, const std::vector<std::uint32_t>& indices)
{
    writer.fixed(static_cast<std::uint32_t>(indices.size()));
    std::uint32_t before = 0;
    for (const std::uint32_t index : indices) {
        writer.varint(folded(index - before));
        before = index;
    }
}

std::vector<std::uint32_t> readIndices(ByteReader& reader)
{
    std::vector<std::uint32_t> indices(reader.count(1));
    std::uint32_t before = 0;
    for (std::uint32_t& index : indices)
        index = before += unfolded(reader.varint());
    return indices;
}

void writeLevel(ByteWriter& writer, const LodChainLevel& level)
{
    writer.fixed(level.vertices);
    writer.fixed(level.triangles);
    writer.real(level.deviation);
    writer.real(level.cost);
    writer.fixed(static_cast<std::uint8_t>(level.stop));
    writer.fixed(static_cast<std::uint8_t>(level.skipped));
    writer.fixed(static_cast<std::uint32_t>(level.indices.size()));
    for (const auto& indices : level.indices)
        writeIndices(writer, indices);
}

LodChainLevel readLevel(ByteReader& reader)
{
    LodChainLevel level;
    level.vertices = reader.fixed<std::uint32_t>();
    level.triangles = reader.fixed<std::uint32_t>();
    level.deviation = reader.real();
    level.cost = reader.real();
    level.stop = static_cast<StopReason>(reader.choice(kLastStopReason));
    level.skipped = reader.choice(1) == 1;
    level.indices.resize(reader.count(kListBytes));
    for (auto& indices : level.indices)
        indices = readIndices(reader);
    return level;
}

std::size_t roomFor(const LodChain& chain)
{
    std::size_t bytes = 64;
    for (const LodChainLevel& level : chain.levels) {
        bytes += kLevelBytes + kListBytes * level.indices.size();
        for (const auto& indices : level.indices)
            bytes += 2 * indices.size();
    }
    return bytes;
}

} // namespace

std::string encodePayload(const LodChain& chain)
{
    std::string payload;
    payload.reserve(roomFor(chain));
    ByteWriter writer(payload);
    writer.fixed(chain.vertices);
    writer.fixed(chain.bufferVertices);
    writer.fixed(chain.triangles);
    writer.real(chain.radius);
    writer.fixed(chain.cleaned.degenerateTriangles);
    writer.fixed(chain.cleaned.repeatedTriangles);
    writer.fixed(chain.cleaned.unreferencedVertices);
    writer.fixed(static_cast<std::uint32_t>(chain.levels.size()));
    for (const LodChainLevel& level : chain.levels)
        writeLevel(writer, level);
    return payload;
}

std::optional<LodChain> decodePayload(std::string_view payload)
{
    ByteReader reader(payload);
    LodChain chain;
    chain.vertices = reader.fixed<std::uint32_t>();
    chain.bufferVertices = reader.fixed<std::uint32_t>();
    chain.triangles = reader.fixed<std::uint32_t>();
    chain.radius = reader.real();
    chain.cleaned.degenerateTriangles = reader.fixed<std::uint32_t>();
    chain.cleaned.repeatedTriangles = reader.fixed<std::uint32_t>();
    chain.cleaned.unreferencedVertices = reader.fixed<std::uint32_t>();
    const std::uint32_t levels = reader.count(kLevelBytes);
    chain.levels.reserve(levels);
    while (chain.levels.size() < levels && !reader.failed())
        chain.levels.push_back(readLevel(reader));
    if (!reader.finished())
        return std::nullopt;
    return chain;
}

std::uint64_t checksumOf(std::string_view bytes)
{
    return XXH3_64bits(bytes.data(), bytes.size());
}

std::string encodeEntry(const CacheKey& key, const LodChain& chain)
{
    const std::string payload = encodePayload(chain);
    const std::size_t headBytes = makeHead(key, 0).size();
    std::string entry = makeHead(key, headBytes + payload.size() + kChecksumBytes) + payload;
    const std::uint64_t checksum = checksumOf(entry);
    ByteWriter(entry).fixed(checksum);
    return entry;
}

std::optional<LodChain> decodeEntry(const CacheKey& key, std::string_view entry)
{
    const std::string head = makeHead(key, entry.size());
    if (entry.size() < head.size() + kChecksumBytes || entry.substr(0, head.size()) != head)
        return std::nullopt;
    const std::string_view body = entry.substr(0, entry.size() - kChecksumBytes);
    if (ByteReader(entry.substr(body.size())).fixed<std::uint64_t>() != checksumOf(body))
        return std::nullopt;
    return decodePayload(body.substr(head.size()));
}

} // namespace lodsmith
