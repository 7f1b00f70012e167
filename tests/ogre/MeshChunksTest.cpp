#include "MeshChunks.h"

#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/MeshReader.h>
#include <lodsmith/ogre/MeshWriter.h>

#include <OgreMeshSerializer.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <cstdint>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace lodsmith::test {
namespace {

using testing::HasSubstr;

/// A part of a file in the making: number, length, content.
class Part {
public:
    explicit Part(bool bigEndian) : mBigEndian(bigEndian) {}

    Part& number(std::uint32_t value, int bytes)
    {
        for (int i = 0; i < bytes; ++i)
            mBytes += static_cast<char>(value >> 8 * (mBigEndian ? bytes - 1 - i : i));
        return *this;
    }
    Part& zeros(std::size_t count) { return text(std::string(count, '\0')); }
    Part& text(const std::string& bytes)
    {
        mBytes += bytes;
        return *this;
    }
    /// Another part inside of this one, whose stated length is wrong by `lie`.
    Part& part(std::uint32_t chunk, const Part& content, int lie = 0)
    {
        number(chunk, 2);
        number(static_cast<std::uint32_t>(static_cast<int>(content.mBytes.size()) + 6 + lie), 4);
        return text(content.mBytes);
    }
    const std::string& bytes() const { return mBytes; }

private:
    bool mBigEndian;
    std::string mBytes;
};

/// A mesh of the given old version: one triangle of its own vertices, and levels behind it.
struct OldMesh {
    std::string version;
    bool bigEndian = false;
    bool manual = false;
    int lie = 0; ///< what the submesh's length is wrong by

    Part part() const { return Part(bigEndian); }

    bool hasOldGeometry() const { return version == "1.10" || version == "1.20"; }

    Part geometry() const
    {
        Part result = part().number(3, 4);
        if (hasOldGeometry())
            return result.zeros(36).part(0x5100, part().zeros(36)).part(0x5300, part().number(2, 2).zeros(24));
        const Part position = part().number(0, 2).number(2, 2).number(1, 2).number(0, 2).number(0, 2);
        const Part buffer = part().number(0, 2).number(12, 2).part(0x5210, part().zeros(36));
        return result.part(0x5100, part().part(0x5110, position)).part(0x5200, buffer);
    }

    Part subMesh() const
    {
        Part result = part().text("material\n").number(0, 1).number(3, 4).number(0, 1);
        result.number(0, 2).number(1, 2).number(2, 2);
        result.part(0x5000, geometry());
        result.part(0x4010, part().number(4, 2));
        return result.part(0x4100, part().zeros(10));
    }

    Part levels() const
    {
        Part result = part();
        if (version == "1.41" || version == "1.8")
            result.text("distance_sphere\n");
        result.number(3, 2).number(manual ? 1 : 0, 1);
        for (const std::uint32_t value : {0x42c80000u, 0x43480000u}) { // 100, 200
            Part level = part().number(value, 4);
            if (manual)
                level.part(0x8110, part().text("other.mesh\n"));
            else
                level.part(0x8120, part().number(3, 4).number(0, 1).zeros(6));
            result.part(0x8100, level);
        }
        return result;
    }

