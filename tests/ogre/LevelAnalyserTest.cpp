#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/analysis/SurfaceDistances.h>
#include <lodsmith/ogre/LevelAnalyser.h>
#include <lodsmith/ogre/LevelReader.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreMeshManager.h>
#include <OgreRoot.h>
#include <OgreSubMesh.h>

#include <gmock/gmock.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

namespace lodsmith::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Distances = std::vector<std::vector<float>>;
using Points = std::vector<LevelPoint>;
using JobPtr = LevelAnalyser::JobPtr;

DeviationOptions fewSamples()
{
    DeviationOptions options;
    options.samples = 2000;
    return options;
}

bool sameBits(const DeviationFigures& a, const DeviationFigures& b)
{
    return a.mean == b.mean && a.rms == b.rms && a.maximum == b.maximum;
}

/// An analyser and a record of what came of its jobs: "NAME", or "NAME: CODE".
class BackgroundAnalysisTest : public testing::Test {
protected:
    static void generate(const Ogre::MeshPtr& mesh, const std::vector<double>& removed)
    {
        ASSERT_TRUE(ProgressiveMeshGenerator().generateLodLevels(proportional(mesh, removed)));
    }

    static Ogre::MeshPtr withLevels(const std::string& name, const TestMesh& source = makeUvSphere(24, 16))
    {
        const Ogre::MeshPtr mesh = makeOgreMesh(name, source);
        generate(mesh, {0.5, 0.8});
        return mesh;
    }

    Ogre::MeshPtr fileWithLevels() { return mSession.saveAndReload(withLevels("source" + std::to_string(mSources++))); }

    /// A job whose end is recorded under the mesh's name.
    JobPtr measure(const Ogre::MeshPtr& mesh, unsigned level = 1, std::function<void()> then = {})
    {
        const std::string name = mesh->getName();
        auto done = [this, name, then = std::move(then)](const Result<Deviation>& deviation) {
            mEvents.push_back(deviation ? name : name + ": " + toString(deviation.error().code));
            if (then)
                then();
        };
        return mAnalyser->measure(mesh, level, done, fewSamples()).value();
    }

    void finish() { mAnalyser->finishAll(); }

    static void frame()
    {
        Ogre::FrameEvent event{};
        Ogre::Root::getSingleton()._fireFrameStarted(event);
    }

    static LevelData read(const Ogre::MeshPtr& mesh, unsigned level)
    {
        return LevelReader::read(*mesh, LevelReader::readLevelZero(*mesh).value(), level).value();
    }

    static Deviation directly(const Ogre::MeshPtr& mesh, unsigned level)
    {
        return measureDeviation(read(mesh, 0).view(), read(mesh, level).view(), fewSamples()).value();
    }

    /// What a job says about a level's surface.
    DeviationFigures surfaceOf(const Ogre::MeshPtr& mesh, unsigned level)
    {
        DeviationFigures figures;
        const auto job = mAnalyser->measure(
            mesh, level, [&](const Result<Deviation>& deviation) { figures = deviation.value().surface; },
            fewSamples());
        EXPECT_TRUE(job);
        finish();
        return figures;
    }

    OgreSession mSession;
    int mSources = 0;
    std::vector<std::string> mEvents;
    std::unique_ptr<LevelAnalyser> mAnalyser = std::make_unique<LevelAnalyser>();
};

TEST_F(BackgroundAnalysisTest, MeasuresAsMeasuringDirectlyDoes)
{
    const Ogre::MeshPtr mesh = withLevels("mesh");
    for (const unsigned level : {0u, 1u, 2u})
        EXPECT_TRUE(sameBits(surfaceOf(mesh, level), directly(mesh, level).surface)) << level;
    EXPECT_GT(surfaceOf(mesh, 2).mean, surfaceOf(mesh, 1).mean);
}

TEST_F(BackgroundAnalysisTest, DistancesAreThoseOfTheOriginalsVertices)
{
    const Ogre::MeshPtr mesh = withLevels("mesh", makeTwoMaterials(10, false));
    Distances distances;
    const auto job =
        mAnalyser->distances(mesh, 2, [&](const Result<Distances>& result) { distances = result.value(); });
    ASSERT_TRUE(job);
    finish();
    ASSERT_EQ(distances.size(), 2u);
    EXPECT_EQ(distances[0].size(), mesh->getSubMesh(0)->vertexData->vertexCount);
    EXPECT_EQ(distances, surfaceDistances(read(mesh, 0).view(), read(mesh, 2).view()).value());
}

