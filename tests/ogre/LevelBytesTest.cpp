#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/LevelBytes.h>
#include <lodsmith/ogre/MeshReader.h>
#include <lodsmith/ogre/MeshWriter.h>

#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <zlib.h>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// How a test writes a mesh.
struct Writing {
    Ogre::MeshVersion version = Ogre::MESH_VERSION_1_10;
    Ogre::Serializer::Endian endian = Ogre::Serializer::ENDIAN_NATIVE;
    bool sharedBuffers = false;
    bool edgeLists = false;
};

/// Levels of half, a fifth and a tenth of each submesh's triangles; what they look like does not matter here.
void giveLevels(const Ogre::MeshPtr& mesh, bool sharedBuffers)
{
    const std::vector<double> shares = {0.5, 0.2, 0.1};
    LodConfig config = proportional(mesh, {0.5, 0.8, 0.9});
    config.shareIndexBuffers = sharedBuffers;
    const auto data = MeshReader::read(*mesh);
    ASSERT_TRUE(data) << describe(data.error());
    const auto written = MeshWriter::write(config, data.value(), shortenedChain(data.value().view(), shares));
    ASSERT_TRUE(written) << describe(written.error());
}

/// What the documentation of the format says of a generated level's entry, from the mesh itself.
std::uint64_t expectedBytes(const Ogre::Mesh& mesh, unsigned level, Ogre::MeshVersion version)
{
    const bool isCurrent = version == Ogre::MESH_VERSION_1_10;
    std::uint64_t bytes = 6 + 4; // header, value
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes()) {
        const Ogre::IndexData& indices = *subMesh->mLodFaceList[level - 1];
        const bool isFirst =
            std::none_of(subMesh->mLodFaceList.begin(), subMesh->mLodFaceList.begin() + (level - 1),
                         [&](const Ogre::IndexData* earlier) { return earlier->indexBuffer == indices.indexBuffer; });
        if (!isCurrent)
            bytes += 6 + 4 + 1; // header, count, width
        else
            bytes += 4 + 4 + 4 + (isFirst ? 1 + 4 : 0); // count, start, buffer; width, size
        bytes += indices.indexCount * indices.indexBuffer->getIndexSize();
    }
    return bytes;
}

std::uint64_t sumOf(const MeshBytes& bytes)
{
    std::uint64_t sum = 0;
    for (const LevelBytes& level : bytes.levels)
        sum += level.bytes;
    return sum;
}

std::uint64_t bufferBytes(const Ogre::Mesh& mesh)
{
    std::uint64_t bytes = 0;
    const auto add = [&](const Ogre::VertexData* vertices) {
        if (vertices)
            for (const auto& binding : vertices->vertexBufferBinding->getBindings())
                bytes += binding.second->getVertexSize() * vertices->vertexCount;
    };
    add(mesh.sharedVertexData);
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes()) {
        add(subMesh->useSharedVertices ? nullptr : subMesh->vertexData);
        bytes += subMesh->indexData->indexCount * subMesh->indexData->indexBuffer->getIndexSize();
    }
    return bytes;
}

class LevelBytesTest : public testing::Test {
protected:
    fs::path write(const Ogre::MeshPtr& mesh, const std::string& name, const Writing& writing = {})
    {
        const fs::path file = mSession.directory() / name;
        Ogre::MeshSerializer().exportMesh(mesh.get(), file.string(), writing.version, writing.endian);
        return file;
    }

    MeshBytes counted(const fs::path& file)
    {
        const auto bytes = levelBytes(file);
        EXPECT_TRUE(bytes) << describe(bytes.error());
        return bytes ? bytes.value() : MeshBytes{};
    }

    /// Whether all files together, and each level, are what they are counted as.
    void checkMesh(const Ogre::MeshPtr& mesh, const Writing& writing)
    {
        giveLevels(mesh, writing.sharedBuffers);
        if (writing.edgeLists)
            mesh->buildEdgeList();
        const fs::path file = write(mesh, "counted.mesh", writing);
        const MeshBytes bytes = counted(file);
        EXPECT_EQ(sumOf(bytes), fs::file_size(file));
        ASSERT_EQ(bytes.levels.size(), mesh->getNumLodLevels());
        for (unsigned level = 1; level < bytes.levels.size(); ++level) {
            EXPECT_EQ(bytes.levels[level].bytes, expectedBytes(*mesh, level, writing.version)) << level;
            EXPECT_GT(bytes.levels[level].zlibBytes, 0u);
        }
        mesh->freeEdgeList();
    }

