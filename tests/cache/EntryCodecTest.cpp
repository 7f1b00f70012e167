#include "EntryCodec.h"

#include "ByteWriter.h"
#include "CacheFormat.h"
#include "Chains.h"
#include "support/MeshBuilders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

using test::same;
using test::sampleChain;
using test::sampleKey;

constexpr std::size_t kHeadBytes = 36;

/// An entry without its checksum, given the right one.
std::string sealed(std::string body)
{
    const std::uint64_t checksum = checksumOf(body);
    ByteWriter(body).fixed(checksum);
    return body;
}

LodChain chainOf(std::vector<std::uint32_t> indices)
{
    LodChain chain;
    chain.levels.resize(1);
    chain.levels[0].indices.push_back(std::move(indices));
    return chain;
}

void expectRoundTrip(const LodChain& chain)
{
    const auto again = decodeEntry(sampleKey(1), encodeEntry(sampleKey(1), chain));
    ASSERT_TRUE(again);
    EXPECT_TRUE(same(*again, chain));
}

/// A payload up to the number of its levels.
std::string payloadStart()
{
    const std::string empty = encodePayload(LodChain());
    return empty.substr(0, empty.size() - 4);
}

} // namespace

TEST(EntryCodec, everyFieldComesBack)
{
    expectRoundTrip(sampleChain(1));
    expectRoundTrip(LodChain());
    for (const StopReason stop :
         {StopReason::TargetReached, StopReason::Locked, StopReason::Seam, StopReason::Topology}) {
        LodChain chain = sampleChain(2);
        chain.levels[0].stop = stop;
        expectRoundTrip(chain);
    }
}

TEST(EntryCodec, numbersAtTheirLimitsComeBack)
{
    constexpr std::uint32_t kMost = 0xffffffff;
    expectRoundTrip(chainOf({0, kMost, 0, kMost, kMost, 0x7fffffff, 0x80000000, 0, 0x80000000, 1}));
    for (const double number : {0.0, -0.0, std::numeric_limits<double>::infinity(), std::nan(""),
                                std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()}) {
        LodChain chain = sampleChain(1);
        chain.radius = chain.levels[0].deviation = chain.levels[0].cost = number;
        expectRoundTrip(chain);
    }
}

TEST(EntryCodec, isLittleEndianWithTheHeadThatIsDocumented)
{
    const std::string entry = encodeEntry(sampleKey(0x04030201), LodChain());
    ASSERT_EQ(entry.size(), kHeadBytes + 36 + 8);
    EXPECT_EQ(entry.substr(0, 8), "lodchain");
    EXPECT_EQ(entry.substr(8, 4), std::string("\2\0\0\0", 4));
    EXPECT_EQ(entry.substr(12, 8), std::string("\x50\0\0\0\0\0\0\0", 8));
    EXPECT_EQ(entry.substr(20, 4), "\1\2\3\4");
    EXPECT_EQ(entry[35], '\xf0');
}

TEST(EntryCodec, triangleListsTakeLessThanTwoBytesAnIndex)
{
    test::TestMesh mesh = test::makeTerrain(100);
    EXPECT_GT(mesh.buffers[0].vertexCount(), 10000u);
    const std::vector<std::uint32_t>& indices = mesh.subMeshes[0].indices;
    EXPECT_LT(encodePayload(chainOf(indices)).size(), 2 * indices.size());
}

TEST(EntryCodec, everyFlippedBitIsSeen)
{
    const std::string entry = encodeEntry(sampleKey(1), sampleChain(1));
    for (std::size_t i = 0; i < entry.size(); ++i)
        for (int bit = 0; bit < 8; ++bit) {
            std::string flipped = entry;
            flipped[i] = static_cast<char>(flipped[i] ^ (1 << bit));
            EXPECT_FALSE(decodeEntry(sampleKey(1), flipped)) << "byte " << i << ", bit " << bit;
        }
}

TEST(EntryCodec, everyFlippedBitIsSeenEvenWithTheRightChecksumOrChangesTheChain)
{
    const LodChain chain = sampleChain(1);
    const std::string entry = encodeEntry(sampleKey(1), chain);
    for (std::size_t i = 0; i < entry.size() - 8; ++i)
        for (int bit = 0; bit < 8; ++bit) {
            std::string flipped = entry.substr(0, entry.size() - 8);
            flipped[i] = static_cast<char>(flipped[i] ^ (1 << bit));
            const auto read = decodeEntry(sampleKey(1), sealed(flipped));
            EXPECT_FALSE(read && (i < kHeadBytes || same(*read, chain))) << "byte " << i << ", bit " << bit;
        }
}

