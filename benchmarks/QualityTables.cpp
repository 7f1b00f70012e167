#include "QualityTables.h"

#include "Figure.h"
#include "MarkdownTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>

namespace lodsmith::benchmarks {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kLevels = 4;
using LevelRatios = std::array<double, kLevels>;

bool has(const SubjectResult& subject, Figure figure)
{
    if (figure == Figure::MeanUv)
        return subject.hasUvs;
    return figure != Figure::MeanNormal || subject.hasNormals;
}

/// Ratios of `ours` to `theirs` level by level; NaN where one of them does not come to the target.
LevelRatios ratios(const SubjectResult& subject, const std::string& ours, const std::string& theirs, Figure figure)
{
    LevelRatios result;
    result.fill(kNone);
    const auto mine = subject.comparable.find(ours), other = subject.comparable.find(theirs);
    if (mine == subject.comparable.end() || other == subject.comparable.end() || !has(subject, figure))
        return result;
    for (std::size_t level = 0; level < std::min(kLevels, mine->second.size()); ++level)
        if (reached(mine->second[level]) && reached(other->second[level]))
            result[level] =
                figureRatio(*mine->second[level].deviation, *other->second[level].deviation, figure, subject.radius);
    return result;
}

void addRatios(std::vector<std::string>& cells, const LevelRatios& values)
{
    for (const double value : values)
        cells.push_back(fixed(value, 2));
}

/// The geometric mean of each level over the meshes that have a ratio there, then how many meshes these are.
void addMeans(std::vector<std::string>& cells, const std::vector<LevelRatios>& rows)
{
    std::string counts;
    for (std::size_t level = 0; level < kLevels; ++level) {
        std::vector<double> values;
        for (const LevelRatios& row : rows)
            if (!std::isnan(row[level]))
                values.push_back(row[level]);
        cells.push_back(fixed(geometricMean(values), 3));
        counts += (level ? "/" : "") + std::to_string(values.size());
    }
    cells.push_back(counts);
}

std::vector<LevelRatios> allRatios(const std::vector<SubjectResult>& results, const std::string& ours,
                                   const std::string& theirs, Figure figure)
{
    std::vector<LevelRatios> rows;
    for (const SubjectResult& result : results)
        rows.push_back(ratios(result, ours, theirs, figure));
    return rows;
}

constexpr std::pair<Figure, const char*> kFigures[] = {{Figure::MeanSurface, "mean surface"},
                                                       {Figure::MaximumSurface, "maximum surface"},
                                                       {Figure::MeanNormal, "mean normal"},
                                                       {Figure::MeanUv, "mean UV"}};

void printAgainstOgre(std::ostream& out, const std::vector<SubjectResult>& results,
                      const std::vector<std::string>& peers)
{
    out << "## Error at the triangle counts of ogre-curvature\n\n"
           "Two-sided deviation over that of ogre-curvature, geometric mean over the meshes whose level has the same\n"
           "number of triangles within 2%.\n\n";
    MarkdownTable table({"peer", "figure", "level 1", "level 2", "level 3", "level 4", "meshes"});
    for (const std::string& peer : peers) {
        if (peer == kOgreCurvature || peer == kLodsmithCore)
            continue;
        for (const auto& [figure, title] : kFigures) {
            std::vector<std::string> cells{peer, title};
            addMeans(cells, allRatios(results, peer, kOgreCurvature, figure));
            table.addRow(cells);
        }
    }
    table.print(out);
}

void printAgainstMeshoptimizer(std::ostream& out, const std::vector<SubjectResult>& results)
{
    out << "## Error at the triangle counts of meshoptimizer\n\n"
           "Lodsmith's deviation over meshoptimizer's at equal triangles, on the levels that meshoptimizer "
           "reaches.\n\n";
    MarkdownTable table({"figure", "level 1", "level 2", "level 3", "level 4", "meshes"});
    for (const auto& [figure, title] : kFigures) {
        std::vector<std::string> cells{title};
        addMeans(cells, allRatios(results, kLodsmithAtMeshoptimizer, kMeshoptimizer, figure));
        table.addRow(cells);
    }
    table.print(out);
}

void printByMesh(std::ostream& out, const std::vector<SubjectResult>& results)
{
    out << "## Mean surface deviation, mesh by mesh\n\nLodsmith over ogre-curvature and over meshoptimizer, levels 1 "
           "to 4.\n\n";
    MarkdownTable table({"mesh", "o 1", "o 2", "o 3", "o 4", "m 1", "m 2", "m 3", "m 4"});
    for (const SubjectResult& result : results) {
        std::vector<std::string> cells{result.name};
        addRatios(cells, ratios(result, kLodsmith, kOgreCurvature, Figure::MeanSurface));
        addRatios(cells, ratios(result, kLodsmithAtMeshoptimizer, kMeshoptimizer, Figure::MeanSurface));
        table.addRow(cells);
    }
    table.print(out);
}

constexpr std::pair<std::uint32_t Deviation::*, const char*> kFaults[] = {
    {&Deviation::newBorderEdges, "new border edges"},
    {&Deviation::flippedTriangles, "flipped triangles"},
    {&Deviation::repeatedTriangles, "repeated triangles"},
    {&Deviation::newNonManifoldEdges, "new non-manifold edges"},
    {&Deviation::degenerateTriangles, "degenerate triangles"}};

std::uint64_t faultsOf(const SubjectResult& result, const std::string& peer, std::uint32_t Deviation::*fault)
{
    const auto chain = result.comparable.find(peer);
    std::uint64_t sum = 0;
    if (chain != result.comparable.end())
        for (const MeasuredLevel& level : chain->second)
            sum += level.deviation ? (*level.deviation).*fault : 0;
    return sum;
}

std::string faultCell(const std::vector<SubjectResult>& results, const std::string& peer,
                      std::uint32_t Deviation::*fault)
{
    std::uint64_t sum = 0;
    int meshes = 0;
    for (const SubjectResult& result : results) {
        const std::uint64_t faults = faultsOf(result, peer, fault);
        sum += faults;
        meshes += faults > 0;
    }
    return std::to_string(sum) + " (" + std::to_string(meshes) + ")";
}

void printFaults(std::ostream& out, const std::vector<SubjectResult>& results, std::vector<std::string> peers)
{
    out << "## Faults\n\nSums over all levels of all meshes; in brackets the number of meshes that have any.\n\n";
    peers.erase(std::remove(peers.begin(), peers.end(), kLodsmithCore), peers.end());
    std::vector<std::string> header{"fault"};
    header.insert(header.end(), peers.begin(), peers.end());
    MarkdownTable table(header);
    for (const auto& [fault, title] : kFaults) {
        std::vector<std::string> cells{title};
        for (const std::string& peer : peers)
            cells.push_back(faultCell(results, peer, fault));
        table.addRow(cells);
    }
    table.print(out);
}

} // namespace

void printQuality(std::ostream& out, const std::vector<SubjectResult>& results, const std::vector<std::string>& peers)
{
    printAgainstOgre(out, results, peers);
    printAgainstMeshoptimizer(out, results);
    printByMesh(out, results);
    printFaults(out, results, peers);
}

void printTargets(std::ostream& out, const std::vector<SubjectResult>& results)
{
    out << "## Vertex targets that lodsmith misses by more than 1%\n\n";
    MarkdownTable table({"mesh", "level", "target", "vertices", "reason"});
    for (const SubjectResult& result : results) {
        const auto chain = result.chains.find(kLodsmith);
        if (chain == result.chains.end())
            continue;
        for (std::size_t i = 0; i < chain->second.size(); ++i) {
            const MeasuredLevel& level = chain->second[i];
            if (std::abs(double(level.vertices) - double(level.target)) > std::max(1.0, 0.01 * level.target))
                table.addRow({result.name, std::to_string(i + 1), std::to_string(level.target),
                              std::to_string(level.vertices), level.stop.empty() ? "none given" : level.stop});
        }
    }
    table.print(out);
}

} // namespace lodsmith::benchmarks
