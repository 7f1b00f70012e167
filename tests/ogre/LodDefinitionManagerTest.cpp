#include <support/OgreLog.h>
#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/core/Assert.h>
#include <lodsmith/ogre/LodDefinitionManager.h>

#include <OgreDataStream.h>
#include <OgreException.h>
#include <OgreMeshManager.h>
#include <OgreMeshSerializer.h>
#include <OgreResourceGroupManager.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string levelAt(const std::string& distance)
{
    return "<lod><automatic enabled='false'/><manual><level distance='" + distance + "'/></manual></lod>";
}

/// The only level's value; 0 for anything else.
float onlyLevel(const LodDefinitionResourcePtr& resource)
{
    const LodDefinition* definition = resource ? resource->definition() : nullptr;
    return definition && definition->levels.size() == 1 ? definition->levels[0].value : 0.0f;
}

class LodDefinitionManagerTest : public testing::Test {
protected:
    /// A group of its own directory below the session's, with the files that are there by now.
    std::string addGroup(const std::string& name, bool inGlobalPool = false)
    {
        fs::create_directories(mSession.directory() / name);
        mGroups.createResourceGroup(name, inGlobalPool);
        mGroups.addResourceLocation((mSession.directory() / name).string(), "FileSystem", name, true, false);
        mGroups.initialiseResourceGroup(name);
        return name;
    }

    void write(const std::string& name, const std::string& content) const
    {
        const fs::path path = mSession.directory() / name;
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << content;
    }

    static Ogre::MeshPtr makeMesh(const std::string& name, const std::string& group)
    {
        return Ogre::MeshManager::getSingleton().createManual(name, group);
    }

    LodDefinitionResourcePtr definitionFor(const std::string& name, const std::string& group)
    {
        return mManager->definitionFor(*makeMesh(name, group));
    }

    LodDefinitionResourcePtr find(const std::string& name, const std::string& group)
    {
        return std::static_pointer_cast<LodDefinitionResource>(mManager->getResourceByName(name, group));
    }

    OgreSession mSession;
    Ogre::ResourceGroupManager& mGroups = Ogre::ResourceGroupManager::getSingleton();
    std::unique_ptr<LodDefinitionManager> mManager = std::make_unique<LodDefinitionManager>();
};

TEST_F(LodDefinitionManagerTest, InitialisingAGroupFindsItsFilesAndReadsNone)
{
    write("a/tree.loddef", levelAt("20"));
    write("a/deep/er/house.b.loddef", levelAt("30"));
    write("a/broken.loddef", "<lod");
    const OgreLog log;
    addGroup("a");
    for (const char* name : {"tree.loddef", "deep/er/house.b.loddef", "broken.loddef"}) {
        ASSERT_TRUE(find(name, "a")) << name;
        EXPECT_FALSE(find(name, "a")->isLoaded());
        EXPECT_EQ(find(name, "a")->definition(), nullptr);
        EXPECT_THAT(find(name, "a")->errors(), IsEmpty());
    }
    EXPECT_THAT(log.lines(), Not(Contains(HasSubstr("broken.loddef:1"))));
}

TEST_F(LodDefinitionManagerTest, LoadingReadsTheFile)
{
    write("a/tree.loddef", levelAt("20"));
    addGroup("a");
    const LodDefinitionResourcePtr resource = find("tree.loddef", "a");
    ASSERT_TRUE(resource);
    resource->load();
    EXPECT_EQ(onlyLevel(resource), 20.0f);
    EXPECT_EQ(resource->definition()->original, levelAt("20"));
    EXPECT_GT(resource->getSize(), levelAt("20").size());
    EXPECT_EQ(mManager->getMemoryUsage(), resource->getSize());
    resource->unload();
    EXPECT_EQ(resource->definition(), nullptr);
    EXPECT_EQ(mManager->getMemoryUsage(), 0u);
}

