#include "Comparison.h"

#include "Statistics.h"

#include "../Peer.h"
#include "../Timing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith::benchmarks {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kLeastChance = 0.01;
// Logarithms of ratios.
const double kLeastMeanChange = std::log(1.05);
const double kLeastMeshChange = std::log(1.10);
constexpr double kSpreads = 4.0;
/// What single times vary by where there are too few other generators' to tell, and at least.
constexpr double kUnknownSpread = 0.05, kLeastSpread = 0.015;
constexpr std::size_t kEnoughForSpread = 6;
constexpr double kLeastMemoryShare = 1.1, kLeastMemoryKb = 1024.0;
constexpr double kLevelTolerance = 1.01, kMeanTolerance = 1.001;

bool isOurs(const RunKey& key)
{
    return key.generator.rfind("lodsmith", 0) == 0;
}

struct Pair {
    const RunKey* key = nullptr;
    const StoredRun* before = nullptr;
    const StoredRun* after = nullptr;
};

std::vector<Pair> pairsOf(const StoredRuns& before, const StoredRuns& after)
{
    std::vector<Pair> pairs;
    for (const auto& [key, run] : before)
        if (const auto other = after.find(key); other != after.end())
            pairs.push_back({&key, &run, &other->second});
    return pairs;
}

bool hasReference(const StoredRun& run)
{
    return !run.reference.empty() && run.reference.size() == run.processor.size();
}

/// Times as shares of the reference.
std::vector<double> shares(const StoredRun& run)
{
    std::vector<double> values;
    for (std::size_t i = 0; i < run.processor.size(); ++i)
        values.push_back(run.processor[i] / run.reference[i]);
    return values;
}

/// One run's time then and now.
struct TimePair {
    Pair runs;
    double change = 0.0; ///< logarithm of new over old
    double chance = 1.0; ///< that the rounds differ by chance
    double leastChance = 1.0;
};

std::vector<TimePair> timePairs(const std::vector<Pair>& pairs)
{
    std::vector<TimePair> times;
    for (const Pair& pair : pairs)
        if (hasReference(*pair.before) && hasReference(*pair.after)) {
            const std::vector<double> old = shares(*pair.before), now = shares(*pair.after);
            times.push_back({pair, std::log(median(now) / median(old)), rankTest(old, now),
                             leastRankChance(old.size(), now.size())});
        }
    return times;
}

/// How the machine has changed, from the generators that have not. Meshoptimizer is the reference itself.
void measureMachine(const std::vector<TimePair>& times, Comparison& comparison)
{
    std::vector<double> changes;
    for (const TimePair& time : times)
        if (!isOurs(*time.runs.key) && time.runs.key->generator != kMeshoptimizer)
            changes.push_back(time.change);
    comparison.shift = changes.empty() ? 0.0 : median(changes);
    comparison.spread =
        changes.size() < kEnoughForSpread ? kUnknownSpread : std::max(kLeastSpread, robustSpread(changes));
}

Verdict verdictOf(double change, double least, double chance)
{
    if (chance >= kLeastChance || std::abs(change) <= least)
        return Verdict::Same;
    return change > 0.0 ? Verdict::Worse : Verdict::Better;
}

void compareMeanTimes(const std::vector<TimePair>& times, Comparison& comparison)
{
    std::map<std::pair<std::string, std::string>, std::vector<double>> changes;
    for (const TimePair& time : times)
        if (isOurs(*time.runs.key))
            changes[{time.runs.key->configuration, time.runs.key->generator}].push_back(time.change);
    std::vector<double> chances;
    for (const auto& [name, values] : changes)
        chances.push_back(signTest(values));
    chances = correctedForMany(chances);
    for (const auto& [name, values] : changes) {
        TimeChange change{name.first, name.second, values.size()};
        double sum = 0.0;
        for (const double value : values)
            sum += value;
        const double mean = sum / double(values.size());
        change.ratio = std::exp(mean);
        change.chance = chances[comparison.times.size()];
        change.verdict = verdictOf(mean, kLeastMeanChange + std::abs(comparison.shift), change.chance);
        comparison.times.push_back(std::move(change));
    }
}

/// Runs with so few rounds that chance could explain everything are no questions (Tarone 1990).
void compareSingleTimes(const std::vector<TimePair>& times, Comparison& comparison)
{
    std::vector<const TimePair*> asked;
    std::size_t tooFew = 0;
    for (const TimePair& time : times)
        if (isOurs(*time.runs.key)) {
            const bool able = time.leastChance * double(times.size()) < kLeastChance;
            tooFew += !able;
            if (able)
                asked.push_back(&time);
        }
    if (tooFew > 0)
        comparison.notes.push_back(std::to_string(tooFew)
                                   + " runs have too few rounds to say something of a single mesh.");
    std::vector<double> chances;
    for (const TimePair* time : asked)
        chances.push_back(time->chance);
    chances = correctedForMany(chances);
    const double least = std::max(kLeastMeshChange, kSpreads * comparison.spread) + std::abs(comparison.shift);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto& [key, before, after] = asked[i]->runs;
        const Verdict verdict = verdictOf(asked[i]->change, least, chances[i]);
        if (verdict != Verdict::Same)
            comparison.meshes.push_back({*key, "ms", 1000.0 * median(before->processor),
                                         1000.0 * median(after->processor), std::exp(asked[i]->change), chances[i],
                                         verdict});
    }
}

void compareMemory(const std::vector<Pair>& pairs, Comparison& comparison)
{
    for (const auto& [key, before, after] : pairs) {
        if (!isOurs(*key) || !before->peakKb || !after->peakKb)
            continue;
        const double old = *before->peakKb, now = *after->peakKb, less = std::min(old, now), more = std::max(old, now);
        if (more > kLeastMemoryShare * less && more - less > kLeastMemoryKb)
            comparison.meshes.push_back(
                {*key, "kB", old, now, now / std::max(1.0, old), 0.0, now > old ? Verdict::Worse : Verdict::Better});
    }
}

