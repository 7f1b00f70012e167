#include "MainThreadShare.h"

#include "MarkdownTable.h"
#include "RuntimeMeshes.h"
#include "Timing.h"

#include <ostream>
#include <thread>

namespace lodsmith::benchmarks {

namespace {

constexpr auto kFrame = std::chrono::milliseconds(16);

double directly(Subject& subject)
{
    const Stopwatch watch;
    const Result<LodReport> report = ProgressiveMeshGenerator().generateLodLevels(halvedLevels(subject.mesh()));
    const double seconds = watch.seconds();
    expect(report);
    subject.removeLevels();
    return seconds;
}

/// Frames of nothing but the queue's work, of which only that is measured.
double inTheBackground(QueuedProgressiveMeshGenerator& queue, Subject& subject)
{
    Stopwatch watch;
    expect(queue.generateLodLevels(halvedLevels(subject.mesh())));
    double seconds = watch.seconds();
    while (queue.queued() > 0) {
        std::this_thread::sleep_for(kFrame);
        watch = Stopwatch();
        queue.injector().update();
        seconds += watch.seconds();
    }
    subject.removeLevels();
    return seconds;
}

} // namespace

void printMainThreadShare(std::ostream& out, int rounds)
{
    QueuedProgressiveMeshGenerator queue;
    MarkdownTable table({"mesh", "triangles", "direct ms", "main thread ms", "share"});
    std::vector<double> shares;
    for (const SubjectSource& source : allSubjects({})) {
        const auto subject = source.load();
        std::vector<double> direct, background;
        for (int round = 0; round <= rounds; ++round) {
            direct.push_back(directly(*subject));
            background.push_back(inTheBackground(queue, *subject));
        }
        // The first round warms up.
        direct.erase(direct.begin());
        background.erase(background.begin());
        shares.push_back(median(background) / median(direct));
        table.addRow({subject->name(), std::to_string(subject->triangles()), fixed(1000 * median(direct), 2),
                      fixed(1000 * median(background), 3), fixed(100 * shares.back(), 1) + "%"});
    }
    table.addRow({"*geometric mean*", "", "", "", fixed(100 * geometricMean(shares), 1) + "%"});
    out << "## Main thread\n\n";
    table.print(out);
}

} // namespace lodsmith::benchmarks