TEST_F(LodDefinitionManagerTest, ReloadingReadsTheFileAgain)
{
    write("a/tree.loddef", levelAt("20"));
    addGroup("a");
    const LodDefinitionResourcePtr resource = definitionFor("tree.mesh", "a");
    const std::size_t state = resource->getStateCount();
    write("a/tree.loddef", levelAt("40"));
    EXPECT_EQ(onlyLevel(resource), 20.0f);
    resource->reload();
    EXPECT_EQ(onlyLevel(resource), 40.0f);
    EXPECT_GT(resource->getStateCount(), state);
    write("a/tree.loddef", "<lod><manual><level/></manual></lod>");
    resource->reload();
    EXPECT_EQ(resource->definition(), nullptr) << "the old one must not go on";
    write("a/tree.loddef", levelAt("60"));
    resource->reload();
    EXPECT_EQ(onlyLevel(resource), 60.0f) << "a mended file is read as any other";
    EXPECT_THAT(resource->errors(), IsEmpty());
    write("a/tree.loddef", levelAt("80"));
    mGroups.unloadResourceGroup("a");
    mGroups.loadResourceGroup("a");
    EXPECT_EQ(onlyLevel(resource), 80.0f);
}

TEST_F(LodDefinitionManagerTest, ErrorsAreLoggedWithFileAndLineAndThereIsNoDefinition)
{
    write("a/dir/tree.loddef", "<lod>\n<automatic enabled='no'/>\n<manual><level/></manual></lod>");
    addGroup("a");
    const OgreLog log;
    const LodDefinitionResourcePtr resource = definitionFor("dir/tree.mesh", "a");
    ASSERT_TRUE(resource);
    EXPECT_TRUE(resource->isLoaded());
    EXPECT_EQ(resource->definition(), nullptr);
    ASSERT_EQ(resource->errors().size(), 2u);
    EXPECT_EQ(resource->errors()[0].line, 2);
    EXPECT_EQ(resource->errors()[1].line, 3);
    EXPECT_THAT(log.lines(), Contains(HasSubstr("dir/tree.loddef:2: enabled is 'no'")));
    EXPECT_THAT(log.lines(), Contains(HasSubstr("dir/tree.loddef:3: ")));
}

TEST_F(LodDefinitionManagerTest, WarningsAreLoggedAndTheDefinitionStands)
{
    write("a/tree.loddef", "<lod>\n<history/></lod>");
    addGroup("a");
    const OgreLog log;
    EXPECT_TRUE(definitionFor("tree.mesh", "a")->definition()->automatic);
    EXPECT_THAT(log.lines(), Contains(HasSubstr("tree.loddef:2: <history>")));
}

TEST_F(LodDefinitionManagerTest, TooLargeAFileIsAnError)
{
    write("a/tree.loddef", levelAt("20"));
    fs::resize_file(mSession.directory() / "a/tree.loddef", std::uintmax_t(1) << 36);
    addGroup("a");
    const LodDefinitionResourcePtr resource = definitionFor("tree.mesh", "a");
    ASSERT_TRUE(resource);
    EXPECT_EQ(resource->definition(), nullptr);
    ASSERT_EQ(resource->errors().size(), 1u);
    EXPECT_THAT(resource->errors()[0].message, HasSubstr("larger than 1048576 bytes"));
}

TEST_F(LodDefinitionManagerTest, AnEmptyFileIsAnError)
{
    write("a/tree.loddef", "");
    addGroup("a");
    EXPECT_EQ(definitionFor("tree.mesh", "a")->errors().size(), 1u);
}

TEST_F(LodDefinitionManagerTest, AMeshHasTheDefinitionOfItsGroupAndNoOther)
{
    write("a/tree.loddef", levelAt("20"));
    write("b/tree.loddef", levelAt("30"));
    for (const char* group : {"a", "b", "c"})
        addGroup(group);
    EXPECT_EQ(onlyLevel(definitionFor("tree.mesh", "a")), 20.0f);
    EXPECT_EQ(onlyLevel(definitionFor("tree.mesh", "b")), 30.0f);
    EXPECT_EQ(definitionFor("tree.mesh", "c"), nullptr);
    EXPECT_EQ(definitionFor("tree.mesh", Ogre::RGN_AUTODETECT), nullptr);
}

