#include "QueueFixture.h"

#include <support/TestDirectory.h>

#include <lodsmith/cache/LodCache.h>
#include <lodsmith/ogre/LodManager.h>

#include <OgreMeshSerializer.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

using testing::Each;
using testing::IsEmpty;
using testing::SizeIs;

using Levels = std::vector<std::vector<std::uint32_t>>;

constexpr std::uint64_t kRoomy = 1 << 24;
constexpr std::uint32_t kMeshes = 10;

/// Meshes, the levels that they get without a cache, and a directory for one.
class QueueCacheTest : public QueueTest {
protected:
    QueueCacheTest()
    {
        for (std::uint32_t i = 0; i < kMeshes; ++i) {
            const Ogre::MeshPtr mesh = sphere("mesh" + std::to_string(i), i);
            EXPECT_TRUE(ProgressiveMeshGenerator().generateLodLevels(settings(mesh)));
            mExpected.push_back(levelsOf(*mesh));
            mMeshes.push_back(mesh);
        }
        mGate.open();
    }

    static Ogre::MeshPtr sphere(const std::string& name, std::uint32_t number)
    {
        return makeOgreMesh(name, makeUvSphere(12 + 2 * number, 10 + number));
    }

    static LodConfig settings(const Ogre::MeshPtr& mesh) { return config(mesh, {0.5, 0.5, 0.8}); }

    /// As a program has it that has just been started.
    std::shared_ptr<LodCache> freshCache(std::uint64_t limit = kRoomy) const
    {
        return std::make_shared<LodCache>(mDirectory / "cache", limit);
    }

    void makeCachedQueue(unsigned count, std::shared_ptr<LodCache> cache)
    {
        QueueOptions options = workers(count);
        options.cache = std::move(cache);
        makeQueue(options);
        recordReports(*mQueue);
    }

    void recordReports(QueuedProgressiveMeshGenerator& queue)
    {
        queue.signals().injected.connect([this](const Ogre::MeshPtr& mesh, const LodReport& report) {
            mFromCache[mesh->getName()] = report.fromCache;
            mNotStored[mesh->getName()] = report.notStored.has_value();
        });
    }

    void queueAll(QueuedProgressiveMeshGenerator& queue) const
    {
        for (const Ogre::MeshPtr& mesh : mMeshes)
            ASSERT_TRUE(queue.generateLodLevels(settings(mesh)));
    }

    /// A start of a program: all meshes get their levels, and these are the right ones. How many came from the cache.
    std::size_t serveAll(std::uint64_t limit = kRoomy)
    {
        mFromCache.clear();
        makeCachedQueue(3, freshCache(limit));
        queueAll(*mQueue);
        finish();
        expectRightLevels();
        EXPECT_THAT(mFromCache, SizeIs(kMeshes));
        return static_cast<std::size_t>(
            std::count_if(mFromCache.begin(), mFromCache.end(), [](const auto& entry) { return entry.second; }));
    }

    void expectRightLevels() const
    {
        for (std::uint32_t i = 0; i < kMeshes; ++i) {
            EXPECT_THAT(brokenLevels(*mMeshes[i]), IsEmpty());
            EXPECT_EQ(levelsOf(*mMeshes[i]), mExpected[i]) << i;
        }
    }

    std::vector<fs::path> entries() const
    {
        std::vector<fs::path> paths;
        for (const std::string& name : mDirectory.files())
            paths.push_back(mDirectory / name);
        return paths;
    }

    std::uintmax_t entryBytes() const
    {
        std::uintmax_t bytes = 0;
        for (const fs::path& path : entries())
            bytes += fs::file_size(path);
        return bytes;
    }

    TestDirectory mDirectory;
    std::vector<Ogre::MeshPtr> mMeshes;
    std::vector<Levels> mExpected;
    std::map<std::string, bool> mFromCache, mNotStored; ///< by mesh, of the last queue
};

TEST_F(QueueCacheTest, TheSecondStartTakesTheSameLevelsFromTheCache)
{
    EXPECT_EQ(serveAll(), 0u);
    EXPECT_THAT(entries(), SizeIs(kMeshes));
    EXPECT_EQ(serveAll(), kMeshes);
    EXPECT_THAT(entries(), SizeIs(kMeshes));
}

