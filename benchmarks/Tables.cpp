#include "Tables.h"

#include "MarkdownTable.h"
#include "QualityTables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace lodsmith::benchmarks {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double milliseconds(const SubjectResult& result, const std::string& peer)
{
    const auto found = result.seconds.find(peer);
    return found == result.seconds.end() ? kNone : 1000.0 * median(found->second);
}

double timeRatio(const SubjectResult& result, const std::string& dividend, const std::string& divisor)
{
    return milliseconds(result, dividend) / milliseconds(result, divisor);
}

template <class Value>
double geometricMeanOf(const std::vector<SubjectResult>& results, Value value)
{
    std::vector<double> values;
    for (const SubjectResult& result : results)
        if (const double one = value(result); !std::isnan(one))
            values.push_back(one);
    return geometricMean(values);
}

/// Levels of the timed chain that meshoptimizer does reach, by triangles, which is what it aims at.
int levelsReached(const SubjectResult& result)
{
    const auto found = result.chains.find(kMeshoptimizer);
    if (found == result.chains.end())
        return -1;
    const std::vector<LevelTarget> targets = halvings();
    int reachedLevels = 0;
    for (std::size_t i = 0; i < targets.size(); ++i)
        if (found->second[i].triangles <= 1.02 * (1.0 - targets[i].amount) * result.triangles + 2.0)
            ++reachedLevels;
    return reachedLevels;
}

std::vector<std::string> timeRow(const SubjectResult& result, const std::vector<std::string>& peers)
{
    std::vector<std::string> cells{result.name, std::to_string(result.triangles)};
    for (const std::string& peer : peers)
        cells.push_back(fixed(milliseconds(result, peer), 2));
    const int levels = levelsReached(result);
    cells.push_back(levels < 0 ? "-" : std::to_string(levels) + "/4");
    cells.push_back(fixed(timeRatio(result, kOgreCurvature, kLodsmith), 1));
    cells.push_back(fixed(timeRatio(result, kLodsmith, kMeshoptimizer), 2));
    cells.push_back(fixed(timeRatio(result, kLodsmithCore, kMeshoptimizer), 2));
    return cells;
}

std::vector<std::string> timeMeans(const std::string& title, const std::vector<SubjectResult>& results,
                                   const std::vector<std::string>& peers)
{
    std::vector<std::string> cells{title, std::to_string(results.size()) + " meshes"};
    for (const std::string& peer : peers)
        cells.push_back(
            fixed(geometricMeanOf(results, [&](const auto& result) { return milliseconds(result, peer); }), 2));
    const auto mean = [&](const char* dividend, const char* divisor) {
        return geometricMeanOf(results, [&](const auto& result) { return timeRatio(result, dividend, divisor); });
    };
    cells.push_back("");
    cells.push_back(fixed(mean(kOgreCurvature, kLodsmith), 1));
    cells.push_back(fixed(mean(kLodsmith, kMeshoptimizer), 2));
    cells.push_back(fixed(mean(kLodsmithCore, kMeshoptimizer), 2));
    return cells;
}

void printLeastGain(std::ostream& out, const std::vector<SubjectResult>& results)
{
    double least = kNone;
    std::string name;
    for (const SubjectResult& result : results)
        if (const double gain = timeRatio(result, kOgreCurvature, kLodsmith);
            result.triangles > 2000 && !std::isnan(gain) && !(gain >= least)) {
            least = gain;
            name = result.name;
        }
    if (!name.empty())
        out << "Least gain over OGRE's curvature metric above 2000 triangles: " << fixed(least, 1) << " (" << name
            << ").\n\n";
}

void printTimes(std::ostream& out, const std::vector<SubjectResult>& results, const std::vector<std::string>& peers)
{
    out << "## Time\n\nMilliseconds for the chain of four levels, median; vertex-cache order not counted.\n\n";
    std::vector<std::string> header{"mesh", "triangles"};
    header.insert(header.end(), peers.begin(), peers.end());
    header.insert(header.end(), {"meshoptimizer reaches", "ogre-curvature / lodsmith", "lodsmith / meshoptimizer",
                                 "lodsmith-core / meshoptimizer"});
    MarkdownTable table(header);
    std::vector<SubjectResult> allReached;
    for (const SubjectResult& result : results) {
        table.addRow(timeRow(result, peers));
        if (levelsReached(result) == 4)
            allReached.push_back(result);
    }
    table.addRow(timeMeans("geometric mean", results, peers));
    table.addRow(timeMeans("where meshoptimizer reaches 4/4", allReached, peers));
    table.print(out);
    printLeastGain(out, results);
}