TEST_F(LodDefinitionManagerTest, InTheGlobalPoolNoGroupTakesTheDefinitionOfAnother)
{
    write("a/tree.loddef", levelAt("20"));
    write("b/tree.loddef", levelAt("30"));
    for (const char* group : {"a", "b", "c"})
        addGroup(group, true);
    EXPECT_EQ(onlyLevel(definitionFor("tree.mesh", "a")), 20.0f);
    Ogre::MeshManager::getSingleton().removeAll();
    EXPECT_EQ(definitionFor("tree.mesh", "c"), nullptr);
    Ogre::MeshManager::getSingleton().removeAll();
    const OgreLog log;
    EXPECT_EQ(definitionFor("tree.mesh", "b"), nullptr) << "OGRE has room for one of that name";
    EXPECT_THAT(log.lines(), Contains(AllOf(HasSubstr("tree.loddef"), HasSubstr("already exists"))));
}

TEST_F(LodDefinitionManagerTest, NamesAreThoseOfLoddefFileNameAlone)
{
    for (const char* name : {"tree.loddef", "dir/tree.loddef", "dir/a.b.loddef", "none.mesh.loddef"})
        write(std::string("a/") + name, levelAt("20"));
    addGroup("a");
    EXPECT_TRUE(definitionFor("tree.mesh", "a"));
    EXPECT_TRUE(definitionFor("tree", "a"));
    EXPECT_TRUE(definitionFor("dir/a.b.mesh", "a"));
    EXPECT_EQ(definitionFor("other/tree.mesh", "a"), nullptr) << "directories count";
    EXPECT_EQ(definitionFor("dir\\tree.mesh", "a"), nullptr);
    EXPECT_EQ(definitionFor("none.mesh", "a"), nullptr);
    EXPECT_EQ(definitionFor("dir/", "a"), nullptr);
}

TEST_F(LodDefinitionManagerTest, FilesThatComeLaterAreFoundOnceTheGroupKnowsThem)
{
    addGroup("a");
    const Ogre::MeshPtr mesh = makeMesh("tree.mesh", "a");
    EXPECT_EQ(mManager->definitionFor(*mesh), nullptr);
    const std::string text = levelAt("20");
    const Ogre::DataStreamPtr stream = mGroups.createResource("tree.loddef", "a");
    stream->write(text.data(), text.size());
    stream->close();
    EXPECT_EQ(onlyLevel(mManager->definitionFor(*mesh)), 20.0f);

    write("more/house.loddef", levelAt("30"));
    mGroups.addResourceLocation((mSession.directory() / "more").string(), "FileSystem", "a");
    EXPECT_EQ(onlyLevel(definitionFor("house.mesh", "a")), 30.0f);
}

TEST_F(LodDefinitionManagerTest, DeclaredFilesAreMadeOnce)
{
    write("a/tree.loddef", levelAt("20"));
    write("a/other.def", levelAt("30"));
    mGroups.createResourceGroup("a");
    mGroups.addResourceLocation((mSession.directory() / "a").string(), "FileSystem", "a");
    mGroups.declareResource("tree.loddef", "LodDefinition", "a");
    mGroups.declareResource("other.def", "LodDefinition", "a");
    mGroups.initialiseResourceGroup("a");
    ASSERT_TRUE(find("other.def", "a")) << "declared under any name";
    mGroups.loadResourceGroup("a");
    EXPECT_EQ(onlyLevel(find("other.def", "a")), 30.0f);
    EXPECT_EQ(onlyLevel(definitionFor("tree.mesh", "a")), 20.0f);
}

TEST_F(LodDefinitionManagerTest, AGroupLoadsItsDefinitionsAfterItsMeshesAndTakesThemAwayWhenCleared)
{
    EXPECT_GT(mManager->getLoadingOrder(), Ogre::MeshManager::getSingleton().getLoadingOrder());
    write("a/tree.loddef", levelAt("20"));
    addGroup("a");
    mGroups.loadResourceGroup("a");
    EXPECT_TRUE(find("tree.loddef", "a")->isLoaded());
    mGroups.unloadResourceGroup("a");
    EXPECT_FALSE(find("tree.loddef", "a")->isLoaded());
    mGroups.clearResourceGroup("a");
    EXPECT_FALSE(find("tree.loddef", "a"));
    EXPECT_EQ(mManager->getMemoryUsage(), 0u);
    mGroups.initialiseResourceGroup("a");
    EXPECT_TRUE(find("tree.loddef", "a"));
    mGroups.destroyResourceGroup("a");
}