TEST_F(BackgroundAnalysisTest, CurvePointsAreWhatLevelsOfThatCountAre)
{
    const Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(40, 30));
    Points points;
    LodConfig config;
    config.mesh = mesh;
    config.options.metric = Metric::Curvature;
    const auto job =
        mAnalyser->curve(mesh, config.options, 8, [&](const Result<Points>& result) { points = result.value(); });
    ASSERT_TRUE(job);
    finish();
    ASSERT_GE(points.size(), 5u);
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_LT(points[i].triangles, points[i - 1].triangles);
        EXPECT_GE(points[i].deviation, points[i - 1].deviation);
        config.levels.push_back({Ogre::Real(10 * i), {LevelTarget::Kind::Triangles, double(points[i].triangles)}, ""});
    }
    const LodReport report = ProgressiveMeshGenerator().generateLodLevels(config).value();
    EXPECT_EQ(points[0].triangles, report.triangles);
    EXPECT_EQ(points[0].vertices, report.vertices);
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_EQ(points[i].triangles, report.levels[i - 1].triangles);
        EXPECT_EQ(points[i].vertices, report.levels[i - 1].vertices);
        EXPECT_EQ(points[i].deviation, report.levels[i - 1].deviation);
    }
}

TEST_F(BackgroundAnalysisTest, HandMadeLevelsAreMeasuredToo)
{
    const Ogre::MeshPtr other = mSession.saveAndReload(makeOgreMesh("other", translated(makeGrid(3, 3), 0, 0, 0.25)));
    const Ogre::MeshPtr mesh = mSession.saveAndReload(makeOgreMesh("source", makeGrid(8, 8)));
    setHandMadeLevel(*mesh, other->getName());
    EXPECT_NEAR(surfaceOf(mesh, 1).maximum, 0.25, 1e-6);
    Distances distances;
    const auto job =
        mAnalyser->distances(mesh, 1, [&](const Result<Distances>& result) { distances = result.value(); });
    finish();
    EXPECT_THAT(distances, ElementsAre(testing::AllOf(testing::SizeIs(81), testing::Each(0.25f))));
}

TEST_F(BackgroundAnalysisTest, JobsEndInTheOrderInWhichTheyCame)
{
    const Ogre::MeshPtr big = withLevels("big", makeUvSphere(80, 60));
    const Ogre::MeshPtr small = withLevels("small");
    const std::vector<JobPtr> jobs = {measure(big), measure(small), measure(big, 2), measure(small, 0)};
    EXPECT_THAT(mEvents, IsEmpty());
    finish();
    EXPECT_THAT(mEvents, ElementsAre("big", "small", "big", "small"));
    EXPECT_TRUE(mAnalyser->isIdle());
}