    std::string bytes() const
    {
        Part mesh = part().number(0, 1);
        mesh.part(0x4000, subMesh(), lie).part(0x8000, levels());
        mesh.part(0x9000, part().zeros(28)).part(0xA000, part());
        Part file = part().number(0x1000, 2).text("[MeshSerializer_v" + version + "]\n");
        return file.part(0x3000, mesh, lie).bytes();
    }
};

Result<MeshChunks> chunksOf(const std::string& bytes)
{
    const Result<MeshHeader> header = parseMeshHeader(bytes);
    if (!header)
        return header.error();
    return readMeshChunks(bytes, header.value());
}

/// Every byte once, in order, buffers inside of what their level has.
void expectWhole(const MeshChunks& chunks, std::size_t size)
{
    std::size_t done = 0;
    for (const FileSpan& span : chunks.spans) {
        EXPECT_EQ(span.begin, done);
        EXPECT_LT(span.begin, span.end);
        EXPECT_LT(span.level, chunks.manual.size());
        done = span.end;
    }
    EXPECT_EQ(done, size);
    for (const FileSpan& buffer : chunks.buffers) {
        bool inside = false;
        for (const FileSpan& span : chunks.spans)
            inside = inside || (span.level == buffer.level && span.begin <= buffer.begin && buffer.end <= span.end);
        EXPECT_TRUE(inside) << buffer.begin;
    }
}

std::size_t bytesOf(const MeshChunks& chunks, unsigned level)
{
    std::size_t sum = 0;
    for (const FileSpan& span : chunks.spans)
        sum += span.level == level ? span.end - span.begin : 0;
    return sum;
}

/// A file of today's format with generated levels, two of which share buffers, and a hand-made one.
std::string currentMesh()
{
    const Ogre::MeshPtr mesh = makeOgreMesh("current", makeTwoMaterials(6, false));
    LodConfig config = proportional(mesh, {0.5, 0.8, 0.9});
    config.shareIndexBuffers = true;
    const Ogre::MeshPtr other = makeOgreMesh("other.mesh", makeTetrahedron());
    config.levels.push_back({40, {}, "other.mesh"});
    const auto data = MeshReader::read(*mesh);
    EXPECT_TRUE(MeshWriter::write(config, data.value(), shortenedChain(data.value().view(), {0.5, 0.2, 0.1})));
    const TestDirectory directory;
    const auto file = directory / "current.mesh";
    Ogre::MeshSerializer().exportMesh(mesh.get(), file.string());
    return contentOf(file);
}

TEST(MeshChunksTest, OldFormatsInBothByteOrders)
{
    for (const std::string version : {"1.10", "1.20", "1.30", "1.40", "1.41", "1.8"})
        for (const bool bigEndian : {false, true})
            for (const bool manual : {false, true}) {
                SCOPED_TRACE(version);
                const std::string bytes = OldMesh{version, bigEndian, manual}.bytes();
                const auto chunks = chunksOf(bytes);
                ASSERT_TRUE(chunks) << describe(chunks.error());
                expectWhole(chunks.value(), bytes.size());
                ASSERT_EQ(chunks.value().manual.size(), 3u);
                const std::size_t entry = 6 + 4 + 6 + (manual ? std::string("other.mesh\n").size() : 4 + 1 + 6);
                EXPECT_EQ(bytesOf(chunks.value(), 1), entry);
                EXPECT_EQ(bytesOf(chunks.value(), 2), entry);
                EXPECT_EQ(chunks.value().manual[2], manual ? "other.mesh" : "");
            }
}

TEST(MeshChunksTest, OgreReadsTheseOldFilesToo)
{
    OgreSession session;
    for (const std::string version : {"1.10", "1.20", "1.30", "1.40", "1.41", "1.8"}) {
        const auto file = session.directory() / ("old" + version + ".mesh");
        std::ofstream(file, std::ios::binary) << OldMesh{version}.bytes();
        const Ogre::MeshPtr mesh = session.loadSaved(file.filename().string());
        EXPECT_EQ(mesh->getNumLodLevels(), 3) << version;
        EXPECT_EQ(mesh->getSubMesh(0)->vertexData->vertexCount, 3u) << version;
    }
}

TEST(MeshChunksTest, StatedLengthsOfSubMeshesAreNotTrusted)
{
    for (const int lie : {-9, 1, 40}) {
        const std::string bytes = OldMesh{"1.8", false, false, lie}.bytes();
        const auto chunks = chunksOf(bytes);
        ASSERT_TRUE(chunks) << describe(chunks.error());
        expectWhole(chunks.value(), bytes.size());
        EXPECT_EQ(bytesOf(chunks.value(), 1), 6u + 4 + 6 + 4 + 1 + 6);
    }
}

TEST(MeshChunksTest, ASkeletonIsNamed)
{
    OgreSession session;
    const Ogre::MeshPtr mesh = makeOgreMesh("skinned", makeTetrahedron());
    mesh->setSkeletonName("some.skeleton");
    const auto file = session.directory() / "skinned.mesh";
    Ogre::MeshSerializer().exportMesh(mesh.get(), file.string());
    const auto chunks = chunksOf(contentOf(file));
    ASSERT_TRUE(chunks);
    EXPECT_EQ(chunks.value().skeleton, "some.skeleton");
}

TEST(MeshChunksTest, WhereverAFileIsCutItIsAnErrorOrWhole)
{
    OgreSession session;
    for (const std::string& bytes : {currentMesh(), OldMesh{"1.20"}.bytes(), OldMesh{"1.8"}.bytes()})
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            const std::string cut = bytes.substr(0, size);
            const auto header = parseMeshHeader(bytes); // the cut one's would refuse most of them
            const auto chunks = readMeshChunks(cut, header.value());
            if (chunks)
                expectWhole(chunks.value(), size);
            else
                EXPECT_EQ(chunks.error().code, ErrorCode::BadFile);
        }
}