TEST_F(QueueCacheTest, TheDirectGeneratorSharesItWithTheQueue)
{
    ASSERT_EQ(serveAll(), 0u);
    ProgressiveMeshGenerator generator(freshCache());
    const auto again = generator.generateLodLevels(settings(mMeshes[0]));
    ASSERT_TRUE(again);
    EXPECT_TRUE(again.value().fromCache);
    EXPECT_EQ(again.value().orderSeconds, 0.0);
    EXPECT_EQ(levelsOf(*mMeshes[0]), mExpected[0]);

    const auto other = generator.generateLodLevels(config(mMeshes[0], {0.4}));
    ASSERT_TRUE(other);
    EXPECT_FALSE(other.value().fromCache) << "other levels are other entries";
}

TEST_F(QueueCacheTest, TheReportIsTheSameWhereverTheLevelsComeFrom)
{
    ProgressiveMeshGenerator generator(freshCache());
    const LodReport made = generator.generateLodLevels(settings(mMeshes[3])).value(),
                    found = generator.generateLodLevels(settings(mMeshes[3])).value();
    EXPECT_FALSE(made.fromCache);
    EXPECT_TRUE(found.fromCache);
    EXPECT_EQ(found.vertices, made.vertices);
    EXPECT_EQ(found.bufferVertices, made.bufferVertices);
    EXPECT_EQ(found.radius, made.radius);
    EXPECT_EQ(found.notes, made.notes);
    ASSERT_EQ(found.levels.size(), made.levels.size());
    for (std::size_t i = 0; i < made.levels.size(); ++i) {
        EXPECT_EQ(found.levels[i].triangles, made.levels[i].triangles);
        EXPECT_EQ(found.levels[i].deviation, made.levels[i].deviation);
        EXPECT_EQ(found.levels[i].skipped, made.levels[i].skipped);
        EXPECT_EQ(found.levels[i].value, made.levels[i].value);
    }
}

TEST_F(QueueCacheTest, CopiesOfAMeshShareAnEntryWhateverTheirDistances)
{
    ProgressiveMeshGenerator generator(freshCache());
    ASSERT_TRUE(generator.generateLodLevels(settings(mMeshes[0])));
    const Ogre::MeshPtr copy = sphere("copy", 0);
    LodConfig far = settings(copy);
    for (LodLevel& level : far.levels)
        level.value *= 3;
    far.shareIndexBuffers = true;
    const auto report = generator.generateLodLevels(far);
    ASSERT_TRUE(report);
    EXPECT_TRUE(report.value().fromCache);
    EXPECT_EQ(copy->getLodLevel(1).userValue, 30);
    EXPECT_EQ(levelsOf(*copy), mExpected[0]);
}

TEST_F(QueueCacheTest, DamagedEntriesAreMadeAnew)
{
    ASSERT_EQ(serveAll(), 0u);
    std::size_t number = 0;
    for (const fs::path& path : entries()) {
        std::string bytes = contentOf(path);
        if (number++ % 2 == 0)
            bytes.resize(bytes.size() / 2);
        else
            bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x10);
        std::ofstream(path, std::ios::binary) << bytes;
    }
    EXPECT_EQ(serveAll(), 0u);
    EXPECT_EQ(serveAll(), kMeshes);
}

TEST_F(QueueCacheTest, WhereNothingCanBeStoredTheLevelsAreMadeAndTheReportSaysWhy)
{
    mDirectory.write("cache", "a file in the way");
    EXPECT_EQ(serveAll(), 0u);
    EXPECT_THAT(mEvents, Each(testing::StartsWith("injected ")));
    for (const auto& [name, notStored] : mNotStored)
        EXPECT_TRUE(notStored) << name;
    const auto report = ProgressiveMeshGenerator(freshCache()).generateLodLevels(settings(mMeshes[0]));
    ASSERT_TRUE(report);
    EXPECT_EQ(report.value().notStored->code, ErrorCode::Io);
}

