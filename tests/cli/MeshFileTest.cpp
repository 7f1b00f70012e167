#include "MeshFile.h"

#include "../../src/ogre/MeshHeader.h"
#include "OgreSession.h"
#include "SampleFiles.h"

#include <OgreSubMesh.h>

#include <gmock/gmock.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using test::torusMesh;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

} // namespace

TEST(MeshFile, versionAndByteOrderAreWhatWasAskedFor)
{
    const std::pair<const char*, const char*> versions[] = {
        {"1.0", "1.30"}, {"1.4", "1.40"}, {"1.41", "1.41"}, {"1.8", "1.8"}, {"1.10", "1.100"}};
    const TestDirectory directory;
    const std::string path = directory.write("torus.mesh", torusMesh(8));
    OgreSession session;
    const Ogre::MeshPtr mesh = session.load(path).value();
    for (const auto& [name, written] : versions)
        for (const char* order : {"little", "big"}) {
            const auto bytes = meshBytes(*mesh, {parseMeshVersion(name).value(), parseEndian(order).value()});
            ASSERT_TRUE(bytes) << name;
            const MeshHeader header = parseMeshHeader(bytes.value()).value();
            EXPECT_EQ(header.version, written);
            EXPECT_EQ(header.bigEndian, order == std::string("big"));
            const Ogre::MeshPtr again = session.load(directory.write(std::string(name) + order, bytes.value())).value();
            EXPECT_EQ(again->getSubMesh(0)->indexData->indexCount, 3 * test::torusTriangles(8));
        }
}

TEST(MeshFile, wordsThatAreNoVersionsOrByteOrdersAreRefused)
{
    for (const char* word : {"", "1", "1.100", "2.0", "latest"})
        EXPECT_FALSE(parseMeshVersion(word)) << word;
    for (const char* word : {"", "Big", "middle"})
        EXPECT_FALSE(parseEndian(word)) << word;
}

TEST(MeshFile, formatsWithoutLevelsRefuseMeshesThatHaveSome)
{
    const TestDirectory directory;
    const std::string path = directory.write("torus.mesh", torusMesh(8));
    OgreSession session;
    const Ogre::MeshPtr mesh = session.load(path).value();
    mesh->_setLodInfo(2);
    EXPECT_EQ(meshBytes(*mesh, {Ogre::MESH_VERSION_1_4, Ogre::Serializer::ENDIAN_NATIVE}).error().code,
              ErrorCode::Unsupported);
}

TEST(MeshFile, namesOfTwoLinesAreRefusedSinceOneEndsAName)
{
    const TestDirectory directory;
    const std::string path = directory.write("torus.mesh", torusMesh(8));
    OgreSession session;
    const Ogre::MeshPtr mesh = session.load(path).value();
    const MeshFormat format{Ogre::MESH_VERSION_1_10, Ogre::Serializer::ENDIAN_NATIVE};
    ASSERT_TRUE(meshBytes(*mesh, format));
    const std::string before = mesh->getSubMesh(0)->getMaterialName();
    OgreSession::provideMaterial(*mesh, "two\nlines");
    mesh->getSubMesh(0)->setMaterialName("two\nlines", mesh->getGroup());
    EXPECT_THAT(describe(meshBytes(*mesh, format).error()), HasSubstr("'two\nlines'"));
    mesh->getSubMesh(0)->setMaterialName(before, mesh->getGroup());
    mesh->_setLodInfo(2);
    Ogre::MeshLodUsage usage;
    usage.manualName = "a\nb.mesh";
    mesh->_setLodUsage(1, usage);
    EXPECT_THAT(describe(meshBytes(*mesh, format).error()), HasSubstr("'a\nb.mesh'"));
}

TEST(MeshFile, vertexElementsThatOgreCannotTurnAreRefusedBeforeItDies)
{
    const TestDirectory directory;
    const std::string path = directory.write("torus.mesh", torusMesh(8));
    OgreSession session;
    const Ogre::MeshPtr mesh = session.load(path).value();
    auto& declaration = *mesh->getSubMesh(0)->vertexData->vertexDeclaration;
    declaration.modifyElement(1, 0, 12, Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE);
    const auto bytes = meshBytes(*mesh, {Ogre::MESH_VERSION_1_10, Ogre::Serializer::ENDIAN_BIG});
    ASSERT_FALSE(bytes);
    EXPECT_THAT(bytes.error().message, HasSubstr("--endian native"));
}