TEST(MeshChunksTest, DamagedFilesAreErrorsOrWhole)
{
    OgreSession session;
    std::mt19937 random(5);
    for (const std::string& bytes : {currentMesh(), OldMesh{"1.10"}.bytes(), OldMesh{"1.41", true, true}.bytes()})
        for (int i = 0; i < 4000; ++i) {
            std::string damaged = bytes;
            for (int change = 0; change < 1 + i % 3; ++change)
                damaged[40 + random() % (damaged.size() - 40)] = static_cast<char>(i % 2 ? 0xff : random());
            if (const auto chunks = chunksOf(damaged))
                expectWhole(chunks.value(), damaged.size());
            else
                EXPECT_EQ(chunks.error().code, ErrorCode::BadFile);
        }
}

TEST(MeshChunksTest, CountsBeyondTheEndSayWhere)
{
    const OldMesh old{"1.8"};
    const Part endless = old.part().text("material\n").number(1, 1).number(0xfffffffe, 4).number(1, 1);
    const Part file = old.part()
                          .number(0x1000, 2)
                          .text("[MeshSerializer_v1.8]\n")
                          .part(0x3000, old.part().number(0, 1).part(0x4000, endless));
    const auto chunks = chunksOf(file.bytes());
    ASSERT_FALSE(chunks);
    EXPECT_THAT(chunks.error().message, HasSubstr("byte " + std::to_string(file.bytes().size())));
    EXPECT_THAT(chunks.error().message, HasSubstr("17179869176 bytes are expected, and 0 are left"));
}

TEST(MeshChunksTest, LevelsThatOgreWouldNotTakeAreErrors)
{
    const auto meshWith = [&](const Part& levels) {
        Part mesh = Part(false).number(0, 1).part(0x4000, OldMesh{"1.100"}.subMesh());
        mesh.part(0x8000, levels);
        return Part(false).number(0x1000, 2).text("[MeshSerializer_v1.100]\n").part(0x3000, mesh).bytes();
    };
    const auto list = [](std::uint32_t buffer) {
        return Part(false).number(0x41200000, 4).number(3, 4).number(0, 4).number(buffer, 4);
    };
    const auto levels = [](int count) { return Part(false).text("pixel_count\n").number(count, 2); };
    Part own = list(0xffffffff);
    own.number(0, 1).number(3, 4).zeros(6);

    EXPECT_TRUE(chunksOf(meshWith(levels(0))));
    EXPECT_TRUE(chunksOf(meshWith(levels(1))));
    EXPECT_TRUE(chunksOf(meshWith(levels(2).part(0x8120, own))));
    EXPECT_TRUE(chunksOf(meshWith(levels(3).part(0x8120, own).part(0x8120, list(1)))));
    EXPECT_FALSE(chunksOf(meshWith(levels(2))));
    EXPECT_FALSE(chunksOf(meshWith(levels(3).part(0x8120, own).part(0x8120, list(2)))));
    EXPECT_FALSE(chunksOf(meshWith(levels(3).part(0x8120, own).part(0x8120, list(0)))));
    EXPECT_FALSE(
        chunksOf(meshWith(levels(3).part(0x8110, Part(false).zeros(4).text("a.mesh\n")).part(0x8120, list(1)))));
    EXPECT_FALSE(chunksOf(meshWith(levels(2).part(0x8110, Part(false).zeros(4).text("\n")))));
    EXPECT_FALSE(chunksOf(meshWith(levels(2).part(0x8100, own))));
    EXPECT_FALSE(chunksOf(meshWith(levels(2).part(0x8120, own).part(0x8000, levels(1)))));
}

} // namespace
} // namespace lodsmith::test