TEST(EntryCodec, everyOtherLengthIsSeen)
{
    const std::string entry = encodeEntry(sampleKey(1), sampleChain(1));
    for (std::size_t length = 0; length < entry.size(); ++length)
        EXPECT_FALSE(decodeEntry(sampleKey(1), entry.substr(0, length))) << length;
    EXPECT_FALSE(decodeEntry(sampleKey(1), entry + '\0'));
    EXPECT_FALSE(decodeEntry(sampleKey(1), entry + entry));
    EXPECT_FALSE(decodeEntry(sampleKey(1), std::string(1000, '\0')));
}

TEST(EntryCodec, everyOtherLengthOfAPayloadIsSeen)
{
    const std::string payload = encodePayload(sampleChain(1));
    for (std::size_t length = 0; length < payload.size(); ++length)
        EXPECT_FALSE(decodePayload(payload.substr(0, length))) << length;
    EXPECT_FALSE(decodePayload(payload + '\0'));
}

TEST(EntryCodec, theEntryOfAnotherKeyIsSeen)
{
    EXPECT_FALSE(decodeEntry(sampleKey(2), encodeEntry(sampleKey(1), sampleChain(1))));
}

TEST(EntryCodec, anotherFormatIsRefused)
{
    const std::string entry = encodeEntry(sampleKey(1), sampleChain(1));
    const std::string body = entry.substr(0, entry.size() - 8);
    ASSERT_EQ(sealed(body), entry);
    for (const std::uint32_t format : {kCacheFormat - 1, kCacheFormat + 1, 0xffffffffu}) {
        std::string bytes;
        ByteWriter(bytes).fixed(format);
        EXPECT_FALSE(decodeEntry(sampleKey(1), sealed(std::string(body).replace(8, 4, bytes)))) << format;
    }
}

TEST(EntryCodec, countsBeyondWhatThereIsAllocateNothing)
{
    const std::string start = payloadStart(), most = "\xff\xff\xff\xff", one("\1\0\0\0", 4);
    const std::string level(4 + 4 + 8 + 8 + 1 + 1, '\0');
    EXPECT_TRUE(decodePayload(start + one + level + one + one + '\2'));
    // As many as there could be memory for, but not bytes: these would be gigabytes.
    EXPECT_FALSE(decodePayload(start + most + level + one + one + '\2'));
    EXPECT_FALSE(decodePayload(start + one + level + most + one + '\2'));
    EXPECT_FALSE(decodePayload(start + one + level + one + most + '\2'));
    EXPECT_FALSE(decodePayload(start + one + level + one + most + std::string(1000, '\2')));
}

TEST(EntryCodec, noNumberHasTwoForms)
{
    const std::string one("\1\0\0\0", 4), level(4 + 4 + 8 + 8 + 1 + 1, '\0');
    const std::string start = payloadStart() + one + level + one + one;
    const auto accepts = [&](const std::string& number) { return decodePayload(start + number).has_value(); };
    EXPECT_TRUE(accepts(std::string("\0", 1)));
    EXPECT_TRUE(accepts("\xff\xff\xff\xff\x0f"));
    EXPECT_FALSE(accepts(std::string("\x80\0", 2)));
    EXPECT_FALSE(accepts(std::string("\xff\xff\xff\xff\0", 5)));
    EXPECT_FALSE(accepts("\xff\xff\xff\xff\x1f"));
    EXPECT_FALSE(accepts("\xff\xff\xff\xff\xff\x01"));
    EXPECT_FALSE(accepts("\xff"));
}

TEST(EntryCodec, wordsThatDoNotExistAreRefused)
{
    const std::string one("\1\0\0\0", 4), none(4, '\0'), numbers(4 + 4 + 8 + 8, '\0');
    const std::string start = payloadStart() + one + numbers;
    EXPECT_TRUE(decodePayload(start + '\3' + '\1' + none));
    EXPECT_FALSE(decodePayload(start + '\4' + '\1' + none));
    EXPECT_FALSE(decodePayload(start + '\3' + '\2' + none));
}

} // namespace lodsmith
