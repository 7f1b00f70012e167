// The chain of halvings under Google Benchmark: every peer on every mesh, and growth from 1k to 1M triangles.

#include "OgreSession.h"
#include "Peer.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

namespace lodsmith::benchmarks {

namespace {

/// Keeps the last mesh loaded: benchmarks of one mesh often follow each other.
class SubjectCache {
public:
    Subject& get(const SubjectSource& source)
    {
        if (!mSubject || mSubject->name() != source.name) {
            mSubject.reset();
            mSubject = source.load();
        }
        return *mSubject;
    }

private:
    std::unique_ptr<Subject> mSubject;
};

/// What the registered benchmarks refer to; outlives their runs.
struct Inputs {
    std::vector<std::unique_ptr<Peer>> peers = makePeers();
    std::vector<SubjectSource> meshes = allSubjects({});
    std::vector<SubjectSource> sizes = scalingSubjects();
    SubjectCache cache;
};

void runChain(benchmark::State& state, Peer& peer, Subject& subject)
{
    for (auto _ : state) {
        state.SetIterationTime(peer.generate(subject, halvings()));
        peer.reset(subject);
    }
    state.SetItemsProcessed(std::int64_t(state.iterations()) * subject.triangles());
    state.SetComplexityN(subject.triangles());
}

void registerMeshes(Inputs& inputs)
{
    for (const SubjectSource& source : inputs.meshes)
        for (const auto& peer : inputs.peers) {
            const auto body = [&](benchmark::State& state) { runChain(state, *peer, inputs.cache.get(source)); };
            benchmark::RegisterBenchmark((source.name + "/" + peer->name()).c_str(), body)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
}

void registerGrowth(Inputs& inputs)
{
    for (const auto& peer : inputs.peers) {
        const auto body = [&](benchmark::State& state) {
            runChain(state, *peer, inputs.cache.get(inputs.sizes[std::size_t(state.range(0))]));
        };
        benchmark::RegisterBenchmark(("growth/" + peer->name()).c_str(), body)
            ->DenseRange(0, std::int64_t(inputs.sizes.size()) - 1)
            ->Complexity(benchmark::oNLogN)
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
    }
}

/// The caller's arguments come last and win.
int runWith(int argc, char** argv)
{
    std::vector<std::string> arguments{argv[0], "--benchmark_enable_random_interleaving=true",
                                       "--benchmark_repetitions=5", "--benchmark_report_aggregates_only=true"};
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    std::vector<char*> pointers;
    for (std::string& argument : arguments)
        pointers.push_back(argument.data());
    int count = int(pointers.size());
    benchmark::Initialize(&count, pointers.data());
    if (benchmark::ReportUnrecognizedArguments(count, pointers.data()))
        return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

} // namespace

} // namespace lodsmith::benchmarks

int main(int argc, char** argv)
{
    using namespace lodsmith::benchmarks;
    const OgreSession session;
    Inputs inputs;
    registerMeshes(inputs);
    registerGrowth(inputs);
    const int exitCode = runWith(argc, argv);
    benchmark::ClearRegisteredBenchmarks();
    return exitCode;
}