    OgreSession mSession;
};

TEST_F(LevelBytesTest, GeneratedLevelsHaveTheirEntriesInEveryFormat)
{
    for (const bool wide : {false, true}) {
        const Ogre::MeshPtr mesh = makeOgreMesh(wide ? "wide" : "narrow", makeTwoMaterials(12, true), {true, wide});
        for (const auto version : {Ogre::MESH_VERSION_1_10, Ogre::MESH_VERSION_1_8, Ogre::MESH_VERSION_1_7})
            for (const auto endian : {Ogre::Serializer::ENDIAN_LITTLE, Ogre::Serializer::ENDIAN_BIG})
                for (const bool shared : {false, true}) {
                    SCOPED_TRACE(testing::Message() << version << " " << endian << " " << shared);
                    checkMesh(mesh, {version, endian, shared, shared});
                }
    }
}

TEST_F(LevelBytesTest, TheSumIsTheSizeForEveryMeshOfTheMedia)
{
    std::vector<fs::path> files;
    for (const std::string directory : {LODSMITH_MEDIA_DIR, LODSMITH_EXTRA_MEDIA})
        if (!directory.empty())
            for (const auto& entry : fs::recursive_directory_iterator(directory))
                if (entry.path().extension() == ".mesh")
                    files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    ASSERT_FALSE(files.empty());
    for (const fs::path& file : files) {
        SCOPED_TRACE(file.string());
        const MeshBytes plain = counted(file);
        std::uint64_t sizes = 0;
        for (const CountedFile& part : plain.files)
            sizes += fs::file_size(part.file);
        EXPECT_EQ(sumOf(plain), sizes);

        // Somewhere else, since the materials beside it would want a texture manager.
        const TestDirectory alone;
        fs::copy_file(file, alone / "mesh.mesh");
        const Ogre::MeshPtr mesh = mSession.load(alone / "mesh.mesh");
        checkMesh(mesh, {});
        checkMesh(mesh, {Ogre::MESH_VERSION_1_10, Ogre::Serializer::ENDIAN_NATIVE, true, true});
        Ogre::MeshManager::getSingleton().remove(mesh->getHandle());
    }
}

TEST_F(LevelBytesTest, AMeshWithoutLevelsIsAllLevelZero)
{
    const fs::path file = write(makeOgreMesh("plain", makeTorus(20, 10)), "plain.mesh");
    const MeshBytes bytes = counted(file);
    ASSERT_EQ(bytes.levels.size(), 1u);
    EXPECT_EQ(bytes.levels[0].bytes, fs::file_size(file));
    const std::string content = contentOf(file);
    uLongf size = compressBound(content.size());
    std::string packed(size, '\0');
    ASSERT_EQ(compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(content.data()),
                        content.size(), kZlibLevel),
              Z_OK);
    EXPECT_EQ(bytes.levels[0].zlibBytes, size);
    EXPECT_EQ(bytes.levels[0].duplicateBytes, 0u);
    EXPECT_THAT(bytes.notes, IsEmpty());
}

/// A mesh with two levels of one buffer a submesh, of which both draw some indices and some are drawn by neither.
TEST_F(LevelBytesTest, OfAnOverlappingBufferTheNearerLevelHasWhatBothDraw)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("overlap", makeTorus(20, 10));
    giveLevels(mesh, true);
    Ogre::IndexData& nearer = *mesh->getSubMesh(0)->mLodFaceList[0];
    Ogre::IndexData& farther = *mesh->getSubMesh(0)->mLodFaceList[1];
    const std::size_t whole = nearer.indexBuffer->getNumIndexes();
    nearer.indexStart = 30;
    nearer.indexCount = 60;
    farther.indexStart = 60;
    farther.indexCount = 90;
    const fs::path file = write(mesh, "overlap.mesh");
    const MeshBytes bytes = counted(file);
    EXPECT_EQ(sumOf(bytes), fs::file_size(file));
    EXPECT_EQ(bytes.levels[1].bytes, 10u + 17 + 2 * (60 + (whole - 120)));
    EXPECT_EQ(bytes.levels[2].bytes, 10u + 12 + 2 * 60);
}

