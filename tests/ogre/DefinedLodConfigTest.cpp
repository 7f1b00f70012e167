#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/DefinedLodConfig.h>
#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/MeshWriter.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreLodStrategy.h>
#include <OgreLogManager.h>
#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

LodDefinition manual(LodStrategy strategy = LodStrategy::DistanceSphere)
{
    LodDefinition definition;
    definition.automatic = false;
    definition.strategy = strategy;
    return definition;
}

LodLevelDefinition reduced(float value, LevelTarget::Kind kind = LevelTarget::Kind::Proportional, double amount = 0.5)
{
    return {value, {kind, amount}, "", ""};
}

LodLevelDefinition handMade(float value, const std::string& name)
{
    return {value, {}, name, ""};
}

class DefinedLodConfigTest : public testing::Test {
protected:
    DefinedLodConfig convert(const LodDefinition& definition, const std::string& name = "mesh.loddef")
    {
        auto defined = lodConfig(definition, mMesh, name);
        EXPECT_TRUE(defined) << describe(defined.error());
        return defined ? std::move(defined).value() : DefinedLodConfig();
    }

    static std::vector<Ogre::Real> values(const LodConfig& config)
    {
        std::vector<Ogre::Real> values;
        for (const LodLevel& level : config.levels)
            values.push_back(level.value);
        return values;
    }

    static Ogre::MeshPtr makeOther(const std::string& name) { return makeOgreMesh(name, makeTetrahedron()); }

    OgreSession mSession;
    Ogre::MeshPtr mMesh = makeOgreMesh("mesh", makeTwoMaterials(8, true), {true, false});
};

TEST_F(DefinedLodConfigTest, AnAutomaticDefinitionIsTheAutomaticConfiguration)
{
    LodDefinition definition;
    definition.levels.push_back(handMade(20.0f, "missing.mesh")); // waits
    const DefinedLodConfig defined = convert(definition);
    const LodConfig expected = automaticLodConfig(mMesh);
    EXPECT_EQ(defined.config.mesh, mMesh);
    EXPECT_EQ(defined.config.strategy, expected.strategy);
    EXPECT_EQ(defined.config.options.metric, expected.options.metric);
    EXPECT_EQ(defined.config.mostLevels, expected.mostLevels);
    EXPECT_EQ(values(defined.config), values(expected));
    EXPECT_THAT(defined.leftOut, IsEmpty());

    mMesh->_setBoundingSphereRadius(0);
    const auto refused = lodConfig(definition, mMesh);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::InvalidGeometry);
    EXPECT_EQ(refused.error().file, "mesh");
}

TEST_F(DefinedLodConfigTest, LevelsComeNearestFirst)
{
    for (const LodStrategy strategy : {LodStrategy::DistanceSphere, LodStrategy::DistanceBox, LodStrategy::PixelCount,
                                       LodStrategy::ScreenRatioPixelCount}) {
        LodDefinition definition = manual(strategy);
        definition.levels = {reduced(20.0f), reduced(60.0f), reduced(10.0f)};
        const LodConfig config = convert(definition).config;
        EXPECT_EQ(config.strategy, ogreName(strategy));
        if (strategy == LodStrategy::DistanceSphere || strategy == LodStrategy::DistanceBox)
            EXPECT_THAT(values(config), ElementsAre(10, 20, 60));
        else
            EXPECT_THAT(values(config), ElementsAre(60, 20, 10));
        const auto report = ProgressiveMeshGenerator().generateLodLevels(config);
        ASSERT_TRUE(report) << describe(report.error());
        EXPECT_EQ(mMesh->getLodStrategy()->getName(), ogreName(strategy));
        EXPECT_THAT(brokenLevels(*mMesh), IsEmpty());
    }
}

TEST_F(DefinedLodConfigTest, TargetsAndOptionsAreThoseOfTheDefinition)
{
    LodDefinition definition = manual();
    definition.levels = {reduced(1.0f, LevelTarget::Kind::Proportional, 0.25),
                         reduced(2.0f, LevelTarget::Kind::Constant, 7), reduced(3.0f, LevelTarget::Kind::Triangles, 12),
                         reduced(4.0f, LevelTarget::Kind::Deviation, 0.125),
                         reduced(5.0f, LevelTarget::Kind::CollapseCost, 3.5)};
    definition.lockBorders = true;
    const LodConfig config = convert(definition).config;
    ASSERT_EQ(config.levels.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(config.levels[i].target.kind, definition.levels[i].target.kind);
        EXPECT_EQ(config.levels[i].target.amount, definition.levels[i].target.amount);
        EXPECT_FALSE(config.levels[i].isManual());
    }
    EXPECT_EQ(config.options.metric, Metric::Curvature) << "what collapsecost is calibrated for";
    EXPECT_TRUE(config.options.lockBorders);

    definition.levels.pop_back();
    definition.weights.uv = 0.75f;
    definition.lockBorders = false;
    const LodConfig weighted = convert(definition).config;
    EXPECT_EQ(weighted.options.metric, Metric::Quadric);
    EXPECT_EQ(weighted.options.weights.uv, 0.75f);
    EXPECT_EQ(weighted.options.weights.normal, AttributeWeights().normal);
    EXPECT_FALSE(weighted.options.lockBorders);
}

