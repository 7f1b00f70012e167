// Lodsmith beside its peers: time, memory and error of one chain of levels on many meshes, as Markdown tables.

#include "MarkdownTable.h"
#include "OgreSession.h"
#include "PeakMemory.h"
#include "Quality.h"
#include "ResultsJson.h"
#include "Tables.h"
#include "Timing.h"

#include <lodsmith/analysis/MeshStatistics.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <regex>

namespace lodsmith::benchmarks {

namespace {

struct Arguments {
    std::string filter = ".*";
    std::vector<std::string> peers;
    std::vector<std::string> parts{"time", "memory", "quality"};
    std::vector<std::string> media;
    std::string json;
    TimingOptions timing;
    DeviationOptions deviation;
    bool quick = false;
    std::string mesh;   ///< with peakOf: the one mesh
    std::string peakOf; ///< print the memory growth of this peer and nothing else
};

constexpr std::uint32_t kQuickTriangles = 10000;

bool wants(const Arguments& arguments, const std::string& part)
{
    return std::count(arguments.parts.begin(), arguments.parts.end(), part) > 0;
}

std::vector<std::unique_ptr<Peer>> choosePeers(const Arguments& arguments)
{
    std::vector<std::unique_ptr<Peer>> peers = makePeers();
    const auto& names = arguments.peers;
    const auto unwanted = [&](const auto& peer) {
        return !names.empty() && std::count(names.begin(), names.end(), peer->name()) == 0;
    };
    peers.erase(std::remove_if(peers.begin(), peers.end(), unwanted), peers.end());
    return peers;
}

SubjectResult describeSubject(const Subject& subject)
{
    const Result<MeshStatistics> statistics = meshStatistics(subject.view());
    if (!statistics)
        throw std::runtime_error(describe(statistics.error()));
    SubjectResult result;
    result.name = subject.name();
    result.triangles = subject.triangles();
    result.vertices = statistics.value().vertices;
    result.radius = statistics.value().radius;
    result.hasNormals = subject.hasNormals();
    result.hasUvs = subject.hasUvs();
    return result;
}

std::map<std::string, long> peaks(const Arguments& arguments, const std::vector<Peer*>& peers, const Subject& subject)
{
    std::map<std::string, long> growth;
    for (const Peer* peer : peers) {
        std::vector<std::string> call{"--peak-of", peer->name(), "--mesh", subject.name()};
        for (const std::string& directory : arguments.media)
            call.insert(call.end(), {"--media", directory});
        if (const std::optional<long> kb = peakGrowthInOwnProcess(call))
            growth[peer->name()] = *kb;
    }
    return growth;
}

/// Runs every peer once, which also warms it up. One that fails on this mesh is named and takes no further part.
std::vector<Peer*> tryOut(const std::vector<std::unique_ptr<Peer>>& peers, Subject& subject, SubjectResult& result)
{
    std::vector<Peer*> able;
    for (const auto& peer : peers)
        try {
            result.chains[peer->name()] = countChain(*peer, subject);
            able.push_back(peer.get());
        } catch (const std::exception& error) {
            result.chains.erase(peer->name());
            std::cerr << "  " << peer->name() << ": " << error.what() << '\n';
        }
    return able;
}

SubjectResult measure(const Arguments& arguments, const std::vector<std::unique_ptr<Peer>>& all, Subject& subject)
{
    SubjectResult result = describeSubject(subject);
    const std::vector<Peer*> peers = tryOut(all, subject, result);
    if (wants(arguments, "time"))
        result.seconds = timeInTurn(subject, peers, arguments.timing);
    for (const auto& [peer, seconds] : result.seconds)
        std::cerr << "  " << peer << ' ' << fixed(1000.0 * median(seconds), 2) << " ms\n";
    if (wants(arguments, "memory"))
        result.peakKb = peaks(arguments, peers, subject);
    if (wants(arguments, "quality"))
        result.comparable = measureAtOgreCounts(peers, subject, arguments.deviation);
    return result;
}

/// Measures every mesh that the arguments choose; one that fails is named on standard error and left out.
bool measureAll(const Arguments& arguments, std::vector<SubjectResult>& results)
{
    const std::vector<std::unique_ptr<Peer>> peers = choosePeers(arguments);
    const std::regex filter(arguments.filter);
    bool good = true;
    for (const SubjectSource& source : allSubjects(arguments.media)) {
        if (!std::regex_search(source.name, filter))
            continue;
        try {
            const std::unique_ptr<Subject> subject = source.load();
            if (arguments.quick && subject->triangles() > kQuickTriangles)
                continue;
            std::cerr << source.name << ", " << subject->triangles() << " triangles\n";
            results.push_back(measure(arguments, peers, *subject));
        } catch (const std::exception& error) {
            std::cerr << source.name << ": " << error.what() << '\n';
            good = false;
        }
    }
    return good;
}

/// What a child process does: one mesh, one peer, one number.
int printPeak(const Arguments& arguments)
{
    for (const SubjectSource& source : allSubjects(arguments.media))
        if (source.name == arguments.mesh)
            for (const auto& peer : makePeers())
                if (peer->name() == arguments.peakOf) {
                    const std::unique_ptr<Subject> subject = source.load();
                    std::cout << peakGrowthKb(*peer, *subject) << std::endl;
                    return 0;
                }
    std::cerr << "no mesh " << arguments.mesh << " or no peer " << arguments.peakOf << '\n';
    return 1;
}

int run(const Arguments& arguments)
{
    const OgreSession session;
    if (!arguments.peakOf.empty())
        return printPeak(arguments);
    std::vector<SubjectResult> results;
    const bool good = measureAll(arguments, results);
    printTables(std::cout, results);
    if (arguments.json.empty())
        return good ? 0 : 1;
    std::ofstream file(arguments.json);
    writeJson(file, results);
    if (!file.flush())
        std::cerr << arguments.json << " cannot be written\n";
    return good && file ? 0 : 1;
}

void declare(CLI::App& app, Arguments& arguments)
{
    app.add_option("--filter", arguments.filter, "only meshes whose name matches this regular expression");
    app.add_option("--peers", arguments.peers, "only these peers")->delimiter(',');
    app.add_option("--parts", arguments.parts, "what to measure: time, memory, quality")
        ->delimiter(',')
        ->check(CLI::IsMember({"time", "memory", "quality"}));
    app.add_option("--media", arguments.media, "further directories of .mesh files");
    app.add_option("--json", arguments.json, "write all figures to this file");
    app.add_option("--rounds", arguments.timing.rounds, "runs of every peer on every mesh")->check(CLI::PositiveNumber);
    app.add_option("--samples", arguments.deviation.samples, "points on each surface when errors are measured")
        ->check(CLI::PositiveNumber);
    app.add_flag("--quick", arguments.quick, "one round, meshes up to 10000 triangles, 20000 samples");
    app.add_option("--mesh", arguments.mesh)->group("");
    app.add_option("--peak-of", arguments.peakOf)->group("");
}

} // namespace

} // namespace lodsmith::benchmarks

int main(int argc, char** argv)
{
    using namespace lodsmith::benchmarks;
    Arguments arguments;
    CLI::App app{"Measures Lodsmith beside OGRE's MeshLodGenerator and meshoptimizer."};
    declare(app, arguments);
    CLI11_PARSE(app, argc, argv);
    if (arguments.quick) {
        arguments.timing = {1, 0.0};
        arguments.deviation.samples = 20000;
    }
    try {
        return run(arguments);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