TEST_F(LevelBytesTest, AHandMadeLevelBringsItsFilesOnce)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("owner", makeTorus(20, 10));
    const Ogre::MeshPtr other = makeOgreMesh("other", makeTorus(8, 6));
    mesh->setSkeletonName("owner.skeleton");
    other->setSkeletonName("other.skeleton");
    const fs::path otherFile = write(other, "other.mesh");
    setHandMadeLevels(*mesh, {"other.mesh", "other.mesh"});
    const fs::path file = write(mesh, "owner.mesh");
    std::ofstream(mSession.directory() / "owner.skeleton") << std::string(1000, 'a');
    std::ofstream(mSession.directory() / "other.skeleton") << std::string(300, 'b');
    const MeshBytes bytes = counted(file);
    ASSERT_EQ(bytes.levels.size(), 3u);
    const std::uint64_t entry = 6 + 4 + std::string("other.mesh\n").size();
    EXPECT_EQ(bytes.levels[0].bytes, fs::file_size(file) - 2 * entry + 1000);
    EXPECT_EQ(bytes.levels[1].bytes, entry + fs::file_size(otherFile) + 300);
    EXPECT_EQ(bytes.levels[2].bytes, entry);
    EXPECT_EQ(bytes.levels[1].manual, "other.mesh");
    ASSERT_EQ(bytes.files.size(), 4u);
    EXPECT_EQ(sumOf(bytes), fs::file_size(file) + fs::file_size(otherFile) + 1300);
    EXPECT_THAT(bytes.notes, ElementsAre(HasSubstr("level 2")));
}

TEST_F(LevelBytesTest, WhatAHigherLevelHasTooIsADuplicate)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("original", makeTwoMaterials(8, false));
    write(mesh, "copy.mesh");
    setHandMadeLevel(*mesh, "copy.mesh");
    const MeshBytes bytes = counted(write(mesh, "original.mesh"));
    ASSERT_EQ(bytes.levels.size(), 2u);
    EXPECT_EQ(bytes.levels[0].duplicateBytes, 0u);
    EXPECT_EQ(bytes.levels[1].duplicateBytes, bufferBytes(*mesh));
    EXPECT_LT(bytes.levels[1].duplicateBytes, bytes.levels[1].bytes);
}

TEST_F(LevelBytesTest, AMeshThatIsItsOwnLevelIsCountedOnce)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("self", makeTorus(8, 6));
    setHandMadeLevel(*mesh, "self.mesh");
    const fs::path file = write(mesh, "self.mesh");
    EXPECT_EQ(sumOf(counted(file)), fs::file_size(file));
}

TEST_F(LevelBytesTest, ASkeletonThatIsNotThereIsNoted)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("skinned", makeTorus(8, 6));
    for (const std::string name : {"missing.skeleton", "../outside.skeleton", "/etc/hostname"}) {
        mesh->setSkeletonName(name);
        const fs::path file = write(mesh, "skinned.mesh");
        const MeshBytes bytes = counted(file);
        EXPECT_EQ(sumOf(bytes), fs::file_size(file));
        EXPECT_THAT(bytes.notes, ElementsAre(HasSubstr(name)));
    }
}

TEST_F(LevelBytesTest, AHandMadeLevelThatIsNotThereIsAnError)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("owner", makeTorus(8, 6));
    setHandMadeLevel(*mesh, "missing.mesh");
    const auto missing = levelBytes(write(mesh, "owner.mesh"));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
    EXPECT_THAT(missing.error().file, HasSubstr("missing.mesh"));
    mesh->removeLodLevels();
    setHandMadeLevel(*mesh, "../outside.mesh");
    const auto outside = levelBytes(write(mesh, "owner.mesh"));
    ASSERT_FALSE(outside);
    EXPECT_EQ(outside.error().code, ErrorCode::BadFile);
    EXPECT_THAT(outside.error().message, HasSubstr("level 1"));
}

TEST_F(LevelBytesTest, FilesThatAreNoMeshesAreErrors)
{
    const auto codeOf = [&](const std::string& name) {
        const auto bytes = levelBytes(mSession.directory() / name);
        EXPECT_FALSE(bytes);
        return bytes ? ErrorCode::Cancelled : bytes.error().code;
    };
    std::ofstream(mSession.directory() / "empty.mesh");
    std::ofstream(mSession.directory() / "text.mesh") << "no mesh at all";
    EXPECT_EQ(codeOf("none.mesh"), ErrorCode::NotFound);
    EXPECT_EQ(codeOf("."), ErrorCode::Io);
    EXPECT_EQ(codeOf("empty.mesh"), ErrorCode::BadFile);
    EXPECT_EQ(codeOf("text.mesh"), ErrorCode::BadFile);
}

} // namespace
} // namespace lodsmith::test
