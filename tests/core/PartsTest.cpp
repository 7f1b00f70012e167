// Compiled with parts of 64 vertices: what large meshes go through, on small ones.

#include "DeterminismCases.h"

#include "Parallel.h"
#include "Partition.h"
#include "Weld.h"
#include "support/CheckedSimplify.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <thread>

namespace lodsmith {

namespace {

using namespace test;

SimplifyOptions onThreads(unsigned threads, Metric metric = Metric::Quadric)
{
    SimplifyOptions options;
    options.metric = metric;
    options.threads = threads;
    return options;
}

TEST(Parts, AnyNumberOfThreadsGivesTheSameBytes)
{
    auto meshes = determinismMeshes();
    meshes.emplace_back("larger terrain", makeTerrain(120));
    meshes.emplace_back("larger cards", makeLeafCards(1500));
    for (const auto& [name, mesh] : meshes)
        for (const Metric metric : {Metric::Quadric, Metric::Curvature}) {
            const std::string expected = outcomeOf(mesh, onThreads(1, metric));
            for (const unsigned threads : {0u, 2u, 3u, 8u})
                EXPECT_EQ(outcomeOf(mesh, onThreads(threads, metric)), expected) << name << ", " << threads;
        }
}

TEST(Parts, KeepEveryInvariantForEveryKindOfTarget)
{
    const std::vector<std::vector<LevelTarget>> chains = {
        {removedShare(0.5), removedShare(0.75), removedShare(0.95)},
        {removedVertices(100), removedVertices(1000), removedVertices(1e9)},
        {keptTriangles(1500), keptTriangles(301), keptTriangles(20)},
        {greatestDeviation(0.01), greatestDeviation(0.03)},
        {dearestCollapse(0.002), dearestCollapse(0.01)},
        {greatestDeviation(0.005), removedShare(0.8), dearestCollapse(0.05), keptTriangles(50)}};
    const std::vector<TestMesh> meshes = {
        makeTerrain(40),    makeUvSphere(48, 32),        flatShaded(makeTorus(32, 24)),
        makeLeafCards(300), makeTwoMaterials(30, false), makeSkinnedTube(40, 30)};
    for (const TestMesh& mesh : meshes)
        for (const std::vector<LevelTarget>& targets : chains)
            simplifyChecked(mesh.view(), targets, onThreads(3));
}

TEST(Parts, ReachCountsToTheVertex)
{
    const TestMesh mesh = makeTerrain(60);
    const LodChain chain = simplifyChecked(mesh.view(), {removedVertices(1), removedVertices(1777)}, onThreads(2));
    EXPECT_EQ(chain.levels[0].vertices, chain.vertices - 1);
    EXPECT_EQ(chain.levels[1].vertices, chain.vertices - 1777);
}

TEST(Parts, ADeviationThatIsAllowedIsUsedUpAcrossThem)
{
    // A flat sheet may lose all but its corners, wherever it was cut.
    const TestMesh mesh = makeGrid(40, 40);
    const LodChain chain = simplifyChecked(mesh.view(), {greatestDeviation(1e-6)}, onThreads(2));
    EXPECT_EQ(chain.levels[0].vertices, 4u);
    EXPECT_EQ(chain.levels[0].stop, StopReason::TargetReached);
}

TEST(Parts, ACancelComesThroughWhileTheyAreWorkedOn)
{
    const TestMesh mesh = makeTerrain(400);
    for (int attempt = 0; attempt < 3; ++attempt) {
        Progress progress;
        std::thread canceller([&] {
            while (progress.fraction() <= 0.1f * static_cast<float>(attempt))
                std::this_thread::yield();
            progress.cancel();
        });
        const Result<LodChain> result = simplify(mesh.view(), {removedShare(0.99)}, onThreads(3), &progress);
        canceller.join();
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
    }
}

/// Welded, with its faces counted.
CollapseMesh weldedMesh(const TestMesh& mesh)
{
    Result<CollapseMesh> welded = weld(mesh.view());
    EXPECT_TRUE(welded.ok());
    welded.value().countFaces();
    return std::move(welded).value();
}

TEST(Parts, HaveEveryVertexOnceAndEveryFaceThatTouchesThem)
{
    for (const TestMesh& source : {makeTerrain(50), makeLeafCards(200), makeSoup(300)}) {
        const CollapseMesh mesh = weldedMesh(source);
        const Partition partition(mesh, 64, 0.5, 2);
        ASSERT_GT(partition.count(), 4u);
        std::vector<std::size_t> partOf(mesh.vertexCount());
        std::set<std::uint32_t> seen;
        for (std::size_t part = 0; part < partition.count(); ++part) {
            const std::uint32_t first = partition.firstVertex[part], end = partition.firstVertex[part + 1];
            EXPECT_LE(end - first, 64u);
            for (std::uint32_t i = first; i < end; ++i) {
                EXPECT_TRUE(seen.insert(partition.vertices[i]).second);
                EXPECT_EQ(partition.place[partition.vertices[i]], i);
                partOf[partition.vertices[i]] = part;
            }
        }
        EXPECT_EQ(seen.size(), mesh.liveVertices);
        std::vector<std::set<std::uint32_t>> expected(partition.count());
        for (std::uint32_t face = 0; face < mesh.faces.size(); ++face)
            for (const std::uint32_t wedge : mesh.faces[face].wedge)
                expected[partOf[mesh.vertexOf(wedge)]].insert(face);
        for (std::size_t part = 0; part < partition.count(); ++part)
            EXPECT_EQ(std::vector<std::uint32_t>(expected[part].begin(), expected[part].end()),
                      std::vector<std::uint32_t>(partition.faces.begin() + partition.firstFace[part],
                                                 partition.faces.begin() + partition.firstFace[part + 1]));
    }
}

TEST(Parts, CannotBeMadeOfWhatLiesInOnePlace)
{
    TestMesh mesh = makeSoup(100);
    for (float& coordinate : mesh.buffers[0].positions)
        coordinate = coordinate < 0.5f ? 0.0f : 1.0f; // eight places at most
    const CollapseMesh welded = weldedMesh(mesh);
    EXPECT_LE(Partition(welded, 1, 0.5, 2).count(), 8u);
    EXPECT_TRUE(simplify(mesh.view(), {removedShare(0.9)}, onThreads(2)).ok());
}

TEST(Parallel, DoesEveryPieceOfWorkOnce)
{
    for (const unsigned threads : {0u, 1u, 2u, 7u}) {
        std::vector<std::atomic<int>> done(100);
        inParallel(threads, done.size(), [&](std::size_t i) { ++done[i]; });
        for (const std::atomic<int>& times : done)
            EXPECT_EQ(times, 1);
    }
    inParallel(4, 0, [](std::size_t) { FAIL() << "there was nothing to do"; });
}

TEST(Parallel, WhatIsThrownComesOutWhenAllHaveStopped)
{
    std::atomic<int> running{0};
    const auto work = [&](std::size_t i) {
        ++running;
        const bool bad = i == 5;
        --running;
        if (bad)
            throw std::runtime_error("five");
    };
    for (const unsigned threads : {1u, 3u}) {
        EXPECT_THROW(inParallel(threads, 1000, work), std::runtime_error);
        EXPECT_EQ(running, 0);
    }
}

} // namespace

} // namespace lodsmith