bool isFault(std::size_t figure)
{
    return figure >= static_cast<std::size_t>(LevelFigure::NewBorderEdges);
}

/// Below it there is only the rounding of stored floats.
double floorOf(std::size_t figure, double radius)
{
    switch (static_cast<LevelFigure>(figure)) {
    case LevelFigure::SurfaceMean:
    case LevelFigure::SurfaceRms:
    case LevelFigure::SurfaceMaximum: return 1e-6 * radius;
    case LevelFigure::NormalMean:
    case LevelFigure::NormalRms:
    case LevelFigure::NormalMaximum: return 1e-4;
    case LevelFigure::UvMean:
    case LevelFigure::UvRms:
    case LevelFigure::UvMaximum: return 1e-5;
    case LevelFigure::VisiblePixels: return 1e-3;
    default: return 1.0;
    }
}

/// Adds a level to the change of a figure; `sum` is that of the logarithms of ratios.
void addLevel(FigureChange& change, double& sum, std::size_t figure, const Pair& pair, int level, double old,
              double now)
{
    ++change.levels;
    double loss = now - old; // of a fault: how many more
    bool isWorse = loss > 0.0, isBetter = loss < 0.0;
    if (!isFault(figure)) {
        const double least = floorOf(figure, pair.before->meshRadius);
        loss = std::max(least, now) / std::max(least, old);
        sum += std::log(loss);
        isWorse = loss > kLevelTolerance;
        isBetter = loss < 1.0 / kLevelTolerance;
    }
    change.better += isBetter;
    change.worse += isWorse;
    if (isWorse && (change.worstLevel.empty() || loss > change.worst)) {
        change.worst = loss;
        change.worstLevel = pair.key->mesh + ' ' + std::to_string(level);
    }
}

FigureChange compareFigure(const std::vector<const Pair*>& pairs, std::size_t figure)
{
    FigureChange change;
    change.configuration = pairs.front()->key->configuration;
    change.generator = pairs.front()->key->generator;
    change.figure = nameOf(static_cast<LevelFigure>(figure));
    double sum = 0.0;
    for (const Pair* pair : pairs)
        for (const auto& [number, old] : pair->before->levels) {
            const auto now = pair->after->levels.find(number);
            if (now != pair->after->levels.end() && !std::isnan(old[figure]) && !std::isnan(now->second[figure]))
                addLevel(change, sum, figure, *pair, number, old[figure], now->second[figure]);
        }
    change.ratio = isFault(figure) ? kUnknown : std::exp(sum / double(std::max<std::size_t>(1, change.levels)));
    if (change.worse > 0 || change.ratio > kMeanTolerance)
        change.verdict = Verdict::Worse;
    else if (change.better > 0 || change.ratio < 1.0 / kMeanTolerance)
        change.verdict = Verdict::Better;
    return change;
}

void compareFigures(const std::vector<Pair>& pairs, Comparison& comparison)
{
    std::map<std::pair<std::string, std::string>, std::vector<const Pair*>> groups;
    for (const Pair& pair : pairs)
        if (isOurs(*pair.key))
            groups[{pair.key->configuration, pair.key->generator}].push_back(&pair);
    for (const auto& [name, group] : groups)
        for (std::size_t figure = 0; figure < kLevelFigures; ++figure)
            if (FigureChange change = compareFigure(group, figure); change.verdict != Verdict::Same)
                comparison.figures.push_back(std::move(change));
}

/// What one side has and the other has not, and what fails on one side.
void compareExtent(const std::vector<Pair>& pairs, const StoredRuns& before, const StoredRuns& after,
                   Comparison& comparison)
{
    std::size_t levels = 0;
    for (const auto& [key, old, now] : pairs) {
        if (!isOurs(*key))
            continue;
        ++comparison.compared;
        levels += !old->failed && !now->failed && old->levels.size() != now->levels.size();
        if (old->failed != now->failed)
            comparison.meshes.push_back({*key, "failures", double(old->failed), double(now->failed), kUnknown, 0.0,
                                         now->failed ? Verdict::Worse : Verdict::Better});
    }
    const auto note = [&](std::size_t count, const std::string& what) {
        if (count > 0)
            comparison.notes.push_back(std::to_string(count) + what);
    };
    note(before.size() - pairs.size(), " runs are old only.");
    note(after.size() - pairs.size(), " runs are new only.");
    note(levels, " meshes have another number of levels; those that both have are compared.");
}

} // namespace

bool Comparison::hasRegression() const
{
    const auto isWorse = [](const auto& change) { return change.verdict == Verdict::Worse; };
    return std::any_of(times.begin(), times.end(), isWorse) || std::any_of(meshes.begin(), meshes.end(), isWorse)
           || std::any_of(figures.begin(), figures.end(), isWorse);
}

Comparison compare(const StoredRuns& before, const StoredRuns& after, bool sameMachine)
{
    Comparison comparison;
    const std::vector<Pair> pairs = pairsOf(before, after);
    compareExtent(pairs, before, after, comparison);
    if (sameMachine) {
        const std::vector<TimePair> times = timePairs(pairs);
        measureMachine(times, comparison);
        compareMeanTimes(times, comparison);
        compareSingleTimes(times, comparison);
        compareMemory(pairs, comparison);
    } else {
        comparison.notes.emplace_back("Measured on different machines: times and memory are not compared.");
    }
    compareFigures(pairs, comparison);
    return comparison;
}

} // namespace lodsmith::benchmarks