TEST_F(LodDefinitionManagerTest, AFileThatIsGoneIsNoDefinition)
{
    write("a/tree.loddef", levelAt("20"));
    addGroup("a");
    fs::remove(mSession.directory() / "a/tree.loddef");
    const OgreLog log;
    EXPECT_EQ(definitionFor("tree.mesh", "a"), nullptr);
    EXPECT_THAT(log.lines(), Contains(HasSubstr("tree.loddef: ")));
    EXPECT_FALSE(find("tree.loddef", "a")->isLoaded());
    EXPECT_THROW(find("tree.loddef", "a")->load(), Ogre::Exception) << "as every resource";
}

TEST_F(LodDefinitionManagerTest, MeshesOfFilesHaveDefinitionsToo)
{
    Ogre::MeshSerializer().exportMesh(makeOgreMesh("grid", makeGrid(2, 2)).get(),
                                      (mSession.directory() / "tree.mesh").string());
    write("tree.loddef", levelAt("20"));
    const Ogre::MeshPtr mesh = mSession.loadSaved("tree.mesh");
    EXPECT_EQ(onlyLevel(mManager->definitionFor(*mesh)), 20.0f) << "the group was initialised before the manager was";
}

/// A definition that comes from nowhere.
class FromMemory : public Ogre::ManualResourceLoader {
public:
    void loadResource(Ogre::Resource* resource) override
    {
        LodDefinition definition;
        definition.automatic = false;
        definition.levels.push_back({70.0f, {}, "", ""});
        static_cast<LodDefinitionResource*>(resource)->setDefinition(definition);
    }
};

TEST_F(LodDefinitionManagerTest, ManualLoadersSetTheDefinition)
{
    FromMemory loader;
    addGroup("a");
    mManager->createResource("tree.loddef", "a", true, &loader);
    const LodDefinitionResourcePtr resource = definitionFor("tree.mesh", "a");
    EXPECT_EQ(onlyLevel(resource), 70.0f);
    resource->reload();
    EXPECT_EQ(onlyLevel(resource), 70.0f);
    mManager->removeAll();
}

TEST_F(LodDefinitionManagerTest, ASetDefinitionLastsUntilTheFileIsReadAgain)
{
    write("a/tree.loddef", levelAt("20"));
    addGroup("a");
    const LodDefinitionResourcePtr resource = definitionFor("tree.mesh", "a");
    const std::size_t state = resource->getStateCount();
    LodDefinition edited = *resource->definition();
    edited.levels[0].value = 25.0f;
    resource->setDefinition(edited);
    EXPECT_EQ(onlyLevel(resource), 25.0f);
    EXPECT_GT(resource->getStateCount(), state);
    resource->reload();
    EXPECT_EQ(onlyLevel(resource), 20.0f);
}

TEST_F(LodDefinitionManagerTest, MisuseIsAnAssert)
{
    write("a/tree.loddef", levelAt("20"));
    addGroup("a");
    const LodDefinitionResourcePtr resource = definitionFor("tree.mesh", "a");
    LodDefinition wrong = *resource->definition();
    wrong.levels[0].value = -1.0f;
    const AssertHandler before =
        setAssertHandler([](const char*, const char* message, const char*, int) { throw std::logic_error(message); });
    EXPECT_THROW(resource->setDefinition(wrong), std::logic_error);
    EXPECT_THROW(LodDefinitionManager(), std::logic_error) << "there is one already";
    setAssertHandler(before);
    EXPECT_EQ(onlyLevel(resource), 20.0f);
}