TEST_F(DefinedLodConfigTest, NoLevelsMeanNone)
{
    ASSERT_TRUE(ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(mMesh));
    const DefinedLodConfig defined = convert(manual());
    EXPECT_THAT(defined.config.levels, IsEmpty());
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(defined.config));
    EXPECT_EQ(mMesh->getNumLodLevels(), 1);
}

TEST_F(DefinedLodConfigTest, HandMadeLevelsAreResourcesOrBesideTheDefinition)
{
    makeOther("box.mesh");
    makeOther("models/box.mesh");
    makeOther("models/far.mesh");
    makeOther("shared/flat.mesh");
    LodDefinition definition = manual();
    definition.levels = {handMade(10.0f, "box.mesh"), handMade(20.0f, "far.mesh"), reduced(30.0f),
                         handMade(40.0f, "../shared/flat.mesh"), handMade(50.0f, "./far.mesh")};
    const DefinedLodConfig defined = convert(definition, "models/tree.loddef");
    EXPECT_THAT(defined.leftOut, IsEmpty());
    ASSERT_EQ(defined.config.levels.size(), 5u);
    EXPECT_EQ(defined.config.levels[0].manualMeshName, "box.mesh") << "the resource name goes first";
    EXPECT_EQ(defined.config.levels[1].manualMeshName, "models/far.mesh");
    EXPECT_EQ(defined.config.levels[2].manualMeshName, "");
    EXPECT_EQ(defined.config.levels[3].manualMeshName, "shared/flat.mesh");
    EXPECT_EQ(defined.config.levels[4].manualMeshName, "models/far.mesh");
    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(defined.config));
    EXPECT_EQ(mMesh->getLodLevel(2).manualName, "models/far.mesh");
}

TEST_F(DefinedLodConfigTest, WithoutANameTheDefinitionIsTheMeshs)
{
    makeOther("dir/far.mesh");
    mMesh = makeOgreMesh("dir/mesh", makeGrid(4, 4));
    LodDefinition definition = manual();
    definition.levels = {handMade(10.0f, "far.mesh")};
    const DefinedLodConfig defined = convert(definition, "");
    ASSERT_EQ(defined.config.levels.size(), 1u);
    EXPECT_EQ(defined.config.levels[0].manualMeshName, "dir/far.mesh");
}

TEST_F(DefinedLodConfigTest, HandMadeLevelsAreLoadedFromTheMeshsGroupOnly)
{
    fs::create_directories(mSession.directory() / "dir");
    const Ogre::MeshPtr other = makeOther("only in General.mesh");
    Ogre::MeshSerializer().exportMesh(other.get(), (mSession.directory() / "far.mesh").string());
    mMesh = mSession.saveAndReload(mMesh);
    LodDefinition definition = manual();
    definition.levels = {handMade(10.0f, "far.mesh"), handMade(20.0f, "only in General.mesh")};
    const DefinedLodConfig defined = convert(definition, "mesh.loddef");
    ASSERT_EQ(defined.config.levels.size(), 1u);
    EXPECT_EQ(defined.config.levels[0].manualMeshName, "far.mesh");
    EXPECT_TRUE(Ogre::MeshManager::getSingleton().getByName("far.mesh", mSession.group())->isLoaded());
    ASSERT_EQ(defined.leftOut.size(), 1u);
    EXPECT_THAT(defined.leftOut[0].message, HasSubstr("only in General.mesh"));
}

