#include "Throughput.h"

#include "MarkdownTable.h"
#include "RuntimeMeshes.h"
#include "Timing.h"

#include "../tests/support/TestDirectory.h"

#include <lodsmith/cache/LodCache.h>

#include <filesystem>
#include <functional>
#include <ostream>

namespace lodsmith::benchmarks {

namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kMostTriangles = 100100;

using Subjects = std::vector<std::unique_ptr<Subject>>;

double direct(const Subjects& subjects)
{
    const Stopwatch watch;
    for (const auto& subject : subjects)
        expect(ProgressiveMeshGenerator().generateLodLevels(halvedLevels(subject->mesh())));
    return watch.seconds();
}

double queued(const Subjects& subjects, const QueueOptions& options)
{
    const Stopwatch watch;
    QueuedProgressiveMeshGenerator queue(options);
    std::string trouble;
    queue.signals().failed.connect([&](const Ogre::MeshPtr&, const Error& error) { trouble = describe(error); });
    for (const auto& subject : subjects)
        expect(queue.generateLodLevels(halvedLevels(subject->mesh())));
    queue.injector().finishAll();
    const double seconds = watch.seconds();
    if (!trouble.empty())
        throw std::runtime_error(trouble);
    return seconds;
}

struct Way {
    std::string name;
    std::function<double()> run;
    std::vector<double> seconds = {};
};

} // namespace

void printThroughput(std::ostream& out, int rounds)
{
    const Subjects subjects = subjectsUpTo(kMostTriangles);
    const test::TestDirectory directory;
    const fs::path levels = directory / "levels";
    const auto fromCache = [&] {
        QueueOptions options{1};
        options.cache = std::make_shared<LodCache>(levels, std::uint64_t(1) << 30);
        return queued(subjects, options);
    };
    std::vector<Way> ways{{"direct", [&] { return direct(subjects); }},
                          {"one worker", [&] { return queued(subjects, {1}); }},
                          {"two workers", [&] { return queued(subjects, {2}); }},
                          {"one worker, empty cache",
                           [&] {
                               fs::remove_all(levels);
                               return fromCache();
                           }},
                          {"one worker, from the cache", fromCache}};
    for (int round = 0; round <= rounds; ++round)
        for (Way& way : ways) {
            const double seconds = way.run();
            for (const auto& subject : subjects)
                subject->removeLevels();
            if (round > 0) // the first warms up
                way.seconds.push_back(seconds);
        }
    const double one = median(ways[1].seconds);
    MarkdownTable table({"way", "ms", "one worker's time / this"});
    for (const Way& way : ways)
        table.addRow({way.name, fixed(1000 * median(way.seconds), 1), fixed(one / median(way.seconds), 2)});
    out << "## Throughput\n\n" << subjects.size() << " meshes.\n\n";
    table.print(out);
}

} // namespace lodsmith::benchmarks