void printGrowth(std::ostream& out, const std::vector<SubjectResult>& results, const std::vector<std::string>& peers)
{
    MarkdownTable table({"peer", "sizes", "time ~ n^", "time ~ (n log n)^", "M triangles/s at the largest"});
    for (const std::string& peer : peers) {
        std::vector<double> sizes, costs, times;
        for (const SubjectResult& result : results)
            if (result.name.rfind("planet-", 0) == 0 && result.seconds.count(peer)) {
                sizes.push_back(result.triangles);
                costs.push_back(result.triangles * std::log2(result.triangles));
                times.push_back(milliseconds(result, peer));
            }
        if (sizes.size() >= 2)
            table.addRow({peer, std::to_string(sizes.size()), fixed(fittedExponent(sizes, times), 3),
                          fixed(fittedExponent(costs, times), 3), fixed(sizes.back() / times.back() / 1000.0, 2)});
    }
    out << "## Growth\n\nOver the planets; an exponent of at most 1 over n log n means no faster than n log n.\n\n";
    table.print(out);
}

double peakKb(const SubjectResult& result, const std::string& peer)
{
    const auto found = result.peakKb.find(peer);
    return found == result.peakKb.end() ? kNone : std::max(1.0, double(found->second));
}

void printMemory(std::ostream& out, const std::vector<SubjectResult>& results, const std::vector<std::string>& peers)
{
    out << "## Memory\n\nGrowth of the peak resident memory while the chain is made, kB, each peer in a process of its "
           "own.\n\n";
    std::vector<std::string> header{"mesh", "triangles"};
    header.insert(header.end(), peers.begin(), peers.end());
    header.push_back("lodsmith / ogre-curvature");
    MarkdownTable table(header);
    const auto ratio = [](const SubjectResult& result) {
        return peakKb(result, kLodsmith) / peakKb(result, kOgreCurvature);
    };
    for (const SubjectResult& result : results) {
        std::vector<std::string> cells{result.name, std::to_string(result.triangles)};
        for (const std::string& peer : peers)
            cells.push_back(fixed(peakKb(result, peer), 0));
        cells.push_back(fixed(ratio(result), 3));
        table.addRow(cells);
    }
    std::vector<std::string> means{"geometric mean", ""};
    for (const std::string& peer : peers)
        means.push_back(fixed(geometricMeanOf(results, [&](const auto& result) { return peakKb(result, peer); }), 0));
    means.push_back(fixed(geometricMeanOf(results, ratio), 3));
    table.addRow(means);
    table.print(out);
}

std::vector<std::string> namesOf(const std::vector<SubjectResult>& results)
{
    std::vector<std::string> names;
    for (const auto& peer : makePeers())
        if (std::any_of(results.begin(), results.end(), [&](const SubjectResult& result) {
                return result.seconds.count(peer->name()) || result.peakKb.count(peer->name())
                       || result.comparable.count(peer->name());
            }))
            names.push_back(peer->name());
    return names;
}

template <class Part>
bool anyHas(const std::vector<SubjectResult>& results, Part part)
{
    return std::any_of(results.begin(), results.end(),
                       [&](const SubjectResult& result) { return !(result.*part).empty(); });
}

} // namespace

void printTables(std::ostream& out, const std::vector<SubjectResult>& results)
{
    const std::vector<std::string> peers = namesOf(results);
    if (anyHas(results, &SubjectResult::seconds)) {
        printTimes(out, results, peers);
        printGrowth(out, results, peers);
    }
    if (anyHas(results, &SubjectResult::peakKb))
        printMemory(out, results, peers);
    if (anyHas(results, &SubjectResult::comparable))
        printQuality(out, results, peers);
    if (anyHas(results, &SubjectResult::chains))
        printTargets(out, results);
}

} // namespace lodsmith::benchmarks