TEST(MeshFile, materialNamesSurviveWithoutMaterialScripts)
{
    const TestDirectory directory;
    const std::string path = directory.write("a.mesh", torusMesh(8));
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    OgreSession session;
    const Ogre::MeshPtr mesh = session.load(path).value();
    const Ogre::MeshPtr again = session.load(directory.write("b.mesh", meshBytes(*mesh, {}).value())).value();
    EXPECT_EQ(again->getSubMesh(0)->getMaterialName(), "Stone");
    EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
}

TEST(MeshFile, aSkeletonBesideTheMeshGoesAlong)
{
    const TestDirectory directory;
    directory.write("sub/x.skeleton", "bones");
    const std::string path = directory.write("torus.mesh", torusMesh(8, "sub/x.skeleton"));
    OgreSession session;
    std::vector<std::string> notes;
    const auto companions = findSkeleton(*session.load(path).value(), path, notes);
    ASSERT_EQ(companions.size(), 1u);
    EXPECT_THAT(notes, IsEmpty());
    ASSERT_TRUE(writeMeshFiles(directory / "out/torus.mesh", "mesh", companions, {Existing::Keep}));
    EXPECT_EQ(contentOf(directory / "out/sub/x.skeleton"), "bones");
    // The same content may come again, for another mesh; another content may not.
    EXPECT_TRUE(writeMeshFiles(directory / "out/second.mesh", "mesh", companions, {Existing::Keep}));
    directory.write("sub/x.skeleton", "other bones");
    EXPECT_FALSE(writeMeshFiles(directory / "out/third.mesh", "mesh", companions, {Existing::Keep}));
    EXPECT_FALSE(fs::exists(directory / "out/third.mesh"));
}

TEST(MeshFile, twoMeshesOfOneRunDoNotReplaceEachOthersSkeletons)
{
    const TestDirectory directory;
    directory.write("first/x.skeleton", "bones");
    directory.write("second/x.skeleton", "other bones");
    directory.write("out/x.skeleton", "bones of an earlier run");
    const Overwriting run{Existing::Replace, nextFileTime()};
    const std::vector<Companion> first{{directory / "first/x.skeleton", "x.skeleton"}};
    const std::vector<Companion> second{{directory / "second/x.skeleton", "x.skeleton"}};
    ASSERT_TRUE(writeMeshFiles(directory / "out/first.mesh", "mesh", first, run));
    const Result<Done> refused = writeMeshFiles(directory / "out/second.mesh", "mesh", second, run);
    ASSERT_FALSE(refused);
    EXPECT_THAT(describe(refused.error()), HasSubstr("out/x.skeleton: another mesh of this run"));
    EXPECT_EQ(contentOf(directory / "out/x.skeleton"), "bones");
    EXPECT_THAT(directory.files(), Not(Contains("out/second.mesh")));
}

TEST(MeshFile, skeletonNamesThatLeadOutsideAreLeftAlone)
{
    const TestDirectory directory;
    directory.write("outside.skeleton", "bones");
    directory.write("in/script.sh", "no skeleton");
    for (const std::string& name : {std::string("../outside.skeleton"), (directory / "outside.skeleton").string(),
                                    std::string("a/../../outside.skeleton"), std::string("script.sh")}) {
        const std::string path = directory.write("in/torus.mesh", torusMesh(8, name));
        OgreSession session;
        std::vector<std::string> notes;
        EXPECT_THAT(findSkeleton(*session.load(path).value(), path, notes), IsEmpty()) << name;
        EXPECT_THAT(notes, ElementsAre(HasSubstr(name)));
    }
}

TEST(MeshFile, nothingAppearsWhenACompanionIsMissing)
{
    const TestDirectory directory;
    EXPECT_FALSE(
        writeMeshFiles(directory / "out/x.mesh", "mesh", {{directory / "nothing", "nothing"}}, {Existing::Keep}));
    EXPECT_THAT(directory.files(), IsEmpty());
}

} // namespace lodsmith::cli
