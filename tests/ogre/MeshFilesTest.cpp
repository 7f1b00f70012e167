#include <lodsmith/ogre/MeshFiles.h>
#include <lodsmith/ogre/MeshReader.h>

#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <OgreArchiveManager.h>
#include <OgreMaterialManager.h>
#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreResourceGroupManager.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace lodsmith::test {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class MeshFilesTest : public testing::Test {
protected:
    /// A file in a directory that OGRE does not know.
    fs::path writeMesh(const std::string& name, std::uint32_t subdivisions = 1)
    {
        const Ogre::MeshPtr mesh = makeOgreMesh("writing " + name, makeIcosphere(subdivisions));
        fs::create_directories((mDirectory / name).parent_path());
        Ogre::MeshSerializer().exportMesh(mesh.get(), (mDirectory / name).string());
        Ogre::MeshManager::getSingleton().remove(mesh);
        return mDirectory / name;
    }

    std::string errorOf(const fs::path& path)
    {
        const Result<Ogre::MeshPtr> mesh = openMeshFile(path);
        return mesh ? "no error" : describe(mesh.error());
    }

    TestDirectory mDirectory;
    OgreSession mSession;
};

} // namespace

TEST_F(MeshFilesTest, ADirectoryIsAGroupOfItsOwn)
{
    const Ogre::MeshPtr a = openMeshFile(writeMesh("a.mesh")).value();
    EXPECT_TRUE(a->isLoaded());
    EXPECT_EQ("a.mesh", a->getName());
    EXPECT_EQ(fs::canonical(mDirectory.path()).string(), a->getGroup());
    // By another way to the same file, and one that came later.
    EXPECT_EQ(a, openMeshFile(mDirectory.path() / "." / "a.mesh").value());
    EXPECT_EQ(a->getGroup(), openMeshFile(writeMesh("b.mesh")).value()->getGroup());
    // Of two directories with the same name in them, each has its own.
    const Ogre::MeshPtr other = openMeshFile(writeMesh("below/a.mesh", 2)).value();
    EXPECT_NE(a, other);
    EXPECT_EQ(4 * a->getSubMesh(0)->indexData->indexCount, other->getSubMesh(0)->indexData->indexCount);
}

TEST_F(MeshFilesTest, PathsAreThoseOfTheFiles)
{
    const fs::path path = writeMesh("a.mesh");
    const Ogre::MeshPtr mesh = openMeshFile(path).value();
    EXPECT_EQ(fs::canonical(path), meshPath(*mesh).value());
    EXPECT_EQ(ErrorCode::Unsupported, meshPath(*makeOgreMesh("by hand", makeIcosphere(0))).error().code);
    const Ogre::ResourcePtr nowhere = Ogre::MeshManager::getSingleton().createResource("none.mesh", mSession.group());
    EXPECT_EQ(ErrorCode::NotFound, meshPath(static_cast<const Ogre::Mesh&>(*nowhere)).error().code);
}

TEST_F(MeshFilesTest, WhatCannotBeOpenedLeavesNoMesh)
{
    EXPECT_THAT(errorOf(mDirectory / "a.mesh"), HasSubstr("No such file"));
    EXPECT_THAT(errorOf(mDirectory.path()), HasSubstr("no regular file"));
    mDirectory.write("text.mesh", "no mesh");
    EXPECT_THAT(errorOf(mDirectory / "text.mesh"), HasSubstr("no OGRE mesh"));
    const std::string group = fs::canonical(mDirectory.path()).string();
    EXPECT_FALSE(Ogre::MeshManager::getSingleton().getByName("text.mesh", group));
}

TEST_F(MeshFilesTest, AMeshThatIsLoadedAgainIsCheckedAgain)
{
    const fs::path path = writeMesh("a.mesh");
    const Ogre::MeshPtr mesh = openMeshFile(path).value();
    const std::string whole = contentOf(path);
    mesh->unload();
    mDirectory.write("a.mesh", whole.substr(0, whole.size() / 2));
    const Result<Done> cut = loadMesh(mesh);
    ASSERT_FALSE(cut.ok());
    EXPECT_EQ(ErrorCode::BadFile, cut.error().code);
    EXPECT_FALSE(mesh->isLoaded());
    mDirectory.write("a.mesh", whole);
    EXPECT_TRUE(loadMesh(mesh).ok());
    EXPECT_TRUE(mesh->isLoaded());
}

/// All but where one part of the file has ended and the next not begun: such files are whole as far as anybody can tell.
TEST_F(MeshFilesTest, AFileCutOffAnywhereIsAnErrorAndNoAbort)
{
    const std::string whole = contentOf(writeMesh("a.mesh", 0));
    std::size_t accepted = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
        mDirectory.write("cut.mesh", whole.substr(0, length));
        if (const Result<Ogre::MeshPtr> mesh = openMeshFile(mDirectory / "cut.mesh"); mesh) {
            ++accepted;
            EXPECT_TRUE(MeshReader::read(*mesh.value()).ok());
            Ogre::MeshManager::getSingleton().remove(mesh.value());
        }
    }
    EXPECT_LE(accepted, 8u) << "of " << whole.size();
}

TEST_F(MeshFilesTest, MaterialsBesideTheMeshAreRead)
{
    writeMesh("a.mesh");
    mDirectory.write("a.material", "material beside\n{\n}\n");
    const Ogre::MeshPtr mesh = openMeshFile(mDirectory / "a.mesh").value();
    EXPECT_TRUE(Ogre::MaterialManager::getSingleton().getByName("beside", mesh->getGroup()));
}

TEST_F(MeshFilesTest, ADirectoryGivesAllMeshesBelowItUnloaded)
{
    const fs::path second = writeMesh("b.mesh");
    const fs::path first = writeMesh("a/c.mesh");
    writeMesh(".hidden/d.mesh");
    mDirectory.write("text.txt", "no mesh");
    fs::create_symlink(mDirectory / "nowhere.mesh", mDirectory / "dangling.mesh");
    const auto meshes = openMeshDirectory(mDirectory.path());
    ASSERT_TRUE(meshes) << describe(meshes.error());
    ASSERT_EQ(meshes.value().size(), 2u);
    EXPECT_EQ(meshes.value()[0]->getName(), "c.mesh");
    EXPECT_EQ(meshes.value()[1]->getName(), "b.mesh");
    EXPECT_FALSE(meshes.value()[0]->isLoaded());
    EXPECT_EQ(openMeshFile(first).value(), meshes.value()[0]);
    EXPECT_EQ(openMeshDirectory(second).error().code, ErrorCode::Io);
    EXPECT_EQ(openMeshDirectory(mDirectory / "none").error().code, ErrorCode::NotFound);
}

TEST_F(MeshFilesTest, RealMeshesAreOpened)
{
    if (std::string(LODSMITH_EXTRA_MEDIA).empty())
        GTEST_SKIP() << "LODSMITH_EXTRA_MEDIA is empty";
    for (const auto& entry : fs::recursive_directory_iterator(LODSMITH_EXTRA_MEDIA))
        if (entry.path().extension() == ".mesh") {
            EXPECT_EQ("no error", errorOf(entry.path())) << entry.path();
        }
}

} // namespace lodsmith::test
