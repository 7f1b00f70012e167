#include "FrameTimes.h"

#include "MarkdownTable.h"
#include "RuntimeMeshes.h"

#include "../tests/support/RenderSession.h"

#include <OgreEntity.h>
#include <OgreRoot.h>
#include <OgreSceneNode.h>

#include <algorithm>
#include <ctime>
#include <ostream>

namespace lodsmith::benchmarks {

namespace {

constexpr std::size_t kMeshes = 500;
constexpr std::size_t kVisible = 40; ///< of them, in front of the camera
constexpr std::size_t kFrames = 300; ///< without generation
constexpr std::uint32_t kMostTriangles = 20000;

struct Frames {
    std::vector<double> whole;
    std::vector<double> queue; ///< processor time that the queue took in each
};

/// Of this thread: what it waited for the processor does not count.
double processorSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double percentile(std::vector<double> values, double share)
{
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}

class Loop {
public:
    Loop() : mSession(1280, 720)
    {
        const auto subjects = subjectsUpTo(kMostTriangles);
        for (std::size_t i = 0; i < kMeshes; ++i)
            mMeshes.push_back(subjects[i % subjects.size()]->mesh()->clone("copy " + std::to_string(i)));
        for (std::size_t i = 0; i < kVisible; ++i)
            showInRow(mMeshes[i], i);
        for (int warmUp = 0; warmUp < 10; ++warmUp)
            mSession.frame();
    }

    Frames without()
    {
        Frames frames;
        for (std::size_t i = 0; i < kFrames; ++i)
            draw(nullptr, frames);
        return frames;
    }

    Frames generating(PMInjector::Milliseconds budget)
    {
        QueueOptions options;
        options.frameBudget = budget;
        QueuedProgressiveMeshGenerator queue(options);
        // Called by hand instead, so that its share of the frame is seen.
        Ogre::Root::getSingleton().removeFrameListener(&queue.injector());
        for (const Ogre::MeshPtr& mesh : mMeshes)
            expect(queue.generateLodLevels(halvedLevels(mesh)));
        Frames frames;
        while (queue.queued() > 0)
            draw(&queue.injector(), frames);
        for (const Ogre::MeshPtr& mesh : mMeshes)
            mesh->removeLodLevels();
        return frames;
    }

private:
    void draw(PMInjector* injector, Frames& frames)
    {
        const Stopwatch whole;
        if (injector) {
            const double before = processorSeconds();
            injector->update();
            frames.queue.push_back(1000 * (processorSeconds() - before));
        }
        mSession.frame();
        frames.whole.push_back(1000 * whole.seconds());
    }

    void showInRow(const Ogre::MeshPtr& mesh, std::size_t place)
    {
        Ogre::Entity& entity = mSession.show(mesh);
        const Ogre::Real scale = 1 / mesh->getBoundingSphereRadius();
        Ogre::SceneNode* node = entity.getParentSceneNode();
        node->setScale(Ogre::Vector3(scale));
        node->setPosition(Ogre::Vector3(Ogre::Real(place % 8) * 2 - 7, Ogre::Real(place / 8) * 2 - 4, -14));
    }

    test::RenderSession mSession;
    std::vector<Ogre::MeshPtr> mMeshes;
};

std::vector<std::string> row(const std::string& name, const Frames& frames)
{
    std::vector<std::string> cells{name, std::to_string(frames.whole.size())};
    for (const std::vector<double>* values : {&frames.whole, &frames.queue})
        for (const double share : {0.5, 0.95, 0.99, 1.0})
            cells.push_back(values->empty() ? "" : fixed(percentile(*values, share), 2));
    return cells;
}

} // namespace

void printFrameTimes(std::ostream& out)
{
    Loop loop;
    MarkdownTable table(
        {"", "frames", "frame ms, median", "95%", "99%", "most", "queue ms, median", "95%", "99%", "most"});
    table.addRow(row("nothing to do", loop.without()));
    table.addRow(row("500 meshes, budget 2 ms", loop.generating(PMInjector::Milliseconds(2))));
    table.addRow(row("500 meshes, one step a frame", loop.generating(PMInjector::Milliseconds(0))));
    out << "## Frames\n\n";
    table.print(out);
}

} // namespace lodsmith::benchmarks
