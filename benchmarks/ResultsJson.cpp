#include "ResultsJson.h"

#include <nlohmann/json.hpp>

#include <ostream>

namespace lodsmith::benchmarks {

namespace {

using nlohmann::json;

json figuresJson(const DeviationFigures& figures)
{
    return {{"mean", figures.mean}, {"rms", figures.rms}, {"maximum", figures.maximum}};
}

json deviationJson(const Deviation& deviation)
{
    return {{"surface", figuresJson(deviation.surface)},
            {"normal", figuresJson(deviation.normal)},
            {"uv", figuresJson(deviation.uv)},
            {"flipped_triangles", deviation.flippedTriangles},
            {"new_border_edges", deviation.newBorderEdges},
            {"new_non_manifold_edges", deviation.newNonManifoldEdges},
            {"repeated_triangles", deviation.repeatedTriangles},
            {"degenerate_triangles", deviation.degenerateTriangles}};
}

json chainsJson(const MeasuredChains& chains)
{
    json object = json::object();
    for (const auto& [peer, levels] : chains)
        for (const MeasuredLevel& level : levels)
            object[peer].push_back({{"target", level.target},
                                    {"triangles", level.triangles},
                                    {"vertices", level.vertices},
                                    {"stop", level.stop},
                                    {"deviation", level.deviation ? deviationJson(*level.deviation) : json()}});
    return object;
}

} // namespace

void writeJson(std::ostream& out, const std::vector<SubjectResult>& results)
{
    json document = json::array();
    for (const SubjectResult& result : results)
        document.push_back({{"mesh", result.name},
                            {"triangles", result.triangles},
                            {"vertices", result.vertices},
                            {"radius", result.radius},
                            {"seconds", result.seconds},
                            {"peak_kb", result.peakKb},
                            {"at_vertex_targets", chainsJson(result.chains)},
                            {"at_ogre_triangles", chainsJson(result.comparable)}});
    out << document.dump(1) << '\n';
}

} // namespace lodsmith::benchmarks