TEST_F(BackgroundAnalysisTest, WorksAtTheStartOfFramesAndSaysHowFarItIs)
{
    const Ogre::MeshPtr mesh = withLevels("mesh");
    EXPECT_TRUE(mAnalyser->isIdle());
    const JobPtr first = measure(mesh), second = measure(mesh);
    EXPECT_FALSE(mAnalyser->isIdle());
    EXPECT_EQ(first->fraction(), 0.0f);
    bool runningWithin = true;
    const JobPtr third = measure(mesh, 1, [&] { runningWithin = third->isRunning(); });
    while (!mAnalyser->isIdle()) {
        EXPECT_EQ(mEvents.size(), std::size_t(!first->isRunning()) + !second->isRunning() + !third->isRunning());
        frame();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(mEvents.size(), 3u);
    EXPECT_EQ(first->fraction(), 1.0f);
    EXPECT_FALSE(first->isRunning());
    EXPECT_FALSE(runningWithin);
}

TEST_F(BackgroundAnalysisTest, NothingIsReadBeforeItsTurnComes)
{
    const Ogre::MeshPtr mesh = withLevels("mesh");
    DeviationFigures coarse;
    const auto job = mAnalyser->measure(
        mesh, 1, [&](const Result<Deviation>& deviation) { coarse = deviation.value().surface; }, fewSamples());
    generate(mesh, {0.9});
    finish();
    EXPECT_TRUE(sameBits(coarse, directly(mesh, 1).surface)) << "the level as it is by then";

    const JobPtr gone = measure(mesh, 1);
    mesh->removeLodLevels();
    finish();
    EXPECT_THAT(mEvents, ElementsAre("mesh: invalid_setting"));
}

TEST_F(BackgroundAnalysisTest, LevelZeroIsReadOnceForJobsThatFollowOneAnother)
{
    const Ogre::MeshPtr mesh = withLevels("mesh");
    const Deviation before = directly(mesh, 1);
    const JobPtr first = measure(mesh);
    DeviationFigures shared;
    const auto second = mAnalyser->measure(
        mesh, 1, [&](const Result<Deviation>& deviation) { shared = deviation.value().surface; }, fewSamples());
    mAnalyser->update();
    { // The change is kept from OGRE's count, and so from the analyser.
        const auto buffer = mesh->getSubMesh(0)->vertexData->vertexBufferBinding->getBuffer(0);
        const Ogre::HardwareBufferLockGuard lock(buffer, Ogre::HardwareBuffer::HBL_NORMAL);
        static_cast<float*>(lock.pData)[0] += 100.0f;
    }
    finish();
    EXPECT_TRUE(sameBits(shared, before.surface));
    EXPECT_GT(surfaceOf(mesh, 0).maximum, -1.0);
    EXPECT_FALSE(sameBits(surfaceOf(mesh, 1), before.surface)) << "not kept beyond that";
}

TEST_F(BackgroundAnalysisTest, RequestsThatCannotBeServed)
{
    const Ogre::MeshPtr mesh = withLevels("mesh");
    const auto never = [](const auto&) { FAIL() << "there is no job"; };
    EXPECT_EQ(mAnalyser->measure(mesh, 3, never).error().code, ErrorCode::InvalidSetting);
    EXPECT_EQ(mAnalyser->distances(mesh, 3, never).error().code, ErrorCode::InvalidSetting);
    const Ogre::MeshPtr empty = Ogre::MeshManager::getSingleton().createManual("empty", mSession.group());
    EXPECT_EQ(mAnalyser->measure(empty, 0, never).error().code, ErrorCode::Unsupported);
    EXPECT_EQ(mAnalyser->curve(empty, {}, 5, never).error().code, ErrorCode::Unsupported);
    EXPECT_TRUE(mAnalyser->isIdle());
    finish();
}

TEST_F(BackgroundAnalysisTest, ErrorsComeThroughTheCallback)
{
    const Ogre::MeshPtr mesh = withLevels("mesh");
    std::vector<ErrorCode> codes;
    const auto curve =
        mAnalyser->curve(mesh, {}, 0, [&](const Result<Points>& result) { codes.push_back(result.error().code); });
    DeviationOptions noSamples;
    noSamples.samples = 0;
    const auto deviation = mAnalyser->measure(
        mesh, 1, [&](const Result<Deviation>& result) { codes.push_back(result.error().code); }, noSamples);
    finish();
    EXPECT_THAT(codes, ElementsAre(ErrorCode::InvalidSetting, ErrorCode::InvalidSetting));
}

/// What may happen to a mesh.
enum class Event { Destroy, Unload, Reload, MarkAsChanged };
const char* const kEvents[] = {"destroy", "unload", "reload", "mark_as_changed"};

class BackgroundAnalysisLifetimeTest : public BackgroundAnalysisTest, public testing::WithParamInterface<Event> {
protected:
    void happen()
    {
        switch (GetParam()) {
        case Event::Destroy:
            Ogre::MeshManager::getSingleton().remove(mMesh->getHandle());
            mMesh.reset();
            EXPECT_TRUE(mWeak.expired()) << "jobs keep no mesh alive";
            break;
        case Event::Unload: mMesh->unload(); break;
        case Event::Reload: mMesh->reload(); break;
        case Event::MarkAsChanged: mMesh->_dirtyState(); break;
        }
    }

    Ogre::MeshPtr mMesh = fileWithLevels();
    std::weak_ptr<Ogre::Mesh> mWeak = mMesh;
    std::string mName = mMesh->getName();
};

TEST_P(BackgroundAnalysisLifetimeTest, OfAMeshBeforeItIsRead)
{
    const JobPtr job = measure(mMesh);
    happen();
    finish();
    EXPECT_THAT(mEvents, ElementsAre(mName + ": not_found"));
}

TEST_P(BackgroundAnalysisLifetimeTest, OfAMeshOnceItIsRead)
{
    const JobPtr job = measure(mMesh), next = measure(mMesh);
    mAnalyser->update();
    happen();
    finish();
    EXPECT_THAT(mEvents, ElementsAre(mName, mName + ": not_found")) << "the copy is not for what has changed";
}

INSTANTIATE_TEST_SUITE_P(Each, BackgroundAnalysisLifetimeTest,
                         testing::Values(Event::Destroy, Event::Unload, Event::Reload, Event::MarkAsChanged),
                         [](const auto& info) { return std::string(kEvents[static_cast<int>(info.param)]); });

class BackgroundAnalysisCancelTest : public BackgroundAnalysisTest {
protected:
    Ogre::MeshPtr mMesh = withLevels("mesh");
    Ogre::MeshPtr mOther = withLevels("other", makeCube(4));
};

TEST_F(BackgroundAnalysisCancelTest, AWaitingJob)
{
    const JobPtr first = measure(mMesh), second = measure(mOther), third = measure(mMesh);
    second->cancel();
    EXPECT_FALSE(second->isRunning());
    finish();
    EXPECT_THAT(mEvents, ElementsAre("mesh", "mesh"));
    third->cancel();
    EXPECT_THAT(mEvents, ElementsAre("mesh", "mesh")) << "it had ended";
}

TEST_F(BackgroundAnalysisCancelTest, AJobOnTheThread)
{
    const JobPtr first = measure(mMesh), second = measure(mOther);
    mAnalyser->update();
    first->cancel();
    EXPECT_FALSE(first->isRunning());
    finish();
    EXPECT_THAT(mEvents, ElementsAre("other"));
}

TEST_F(BackgroundAnalysisCancelTest, AJobThatIsComputedAlready)
{
    const JobPtr first = measure(mOther);
    mAnalyser->update();
    while (first->fraction() < 1.0f)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    first->cancel();
    finish();
    EXPECT_THAT(mEvents, IsEmpty());
}

TEST_F(BackgroundAnalysisCancelTest, ByLettingGoOfIt)
{
    JobPtr kept = measure(mMesh), copy = kept;
    measure(mOther);
    kept.reset();
    finish();
    EXPECT_THAT(mEvents, ElementsAre("mesh"));
    JobPtr running = measure(mOther);
    mAnalyser->update();
    running.reset();
    finish();
    EXPECT_THAT(mEvents, ElementsAre("mesh"));
}

TEST_F(BackgroundAnalysisCancelTest, LetsGoOfTheCallbackAtOnce)
{
    for (const bool onTheThread : {false, true}) {
        auto held = std::make_shared<int>(1);
        const std::weak_ptr<int> watched = held;
        const JobPtr job = measure(mMesh, 1, [held = std::move(held)] {});
        if (onTheThread)
            mAnalyser->update();
        EXPECT_FALSE(watched.expired());
        job->cancel();
        EXPECT_TRUE(watched.expired());
    }
    auto held = std::make_shared<int>(1);
    const std::weak_ptr<int> watched = held;
    const JobPtr job = measure(mMesh, 1, [held = std::move(held)] {});
    finish();
    EXPECT_TRUE(watched.expired()) << "nor does a job that has ended hold it";
}

TEST_F(BackgroundAnalysisCancelTest, AJobWhoseCallbackHoldsItself)
{
    auto self = std::make_shared<JobPtr>();
    *self = measure(mMesh, 1, [self] { self->reset(); });
    finish();
    EXPECT_THAT(mEvents, ElementsAre("mesh"));
    *self = measure(mMesh, 1, [self] {});
    (*self)->cancel();
    finish();
    EXPECT_EQ(mEvents.size(), 1u);
    self->reset();
}

TEST_F(BackgroundAnalysisCancelTest, WithTheAnalyser)
{
    const Ogre::MeshPtr big = makeOgreMesh("big", makeTerrain(200), {false, true});
    for (const bool started : {false, true}) {
        const auto held = std::make_shared<int>(1);
        const JobPtr waiting = measure(mMesh, 1, [held] {});
        const auto running = mAnalyser->curve(big, {}, 50, [](const auto&) { FAIL() << "the analyser has gone"; });
        ASSERT_TRUE(running);
        waiting->cancel();
        const JobPtr behind = measure(mMesh, 1, [held] {});
        if (started)
            mAnalyser->update();
        mAnalyser.reset();
        EXPECT_FALSE(running.value()->isRunning());
        EXPECT_FALSE(behind->isRunning());
        EXPECT_EQ(held.use_count(), 1);
        behind->cancel();
        frame();
        mAnalyser = std::make_unique<LevelAnalyser>();
    }
    EXPECT_THAT(mEvents, IsEmpty());
}

/// What callbacks may do.
class BackgroundAnalysisCallbackTest : public BackgroundAnalysisCancelTest {};

TEST_F(BackgroundAnalysisCallbackTest, AskForMore)
{
    JobPtr more;
    const JobPtr job = measure(mMesh, 1, [&] { more = measure(mOther); });
    finish();
    EXPECT_THAT(mEvents, ElementsAre("mesh", "other"));
}

TEST_F(BackgroundAnalysisCallbackTest, CancelOthers)
{
    JobPtr second;
    const JobPtr first = measure(mMesh, 1, [&] { second->cancel(); });
    second = measure(mOther);
    const JobPtr third = measure(mMesh, 2);
    finish();
    EXPECT_THAT(mEvents, ElementsAre("mesh", "mesh"));
}

TEST_F(BackgroundAnalysisCallbackTest, WorkOn)
{
    const std::function<void()> calls[] = {[&] { finish(); }, [&] { mAnalyser->update(); }, [&] { frame(); }};
    for (const auto& call : calls) {
        mEvents.clear();
        const JobPtr first = measure(mMesh, 1, call), second = measure(mOther, 1, call), third = measure(mMesh);
        finish();
        EXPECT_THAT(mEvents, ElementsAre("mesh", "other", "mesh"));
    }
}

TEST_F(BackgroundAnalysisCallbackTest, DestroyTheAnalyser)
{
    const std::function<void()> calls[] = {[&] { finish(); },
                                           [&] {
                                               while (mAnalyser)
                                                   frame();
                                           },
                                           [&] {
                                               while (mAnalyser)
                                                   mAnalyser->update();
                                           }};
    for (const auto& call : calls) {
        mEvents.clear();
        if (!mAnalyser)
            mAnalyser = std::make_unique<LevelAnalyser>();
        const JobPtr first = measure(mMesh, 1, [&] { mAnalyser.reset(); });
        const JobPtr second = measure(mOther);
        call();
        EXPECT_FALSE(mAnalyser);
        EXPECT_FALSE(second->isRunning());
        EXPECT_THAT(mEvents, ElementsAre("mesh"));
        frame();
    }
}

TEST_F(BackgroundAnalysisCallbackTest, OfAnErrorMayDestroyTheAnalyserToo)
{
    const Ogre::MeshPtr file = fileWithLevels();
    const JobPtr job = measure(file, 1, [&] { mAnalyser.reset(); });
    const JobPtr next = measure(mMesh);
    file->unload();
    finish();
    EXPECT_FALSE(mAnalyser);
    EXPECT_FALSE(next->isRunning());
}

TEST(BackgroundAnalysisAfterOgreTest, OgreMayBeTakenDownFirst)
{
    auto session = std::make_unique<OgreSession>();
    auto analyser = std::make_unique<LevelAnalyser>();
    Ogre::MeshPtr mesh = makeOgreMesh("mesh", makeUvSphere(40, 30));
    const auto first = analyser->curve(mesh, {}, 20, [](const auto&) { FAIL(); });
    const auto second = analyser->curve(mesh, {}, 20, [](const auto&) { FAIL(); });
    analyser->update();
    mesh.reset();
    session.reset();
    analyser.reset();
    EXPECT_FALSE(first.value()->isRunning());
    EXPECT_FALSE(second.value()->isRunning());
}

} // namespace
} // namespace lodsmith::test