TEST_F(QueueCacheTest, ACancelledRequestStoresNothing)
{
    Gate gate;
    QueueParts parts;
    parts.compute = gate.compute();
    QueueOptions options = workers(2);
    options.cache = freshCache();
    makeQueue(options, std::move(parts));
    queueAll(*mQueue);
    gate.waitForArrivals(2);
    mQueue->cancelAll();
    finish();
    gate.open();
    EXPECT_THAT(entries(), IsEmpty());
    enqueue(mMeshes[0]);
    finish();
    EXPECT_THAT(entries(), SizeIs(1)) << "of the one that was not cancelled";
}

TEST_F(QueueCacheTest, CancelsAndShutdownsAtAnyMomentLeaveWholeEntries)
{
    for (int delay = 0; delay < 40; ++delay) {
        makeCachedQueue(2, freshCache());
        queueAll(*mQueue);
        std::this_thread::sleep_for(std::chrono::microseconds(200 * delay));
        if (delay % 2 == 0)
            mQueue->cancelAll();
        else
            mQueue.reset();
    }
    const std::size_t stored = entries().size();
    for (const fs::path& path : entries())
        EXPECT_EQ(path.extension(), ".lodchain") << path;
    EXPECT_EQ(serveAll(), stored) << "each entry that is there is whole";
}

TEST_F(QueueCacheTest, TwoQueuesShareADirectoryThatIsTooSmallForBoth)
{
    serveAll();
    const std::uintmax_t limit = entryBytes() / 2;
    fs::remove_all(mDirectory / "cache");
    std::vector<Ogre::MeshPtr> copies;
    for (int round = 0; round < 3; ++round) {
        makeCachedQueue(2, freshCache(limit));
        QueueOptions options = workers(2);
        options.cache = freshCache(limit);
        QueuedProgressiveMeshGenerator other(options);
        queueAll(*mQueue);
        for (std::uint32_t i = 0; i < kMeshes; ++i) {
            copies.push_back(sphere("copy" + std::to_string(copies.size()), i));
            ASSERT_TRUE(other.generateLodLevels(settings(copies.back())));
        }
        finish();
        other.injector().finishAll();
        expectRightLevels();
        for (std::size_t i = 0; i < kMeshes; ++i)
            EXPECT_EQ(levelsOf(*copies[copies.size() - kMeshes + i]), mExpected[i]);
    }
    EXPECT_LE(entryBytes(), limit);
    EXPECT_GT(entryBytes(), 0u);
}

TEST_F(QueueCacheTest, TheProgramMayLetGoOfItFirst)
{
    std::shared_ptr<LodCache> cache = freshCache();
    const std::weak_ptr<LodCache> weak = cache;
    makeCachedQueue(2, std::move(cache));
    EXPECT_EQ(mQueue->cache(), weak.lock());
    queueAll(*mQueue);
    finish();
    mQueue.reset();
    EXPECT_TRUE(weak.expired());
    EXPECT_THAT(entries(), SizeIs(kMeshes));
}

TEST_F(QueueCacheTest, TheManagerUsesItForLevelsBesideHandMadeOnesToo)
{
    mMeshes[1]->removeLodLevels();
    Ogre::MeshSerializer().exportMesh(mMeshes[1].get(), (mSession.directory() / "box.mesh").string());
    std::ofstream(mSession.directory() / "saved0.loddef")
        << "<lod version='1'><automatic enabled='false'/><manual>"
           "<level distance='20'><value>0.5</value></level>"
           "<level distance='40'><meshName>box.mesh</meshName></level></manual></lod>";
    LodDefinitionManager definitions;
    makeCachedQueue(1, freshCache());
    const LodManager manager(definitions, *mQueue);
    const Ogre::MeshPtr source = sphere("source", 0);
    const Ogre::MeshPtr mesh = mSession.saveAndReload(source);
    EXPECT_EQ(mesh->getNumLodLevels(), 3) << "while it is loaded";
    EXPECT_THAT(entries(), SizeIs(1));
}

} // namespace
} // namespace lodsmith::test
