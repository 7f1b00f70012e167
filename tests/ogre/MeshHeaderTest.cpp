#include "MeshHeader.h"

#include <gmock/gmock.h>

namespace lodsmith {

namespace {

using testing::HasSubstr;

/// A mesh file's first bytes, as long as its mesh chunk says.
std::string header(const std::string& version, bool bigEndian)
{
    const std::string line = "[MeshSerializer_v" + version + "]\n";
    return bigEndian ? std::string("\x10\x00", 2) + line + std::string("\x30\x00\x00\x00\x00\x06", 6)
                     : std::string("\x00\x10", 2) + line + std::string("\x00\x30\x06\x00\x00\x00", 6);
}

std::string messageOf(const std::string& bytes)
{
    const Result<MeshHeader> parsed = parseMeshHeader(bytes);
    return parsed ? "no error" : parsed.error().message;
}

} // namespace

TEST(MeshHeader, allVersionsInBothByteOrders)
{
    for (const std::string version : {"1.10", "1.20", "1.30", "1.40", "1.41", "1.8", "1.100"})
        for (const bool bigEndian : {false, true}) {
            const Result<MeshHeader> parsed = parseMeshHeader(header(version, bigEndian));
            ASSERT_TRUE(parsed) << version << messageOf(header(version, bigEndian));
            EXPECT_EQ(parsed.value().version, version);
            EXPECT_EQ(parsed.value().bigEndian, bigEndian);
        }
}

TEST(MeshHeader, whatIsNoMeshIsSaidToBeNone)
{
    EXPECT_THAT(messageOf(""), HasSubstr("empty"));
    EXPECT_THAT(messageOf("x"), HasSubstr("no OGRE mesh"));
    EXPECT_THAT(messageOf("hello, world"), HasSubstr("no OGRE mesh"));
    EXPECT_THAT(messageOf(std::string("\x00\x10", 2)), HasSubstr("no OGRE mesh"));
    EXPECT_THAT(messageOf(std::string("\x00\x10[Serializer_v1.80]\n", 21)), HasSubstr("no OGRE mesh"));
    EXPECT_THAT(messageOf(std::string("\x00\x10", 2) + "[MeshSerializer_v" + std::string(1000, '1')),
                HasSubstr("no OGRE mesh"));
}

TEST(MeshHeader, otherVersionsAreNamed)
{
    EXPECT_THAT(messageOf(header("2.1 R0 LEGACYV1", false)), HasSubstr("'2.1 R0 LEGACYV1'"));
}

TEST(MeshHeader, aFileThatEndsBeforeItsMeshIsCutOff)
{
    std::string bytes = header("1.100", false);
    EXPECT_THAT(messageOf(bytes.substr(0, bytes.size() - 1)), HasSubstr("cut off"));
    // 256 bytes more than there are, as OGRE's own writer miscounts, and 64 KiB more.
    bytes[bytes.size() - 3] = 1;
    EXPECT_EQ(messageOf(bytes), "no error");
    bytes[bytes.size() - 2] = 1;
    EXPECT_THAT(messageOf(bytes), HasSubstr("cut off"));
}

} // namespace lodsmith