TEST_F(DefinedLodConfigTest, WhatIsMissingIsNamedAndTheRestStays)
{
    std::ofstream(mSession.directory() / "broken.mesh") << "this is no mesh";
    mMesh = mSession.saveAndReload(mMesh);
    const Ogre::MeshPtr nested = makeOgreMesh("nested.mesh", makeGrid(8, 8));
    ASSERT_TRUE(ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(nested));
    ASSERT_GT(nested->getNumLodLevels(), 1);
    Ogre::MeshSerializer().exportMesh(nested.get(), (mSession.directory() / "nested.mesh").string());
    mSession.loadSaved("nested.mesh");

    LodDefinition definition = manual();
    definition.levels = {handMade(10.0f, "gone.mesh"), reduced(20.0f), handMade(30.0f, "broken.mesh"),
                         handMade(40.5f, "nested.mesh"), handMade(50.0f, mMesh->getName())};
    definition.subMeshes = {{1, 0.5f}, {7, 0.25f}};
    const DefinedLodConfig defined = convert(definition, "dir/tree.loddef");
    EXPECT_THAT(values(defined.config), ElementsAre(20));
    EXPECT_THAT(defined.config.subMeshImportance, ElementsAre(0.0f, 0.5f));
    ASSERT_EQ(defined.leftOut.size(), 5u);
    EXPECT_THAT(describe(defined.leftOut[0]),
                StartsWith("dir/tree.loddef: the level at 10 is left out: there is no mesh \"gone.mesh\""));
    EXPECT_THAT(defined.leftOut[0].message, HasSubstr("nor \"dir/gone.mesh\""));
    EXPECT_EQ(defined.leftOut[0].code, ErrorCode::NotFound);
    EXPECT_THAT(defined.leftOut[1].message, HasSubstr("the mesh \"broken.mesh\" cannot be loaded"));
    EXPECT_THAT(defined.leftOut[2].message,
                HasSubstr("the level at 40.5 is left out: the mesh \"nested.mesh\" has levels"));
    EXPECT_EQ(defined.leftOut[2].code, ErrorCode::Unsupported);
    EXPECT_THAT(defined.leftOut[3].message, HasSubstr("its own manual level"));
    EXPECT_THAT(defined.leftOut[4].message, HasSubstr("there is no submesh 7, the mesh has 2"));

    ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(defined.config));
    EXPECT_EQ(mMesh->getNumLodLevels(), 2);
    EXPECT_THAT(brokenLevels(*mMesh), IsEmpty());
}

TEST_F(DefinedLodConfigTest, ADefinitionWithErrorsIsRefused)
{
    LodDefinition definition = manual();
    definition.levels = {reduced(10.0f), reduced(10.0f)};
    const auto refused = lodConfig(definition, mMesh, "tree.loddef");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::InvalidSetting);
    EXPECT_EQ(refused.error().file, "tree.loddef");
}

// The example of docs/runtime.md.
void giveLevels(const Ogre::MeshPtr& mesh, lodsmith::LodDefinitionManager& definitions)
{
    auto& log = Ogre::LogManager::getSingleton();
    const auto resource = definitions.definitionFor(*mesh);
    if (resource && !resource->definition())
        return; // a file with errors, which are in the log
    const auto defined = lodsmith::lodConfig(resource ? *resource->definition() : lodsmith::LodDefinition(), mesh);
    if (!defined)
        return log.logError(lodsmith::describe(defined.error()));
    for (const lodsmith::Error& error : defined.value().leftOut)
        log.logWarning(lodsmith::describe(error));
    const auto report = lodsmith::ProgressiveMeshGenerator().generateLodLevels(defined.value().config);
    if (!report)
        log.logError(lodsmith::describe(report.error()));
}

TEST_F(DefinedLodConfigTest, FromFileToLevels)
{
    LodDefinitionManager definitions;
    LodDefinition definition = manual();
    definition.levels = {reduced(20.0f, LevelTarget::Kind::Triangles, 90), handMade(50.0f, "gone.mesh")};
    definition.subMeshes = {{0, 1.0f}};
    mMesh = mSession.saveAndReload(mMesh);
    giveLevels(mMesh, definitions);
    EXPECT_EQ(mMesh->getLodStrategy()->getName(), "pixel_count") << "without a definition levels are automatic";

    const auto path = LodDefinitionManager::exportScript(mMesh->getName(), definition, mSession.directory());
    ASSERT_TRUE(path);
    const Ogre::MeshPtr mesh = mSession.loadSaved(mMesh->getName());
    giveLevels(mesh, definitions);
    EXPECT_EQ(mesh->getLodStrategy()->getName(), "distance_sphere");
    EXPECT_EQ(mesh->getNumLodLevels(), 2);
    EXPECT_EQ(mesh->getSubMesh(0)->mLodFaceList[0]->indexCount, mesh->getSubMesh(0)->indexData->indexCount);
    EXPECT_LT(mesh->getSubMesh(1)->mLodFaceList[0]->indexCount, mesh->getSubMesh(1)->indexData->indexCount);

    std::ofstream(path.value()) << "<lod><automatic enabled='no'/></lod>";
    definitions.definitionFor(*mesh)->reload();
    MeshWriter::removeLevels(*mesh);
    giveLevels(mesh, definitions);
    EXPECT_EQ(mesh->getNumLodLevels(), 1) << "a file with errors is not taken for none";
}

} // namespace
} // namespace lodsmith::test
