#include "CommandLine.h"
#include "OgreSession.h"
#include "SampleFiles.h"

#include <lodsmith/ogre/MeshReader.h>

#include <OgreSubMesh.h>

#include <gmock/gmock.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using lodsmith::test::TestDirectory;
using test::Outcome;
using test::runLodsmith;
using testing::HasSubstr;

/// Two nodes that show one triangle: moved by (10, 0, 0), and mirrored in x. The triangle faces +z.
constexpr const char* kTwoNodes = R"({
  "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
  "nodes": [{"mesh": 0, "translation": [10, 0, 0]}, {"mesh": 0, "scale": [-1, 1, 1]}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
  "materials": [{"name": "Leaf"}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0,0,0], "max": [1,1,0]},
                {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
  "buffers": [{"byteLength": 42,
               "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"}]
})";

float corner(const MeshView& view, std::size_t subMesh, std::size_t index, int axis)
{
    const SubMeshView& triangles = view.subMeshes[subMesh];
    float position[3];
    view.vertexBuffers[triangles.vertexBuffer].positions.read(triangles.index(index), 3, position);
    return position[axis];
}

} // namespace

TEST(ImportCommand, anObjBecomesAMeshBesideIt)
{
    const TestDirectory directory;
    const std::string model = directory.write("torus.obj", test::torusObj(12));
    const Outcome outcome = runLodsmith({"import", model});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("1 submeshes, 169 vertices, 288 triangles"));
    OgreSession session;
    const Ogre::MeshPtr mesh = session.load(directory / "torus.mesh").value();
    EXPECT_EQ(mesh->getSubMesh(0)->getMaterialName(), "Stone");
    EXPECT_NEAR(mesh->getBoundingSphereRadius(), 3.0f, 1e-5f);
    EXPECT_EQ(mesh->getSubMesh(0)->indexData->indexBuffer->getType(), Ogre::HardwareIndexBuffer::IT_16BIT);
}

TEST(ImportCommand, manyVerticesGetWideIndices)
{
    const TestDirectory directory;
    ASSERT_EQ(runLodsmith({"import", directory.write("torus.obj", test::torusObj(260))}).exitCode, 0);
    OgreSession session;
    const Ogre::MeshPtr mesh = session.load(directory / "torus.mesh").value();
    EXPECT_EQ(mesh->getSubMesh(0)->vertexData->vertexCount, 261u * 261u);
    EXPECT_EQ(mesh->getSubMesh(0)->indexData->indexBuffer->getType(), Ogre::HardwareIndexBuffer::IT_32BIT);
}

TEST(ImportCommand, nodesAreAppliedAndMirroredOnesKeepTheirFront)
{
    const TestDirectory directory;
    const std::string model = directory.write("two.gltf", kTwoNodes);
    const Outcome outcome = runLodsmith({"import", model, "-o", (directory / "out/").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    OgreSession session;
    const Ogre::MeshPtr mesh = session.load(directory / "out/two.mesh").value();
    ASSERT_EQ(mesh->getNumSubMeshes(), 2);
    EXPECT_EQ(mesh->getSubMesh(0)->getMaterialName(), "Leaf");
    const MeshData data = MeshReader::read(*mesh).value();
    EXPECT_EQ(corner(data.view(), 0, 0, 0), 10.0f);
    for (std::size_t subMesh = 0; subMesh < 2; ++subMesh) {
        const auto at = [&](std::size_t index, int axis) { return corner(data.view(), subMesh, index, axis); };
        const float area =
            (at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) - (at(1, 1) - at(0, 1)) * (at(2, 0) - at(0, 0));
        EXPECT_EQ(area, 1.0f) << "twice the triangle's area, positive when it faces +z";
    }
}

TEST(ImportCommand, modelsWithoutTrianglesAndWhatIsNoModelAreRefused)
{
    const TestDirectory directory;
    const std::pair<std::string, std::string> wrong[] = {
        {directory.write("points.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), ""},
        {directory.write("text.obj", "hello\n"), ""},
        {directory.write("odd.xyzzy", "hello\n"), "cannot be imported"},
        {directory.write("broken.gltf", "{"), "cannot be imported"},
        {(directory / "gone.obj").string(), "no such file"},
        {directory.path().string(), "is no regular file"},
    };
    for (const auto& [model, complaint] : wrong) {
        const Outcome outcome = runLodsmith({"import", model, "-o", (directory / "out.mesh").string()});
        EXPECT_EQ(outcome.exitCode, 1) << model;
        EXPECT_THAT(outcome.err, HasSubstr("lodsmith: " + model + ": " + complaint));
        EXPECT_FALSE(fs::exists(directory / "out.mesh"));
    }
}

TEST(ImportCommand, nothingIsOverwrittenWithoutForce)
{
    const TestDirectory directory;
    const std::string model = directory.write("torus.obj", test::torusObj(8));
    directory.write("torus.mesh", "precious");
    EXPECT_EQ(runLodsmith({"import", model}).exitCode, 1);
    EXPECT_EQ(lodsmith::test::contentOf(directory / "torus.mesh"), "precious");
    EXPECT_EQ(runLodsmith({"import", model, "--force"}).exitCode, 0);
}

TEST(ImportCommand, whatIsImportedCanBeSimplified)
{
    const TestDirectory directory;
    const std::string mesh = (directory / "torus.mesh").string();
    ASSERT_EQ(runLodsmith({"import", directory.write("torus.obj", test::torusObj(12))}).exitCode, 0);
    EXPECT_EQ(
        runLodsmith({"generate", mesh, "-o", (directory / "lod.mesh").string(), "--levels", "9:triangles:50"}).exitCode,
        0);
}

} // namespace lodsmith::cli
