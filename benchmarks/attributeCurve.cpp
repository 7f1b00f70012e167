// Geometry against attributes: errors of Metric::Quadric over its attribute weights, at OGRE's triangle counts.

#include "Figure.h"
#include "MarkdownTable.h"
#include "OgreSession.h"
#include "Quality.h"
#include "StoredLevels.h"
#include "Timing.h"

#include <lodsmith/analysis/MeshStatistics.h>

#include <CLI/CLI.hpp>

#include <iostream>
#include <regex>

namespace lodsmith::benchmarks {

namespace {

struct Arguments {
    std::string filter = ".*";
    std::vector<std::string> media;
    std::vector<float> normals{0.0f, 0.01f, 0.02f, 0.05f, 0.1f, 0.2f, 0.5f};
    std::vector<float> uvs{0.0f, 0.01f, 0.02f, 0.05f, 0.1f, 0.2f, 0.5f, 1.0f, 2.0f};
    std::uint32_t mostTriangles = 100000;
    DeviationOptions deviation;
    bool grid = false;
};

/// One point of the curve: weights, and the ratios to ogre-curvature over all meshes, level by level.
struct CurvePoint {
    AttributeWeights weights;
    std::vector<double> surface[4];
    std::vector<double> maximum;
    std::vector<double> normal;
    std::vector<double> uv;
};

/// One weight at a time around the defaults, or every pair of them.
std::vector<CurvePoint> makeCurve(const Arguments& arguments)
{
    std::vector<CurvePoint> curve;
    const auto add = [&](float normal, float uv) {
        CurvePoint& point = curve.emplace_back();
        point.weights.normal = normal;
        point.weights.uv = uv;
    };
    const AttributeWeights defaults;
    add(defaults.normal, defaults.uv);
    if (arguments.grid) {
        for (const float normal : arguments.normals)
            for (const float uv : arguments.uvs)
                add(normal, uv);
        return curve;
    }
    for (const float normal : arguments.normals)
        add(normal, defaults.uv);
    for (const float uv : arguments.uvs)
        add(defaults.normal, uv);
    return curve;
}

std::vector<PeerLevel> chainAt(const Subject& subject, const std::vector<std::uint32_t>& counts,
                               const AttributeWeights& weights)
{
    SimplifyOptions options;
    options.weights = weights;
    const Result<LodChain> chain = simplify(subject.view(), targetsOf(atTriangles(counts)), options);
    if (!chain)
        throw std::runtime_error(describe(chain.error()));
    return chainLevels(subject.view(), chain.value());
}

void addRatios(CurvePoint& point, const Subject& subject, double radius, const std::vector<MeasuredLevel>& ours,
               const std::vector<MeasuredLevel>& ogre)
{
    for (std::size_t level = 0; level < ours.size(); ++level) {
        if (!reached(ours[level], ogre[level].triangles) || !ogre[level].deviation)
            continue;
        const Deviation& mine = *ours[level].deviation;
        const Deviation& theirs = *ogre[level].deviation;
        point.surface[level].push_back(figureRatio(mine, theirs, Figure::MeanSurface, radius));
        point.maximum.push_back(figureRatio(mine, theirs, Figure::MaximumSurface, radius));
        if (subject.hasNormals())
            point.normal.push_back(figureRatio(mine, theirs, Figure::MeanNormal, radius));
        if (subject.hasUvs())
            point.uv.push_back(figureRatio(mine, theirs, Figure::MeanUv, radius));
    }
}

void measureSubject(const Arguments& arguments, Peer& ogre, Subject& subject, std::vector<CurvePoint>& curve)
{
    const Result<MeshStatistics> statistics = meshStatistics(subject.view());
    if (!statistics)
        throw std::runtime_error(describe(statistics.error()));
    ogre.generate(subject, halvings());
    const std::vector<PeerLevel> ogreLevels = ogre.levels(subject);
    ogre.reset(subject);
    std::vector<std::uint32_t> counts;
    for (const PeerLevel& level : ogreLevels)
        counts.push_back(triangleCount(level.indices));
    const auto theirs = measureLevels(subject, ogreLevels, arguments.deviation);
    for (CurvePoint& point : curve) {
        const auto levels = chainAt(subject, counts, point.weights);
        addRatios(point, subject, statistics.value().radius, measureLevels(subject, levels, arguments.deviation),
                  theirs);
    }
}

void printCurve(const std::vector<CurvePoint>& curve)
{
    MarkdownTable table({"normal weight", "UV weight", "surface 1", "surface 2", "surface 3", "surface 4", "maximum",
                         "normal", "UV", "levels"});
    for (const CurvePoint& point : curve) {
        std::vector<std::string> cells{fixed(point.weights.normal, 3), fixed(point.weights.uv, 3)};
        for (const auto& level : point.surface)
            cells.push_back(fixed(geometricMean(level), 3));
        for (const auto* figures : {&point.maximum, &point.normal, &point.uv})
            cells.push_back(fixed(geometricMean(*figures), 3));
        cells.push_back(std::to_string(point.maximum.size()));
        table.addRow(cells);
    }
    std::cout << "Deviation over that of ogre-curvature at its triangle counts, geometric means; the first row has the "
                 "default weights.\n\n";
    table.print(std::cout);
}

int run(const Arguments& arguments)
{
    const OgreSession session;
    const auto peers = makePeers();
    std::vector<CurvePoint> curve = makeCurve(arguments);
    const std::regex filter(arguments.filter);
    bool good = true;
    for (const SubjectSource& source : allSubjects(arguments.media)) {
        if (!std::regex_search(source.name, filter))
            continue;
        try {
            const std::unique_ptr<Subject> subject = source.load();
            if (subject->triangles() > arguments.mostTriangles)
                continue;
            std::cerr << source.name << '\n';
            measureSubject(arguments, *peers.front(), *subject, curve);
        } catch (const std::exception& error) {
            std::cerr << source.name << ": " << error.what() << '\n';
            good = false;
        }
    }
    printCurve(curve);
    return good ? 0 : 1;
}

} // namespace

} // namespace lodsmith::benchmarks

int main(int argc, char** argv)
{
    using namespace lodsmith::benchmarks;
    Arguments arguments;
    arguments.deviation.samples = 30000;
    CLI::App app{"Shows how geometric and attribute errors trade against each other over the attribute weights."};
    app.add_option("--filter", arguments.filter, "only meshes whose name matches this regular expression");
    app.add_option("--media", arguments.media, "further directories of .mesh files");
    app.add_option("--normals", arguments.normals, "weights of the normal")->delimiter(',');
    app.add_option("--uvs", arguments.uvs, "weights of the texture coordinates")->delimiter(',');
    app.add_option("--most-triangles", arguments.mostTriangles, "leave larger meshes out");
    app.add_option("--samples", arguments.deviation.samples, "points on each surface");
    app.add_flag("--grid", arguments.grid, "every pair of weights instead of one at a time");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(arguments);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