TEST_F(LodDefinitionManagerTest, ComesAndGoes)
{
    write("a/tree.loddef", levelAt("20"));
    addGroup("a");
    definitionFor("tree.mesh", "a");
    mManager.reset();
    mGroups.clearResourceGroup("a");
    mGroups.initialiseResourceGroup("a");
    mManager = std::make_unique<LodDefinitionManager>();
    EXPECT_EQ(onlyLevel(definitionFor("tree.mesh", "a")), 20.0f);
}

TEST_F(LodDefinitionManagerTest, WhatIsSavedForAMeshIsFoundByItsGroup)
{
    const Ogre::MeshPtr mesh = mSession.saveAndReload(makeOgreMesh("ball", makeIcosphere(1)));
    EXPECT_FALSE(mManager->definitionFor(*mesh));
    const fs::path place = mSession.directory() / "saved0.loddef";
    EXPECT_EQ(LodDefinitionManager::pathFor(*mesh).value(), place);
    EXPECT_FALSE(fs::exists(place));

    LodDefinition definition;
    definition.automatic = false;
    definition.levels.resize(1);
    for (const float value : {10.0f, 20.0f}) {
        definition.levels[0].value = value;
        EXPECT_EQ(mManager->save(*mesh, definition).value(), place);
        EXPECT_EQ(onlyLevel(mManager->definitionFor(*mesh)), value) << "also when an earlier one was loaded";
    }
    EXPECT_EQ(LodDefinitionManager::pathFor(*mesh).value(), place);
}

TEST_F(LodDefinitionManagerTest, ADefinitionIsSavedWhereItIs)
{
    const Ogre::MeshPtr mesh = mSession.saveAndReload(makeOgreMesh("ball", makeIcosphere(1)));
    fs::create_directories(mSession.directory() / "definitions");
    std::ofstream(mSession.directory() / "definitions" / "saved0.loddef") << levelAt("5");
    mGroups.addResourceLocation((mSession.directory() / "definitions").string(), "FileSystem", mSession.group());
    EXPECT_EQ(onlyLevel(mManager->definitionFor(*mesh)), 5.0f);
    LodDefinition definition;
    definition.automatic = false;
    definition.levels.resize(1);
    definition.levels[0].value = 6.0f;
    EXPECT_EQ(mManager->save(*mesh, definition).value(), mSession.directory() / "definitions" / "saved0.loddef");
    EXPECT_EQ(onlyLevel(mManager->definitionFor(*mesh)), 6.0f);
    EXPECT_FALSE(fs::exists(mSession.directory() / "saved0.loddef"));
}

TEST_F(LodDefinitionManagerTest, GroupsThatShareADirectoryGoOnAfterASave)
{
    const Ogre::MeshPtr mesh = mSession.saveAndReload(makeOgreMesh("ball", makeIcosphere(1)));
    mGroups.createResourceGroup("other", false);
    mGroups.addResourceLocation(mSession.directory().string(), "FileSystem", "other");
    LodDefinition definition;
    definition.automatic = false;
    definition.levels.resize(1);
    definition.levels[0].value = 6.0f;
    ASSERT_TRUE(mManager->save(*mesh, definition).ok());
    EXPECT_TRUE(mGroups.resourceExists("other", "saved0.mesh"));
    EXPECT_EQ(mGroups.openResource("saved0.mesh", "other")->size(),
              fs::file_size(mSession.directory() / "saved0.mesh"));
}

TEST_F(LodDefinitionManagerTest, WhatCannotBeSavedIsAnError)
{
    const Ogre::MeshPtr byHand = makeOgreMesh("ball", makeIcosphere(1));
    EXPECT_EQ(mManager->save(*byHand, {}).error().code, ErrorCode::Unsupported);
    const Ogre::MeshPtr mesh = mSession.saveAndReload(byHand);
    LodDefinition wrong;
    wrong.levels.resize(1);
    EXPECT_EQ(mManager->save(*mesh, wrong).error().code, ErrorCode::InvalidSetting);
    EXPECT_FALSE(fs::exists(mSession.directory() / "saved0.loddef"));
}

} // namespace
} // namespace lodsmith::test
