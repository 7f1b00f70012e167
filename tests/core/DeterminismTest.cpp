#include "DeterminismCases.h"

#include <gtest/gtest.h>

#include <thread>

namespace lodsmith {

namespace {

using namespace test;

TEST(Determinism, RepeatedRunsGiveTheSameBytes)
{
    for (const auto& [name, mesh] : determinismMeshes()) {
        for (const Metric metric : {Metric::Quadric, Metric::Curvature}) {
            const std::string first = outcomeOf(mesh, metric);
            EXPECT_EQ(outcomeOf(mesh, metric), first) << name;
            const TestMesh copy = mesh; // at other addresses
            EXPECT_EQ(outcomeOf(copy, metric), first) << name;
        }
    }
}

TEST(Determinism, SeveralThreadsOnOneMeshGiveTheSameBytes)
{
    const TestMesh mesh = makeTerrain(64);
    const std::string expected = outcomeOf(mesh, Metric::Quadric);
    std::vector<std::string> outcomes(4);
    std::vector<std::thread> threads;
    for (std::string& outcome : outcomes)
        threads.emplace_back([&mesh, &outcome] { outcome = outcomeOf(mesh, Metric::Quadric); });
    for (std::thread& thread : threads)
        thread.join();
    for (const std::string& outcome : outcomes)
        EXPECT_EQ(outcome, expected);
}

TEST(Determinism, WatchingChangesNothing)
{
    const TestMesh mesh = makeTerrain(48);
    Progress progress;
    const Result<LodChain> watched = simplify(mesh.view(), kDeterminismTargets, {}, &progress);
    ASSERT_TRUE(watched.ok());
    EXPECT_EQ(bytesOf(watched.value()), outcomeOf(mesh, Metric::Quadric));
}

} // namespace

} // namespace lodsmith
