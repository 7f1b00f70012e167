#pragma once

#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include "QueueParts.h"

#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <gtest/gtest.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace lodsmith::test {

/// Stands in front of the workers' computation and lets it begin when the test says so. A cancelled computation passes.
/// Meshes are told apart by their number of vertices.
class Gate {
public:
    /// What a worker calls. `before` runs once the gate is passed.
    ComputeFunction compute(std::function<void(const PreparedLods&, Progress*)> before = {});

    void open();
    /// Lets this many computations through.
    void let(int computations);
    /// Waits until so many computations have come to the gate since the beginning.
    void waitForArrivals(std::size_t count);
    /// Waits until so many computations have ended.
    void waitForEnds(std::size_t count);
    /// Vertex counts of the computations that came to the gate, in their order.
    std::vector<std::uint32_t> arrivals();

private:
    void pass(const PreparedLods& prepared, const Progress& progress);

    std::mutex mMutex;
    std::condition_variable mChanged;
    std::vector<std::uint32_t> mArrivals;
    std::size_t mEnds = 0;
    int mPermits = 0;
    bool mOpen = false;
};

std::uint32_t verticesOf(const PreparedLods& prepared);

/// A queue with a gate before its workers, and a record of what it signals: "injected NAME", "failed NAME: CODE".
class QueueTest : public testing::Test {
protected:
    /// Makes the queue with so many workers. Levels are computed by `parts`, behind the gate unless given.
    void makeQueue(const QueueOptions& options);
    void makeQueue(const QueueOptions& options, QueueParts parts);
    static QueueOptions workers(unsigned count, std::size_t memoryLimit = std::size_t(1) << 30);

    /// A grid of `cells` x `cells` quads: (cells + 1)^2 vertices.
    static Ogre::MeshPtr grid(const std::string& name, std::uint32_t cells);
    /// Levels at distances 10, 20, ... that remove these shares.
    static LodConfig config(const Ogre::MeshPtr& mesh, const std::vector<double>& removed = {0.5});
    void enqueue(const Ogre::MeshPtr& mesh, float priority = 0.0f);
    void finish() { mQueue->injector().finishAll(); }
    /// The frame of a program: OGRE tells its listeners.
    static void frame();

    OgreSession mSession;
    Gate mGate;
    std::vector<std::string> mEvents;
    std::unique_ptr<QueuedProgressiveMeshGenerator> mQueue;
};

/// The triangles of all generated levels, submesh by submesh.
std::vector<std::vector<std::uint32_t>> levelsOf(const Ogre::Mesh& mesh);

} // namespace lodsmith::test
