#include "Analysis.h"

#include "Definition.h"
#include <lodsmith/lua/Numbers.h>

#include <cmath>
#include <utility>
#include <vector>

namespace lodsmith::lua {

namespace {

Table deviationTable(const Deviation& deviation)
{
    Table table;
    table.set("mean", deviation.surface.mean)
        .set("rms", deviation.surface.rms)
        .set("maximum", deviation.surface.maximum)
        .set("normalMean", deviation.normal.mean)
        .set("uvMean", deviation.uv.mean)
        .set("flipped", deviation.flippedTriangles)
        .set("newBorderEdges", deviation.newBorderEdges);
    return table;
}

Table curveTable(const std::vector<LevelPoint>& points)
{
    Table table;
    for (const LevelPoint& point : points) {
        Table entry;
        entry.set("triangles", point.triangles).set("vertices", point.vertices).set("deviation", point.deviation);
        table.add(std::move(entry));
    }
    return table;
}

/// Gives a Lua function what there is, or nil and why there is nothing.
template <class Figures, class ToTable>
LevelAnalyser::Callback<Figures> callbackWith(const Function& function, ToTable toTable)
{
    return [callback = std::make_shared<Callback>(function), toTable](const Result<Figures>& figures) {
        (*callback)(figures ? Returned(toTable(figures.value())) : Returned(figures.error()));
    };
}

Returned jobOrError(Result<LevelAnalyser::JobPtr> job)
{
    if (!job)
        return job.error();
    return std::make_unique<Job>(std::move(job).value());
}

bool isWholeWithin(double number, double least, double most)
{
    return number >= least && number <= most && number == std::floor(number);
}

} // namespace

Analysis::Analysis(const std::shared_ptr<Services>& services)
    : ServiceHandle("lodsmith::Analysis", "analysis", services)
{
}

Returned Analysis::measure(const Mesh& handle, double level, const Function& function) const
{
    return withMesh(handle, [&](Services& services, const Ogre::MeshPtr& mesh) -> Returned {
        if (!isWholeWithin(level, 0, mesh->getNumLodLevels() - 1))
            return Returned::failure("there is no level " + numberText(level) + " on the mesh");
        return jobOrError(services.analyser.measure(mesh, static_cast<unsigned>(level),
                                                    callbackWith<Deviation>(function, deviationTable)));
    });
}

Returned Analysis::curve(const Mesh& handle, const Definition& definition, double points,
                         const Function& function) const
{
    return withMesh(handle, [&](Services& services, const Ogre::MeshPtr& mesh) -> Returned {
        if (!isWholeWithin(points, 1, kMaxCurvePoints))
            return Returned::failure(numberText(points) + " is no number of points, 1 to "
                                     + std::to_string(kMaxCurvePoints));
        return jobOrError(services.analyser.curve(mesh, simplifyOptions(definition.data()),
                                                  static_cast<unsigned>(points),
                                                  callbackWith<std::vector<LevelPoint>>(function, curveTable)));
    });
}

Job::Job(LevelAnalyser::JobPtr job) : Handle("lodsmith::Job"), mJob(std::move(job)) {}

Returned Job::cancel()
{
    mJob->cancel();
    return true;
}

} // namespace lodsmith::lua
