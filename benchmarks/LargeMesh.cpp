#include "LargeMesh.h"

#include "LodsmithPeer.h"
#include "MarkdownTable.h"
#include "PeakMemory.h"
#include "Timing.h"

#include <ostream>
#include <stdexcept>
#include <thread>

namespace lodsmith::benchmarks {

namespace {

LodsmithPeer peerWith(unsigned threads)
{
    SimplifyOptions options;
    options.threads = threads;
    return LodsmithPeer(kLodsmith, options);
}

double generate(LodsmithPeer& peer, Subject& subject)
{
    const double seconds = peer.generate(subject, halvings());
    peer.reset(subject);
    return seconds;
}

std::vector<LevelIndices> levelsOf(LodsmithPeer& peer, Subject& subject)
{
    peer.generate(subject, halvings());
    std::vector<LevelIndices> levels;
    for (PeerLevel& level : peer.levels(subject))
        levels.push_back(std::move(level.indices));
    peer.reset(subject);
    return levels;
}

std::string triangles(const Subject& subject)
{
    return std::to_string(subject.triangles());
}

long peakOf(const std::string& origin)
{
    const Trial trial = tryInOwnProcess({kPeakCommand, origin});
    if (!trial.peakKb)
        throw std::runtime_error(origin + ": " + trial.trouble);
    return *trial.peakKb;
}

} // namespace

void printThreads(std::ostream& out, int rounds)
{
    const unsigned processors = std::thread::hardware_concurrency();
    MarkdownTable table(
        {"mesh", "triangles", "one thread, ms", std::to_string(processors) + " threads, ms", "times as fast"});
    for (const char* origin : {"planet-1M", "terrain-1M"}) {
        const std::unique_ptr<Subject> subject = sourceFrom(origin).load();
        LodsmithPeer one = peerWith(1), all = peerWith(processors);
        if (levelsOf(one, *subject) != levelsOf(all, *subject))
            throw std::runtime_error(std::string(origin) + ": other levels with another number of threads");
        std::vector<double> seconds[2];
        repeatInTurn(2, {rounds, 0.0}, [&](std::size_t i) {
            seconds[i].push_back(generate(i == 0 ? one : all, *subject));
            return seconds[i].back();
        });
        const double alone = median(seconds[0]), together = median(seconds[1]);
        table.addRow({subject->name(), triangles(*subject), fixed(1000.0 * alone, 0), fixed(1000.0 * together, 0),
                      fixed(alone / together, 2)});
    }
    out << "## Threads on one mesh\n\n";
    table.print(out);
}

void printTenMillion(std::ostream& out, int rounds)
{
    const SubjectSource sources[] = {sourceFrom("planet-1M"), hugeSubject()};
    const long peaks[] = {peakOf(sources[0].origin), peakOf(sources[1].origin)};
    const std::unique_ptr<Subject> subjects[] = {sources[0].load(), sources[1].load()};
    LodsmithPeer peer = peerWith(1);
    generate(peer, *subjects[0]);
    std::vector<double> seconds[2];
    repeatInTurn(2, {rounds, 0.0}, [&](std::size_t i) {
        seconds[i].push_back(generate(peer, *subjects[i]));
        return seconds[i].back();
    });
    MarkdownTable table({"mesh", "triangles", "seconds", "memory, MB"});
    for (std::size_t i = 0; i < 2; ++i)
        table.addRow({subjects[i]->name(), triangles(*subjects[i]), fixed(median(seconds[i]), 2),
                      fixed(double(peaks[i]) / 1024.0, 0)});
    table.addRow({"ratio", fixed(double(subjects[1]->triangles()) / subjects[0]->triangles(), 2),
                  fixed(median(seconds[1]) / median(seconds[0]), 1), fixed(double(peaks[1]) / double(peaks[0]), 1)});
    out << "## Ten million triangles\n\n";
    table.print(out);
}

void printPeak(std::ostream& out, const std::string& origin)
{
    const std::unique_ptr<Subject> subject = sourceFrom(origin).load();
    LodsmithPeer peer = peerWith(1);
    out << peakGrowthKb([&] { peer.generate(*subject, halvings()); }) << std::endl;
}

} // namespace lodsmith::benchmarks
