#include "MeshReport.h"

#include "../CommandOptions.h"
#include "../CostRecord.h"
#include "../OgreSession.h"
#include "DrawnTriangles.h"
#include "JudgedMesh.h"
#include "LevelCurve.h"

#include <lodsmith/analysis/Deviation.h>
#include <lodsmith/analysis/MeshStatistics.h>
#include <lodsmith/ogre/LevelReader.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>
#include <lodsmith/ogre/SwitchDistance.h>

#include <OgreLodStrategy.h>
#include <OgreSubMesh.h>

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace lodsmith::cli {

namespace {

// Radii on the screen, in pixels, between which triangles are counted: from filling the picture's height to a speck.
constexpr double kNearPixels = 540.0, kFarPixels = 4.0;

Json figures(const DeviationFigures& figures)
{
    return Json{{"mean", figures.mean}, {"rms", figures.rms}, {"max", figures.maximum}};
}

Json statisticsRecord(const MeshStatistics& statistics)
{
    return Json{{"vertices", statistics.vertices},
                {"buffer_vertices", statistics.bufferVertices},
                {"unreferenced_vertices", statistics.unreferencedVertices},
                {"triangles", statistics.triangles},
                {"degenerate_triangles", statistics.degenerateTriangles},
                {"repeated_triangles", statistics.repeatedTriangles},
                {"edges", statistics.edges},
                {"border_edges", statistics.borderEdges},
                {"non_manifold_edges", statistics.nonManifoldEdges},
                {"inconsistent_edges", statistics.inconsistentEdges},
                {"uv_seam_edges", statistics.uvSeamEdges},
                {"normal_seam_edges", statistics.normalSeamEdges},
                {"components", statistics.components}};
}

/// Works on one mesh from loading it to the last warning.
class MeshReporter {
public:
    MeshReporter(const ReportSettings& settings, const JudgedMesh& judged, Progress& progress)
        : mSettings(settings), mJudged(judged), mProgress(progress)
    {
    }

    Result<Json> report()
    {
        for (const auto step : {&MeshReporter::load, &MeshReporter::measureLevels, &MeshReporter::addCost,
                                &MeshReporter::measureCurve, &MeshReporter::countDrawn})
            if (auto done = (this->*step)(); !done)
                return done.error();
        mRecord["notes"] = mNotes;
        return mRecord;
    }

private:
    Result<Done> load();
    Result<Done> measureLevels();
    Result<Json> levelRecord(unsigned level);
    Result<Done> measureCurve();
    Result<Done> countDrawn();
    std::vector<DrawnLevel> judgedLevels() const;
    Result<std::vector<DrawnLevel>> automaticLevels();
    Result<Done> addCost();

    /// Pixels that a length of one world unit has at a distance of one.
    double pixelsAtOne() const { return mView.height / 2.0 / std::tan(mView.fieldOfView / 2.0); }

    const ReportSettings& mSettings;
    const JudgedMesh& mJudged;
    Progress& mProgress;
    View mView;
    OgreSession mSession;
    Ogre::MeshPtr mMesh;
    std::shared_ptr<const MeshData> mLevelZero;
    double mRadius = 0.0;
    std::vector<std::string> mNotes;
    Json mRecord;
};

Result<Done> MeshReporter::load()
{
    const Result<Ogre::MeshPtr> mesh = mSession.load(mJudged.file);
    if (!mesh)
        return mesh.error();
    mMesh = mesh.value();
    const auto levelZero = LevelReader::readLevelZero(*mMesh);
    if (!levelZero)
        return levelZero.error();
    mLevelZero = levelZero.value();
    mNotes = mJudged.directory ? mJudged.notes : mLevelZero->notes();
    const Result<MeshStatistics> statistics = meshStatistics(mLevelZero->view());
    if (!statistics)
        return statistics.error();
    mRadius = statistics.value().radius;
    if (!(mRadius > 0.0))
        return Error{ErrorCode::InvalidGeometry, "has no triangle with an extent, so that there is nothing to judge"};
    mRecord["radius"] = mRadius;
    mRecord["statistics"] = statisticsRecord(statistics.value());
    mRecord["levels_from"] = mJudged.levelsFrom;
    mRecord["definition"] = mJudged.definition.empty() ? Json(nullptr) : Json(mJudged.definition);
    mRecord["strategy"] = mMesh->getLodStrategy()->getName();
    if (mJudged.stops.size() != mMesh->getNumLodLevels())
        return Error{ErrorCode::BadFile, "has other levels than were made"};
    return Done{};
}

Result<Done> MeshReporter::measureLevels()
{
    mRecord["levels"] = Json::array();
    const unsigned count = mMesh->getNumLodLevels();
    for (unsigned level = 0; level < count; ++level) {
        const Result<Json> record = levelRecord(level);
        if (!record)
            return record.error();
        mRecord["levels"].push_back(record.value());
        mProgress.report(0.6f * static_cast<float>(level + 1u) / static_cast<float>(count));
    }
    return Done{};
}

Result<Json> MeshReporter::levelRecord(unsigned level)
{
    const Result<LevelData> data = LevelReader::read(*mMesh, mLevelZero, level);
    if (!data)
        return data.error();
    const Result<MeshStatistics> statistics = meshStatistics(data.value().view());
    if (!statistics)
        return statistics.error();
    // Level 0 is what the others are compared with.
    Deviation deviation;
    if (level > 0) {
        const auto measured = measureDeviation(mLevelZero->view(), data.value().view(), {mSettings.samples, 1});
        if (!measured)
            return measured.error();
        deviation = measured.value();
    }
    const Ogre::MeshLodUsage& usage = mMesh->getLodLevel(static_cast<Ogre::ushort>(level));
    double distance = 0.0;
    if (level > 0) {
        const Result<double> from = switchDistance(*mMesh, static_cast<double>(usage.userValue), mView);
        if (!from)
            return from.error();
        distance = from.value();
        if (!(distance > 0.0))
            return Error{ErrorCode::InvalidGeometry, "has no bounding radius, by which its levels appear"};
    }
    // A level that never appears is nowhere, and off by nothing.
    const double pixels = level > 0 ? pixelsAtOne() / distance : 0.0;
    const double whole = mRecord["statistics"]["triangles"].get<double>();
    return Json{{"value", level == 0 ? Json(nullptr) : Json(usage.userValue)},
                {"distance", std::isfinite(distance) ? Json(distance) : Json(nullptr)},
                {"screen_radius", pixels > 0.0 ? Json(mRadius * pixels) : Json(nullptr)},
                {"vertices", statistics.value().vertices},
                {"triangles", statistics.value().triangles},
                {"share", whole > 0.0 ? Json(statistics.value().triangles / whole) : Json(nullptr)},
                {"surface", figures(deviation.surface)},
                {"normal", figures(deviation.normal)},
                {"uv", figures(deviation.uv)},
                {"visible_error", deviation.surface.maximum * pixels},
                {"flipped_triangles", deviation.flippedTriangles},
                {"new_border_edges", deviation.newBorderEdges},
                {"new_non_manifold_edges", deviation.newNonManifoldEdges},
                {"stop", mJudged.stops[level] ? Json(*mJudged.stops[level]) : Json(nullptr)},
                {"manual", usage.manualName.empty() ? Json(nullptr) : Json(usage.manualName)}};
}

Result<Done> MeshReporter::addCost()
{
    mRecord["cost"] = nullptr;
    mRecord["cost_now"] = nullptr;
    const Result<Json> cost = costRecord(*mMesh, mJudged.file, {}, mProgress);
    if (!cost) {
        mNotes.push_back("no streaming cost: " + cost.error().message);
        return Done{};
    }
    mRecord["cost"] = cost.value();
    mRecord["cost"].erase("optimised");
    mRecord["cost"].erase("files");
    if (!mJudged.directory) {
        mRecord["cost_now"] = cost.value()["cost"];
        return Done{};
    }
    const Result<Ogre::MeshPtr> mesh = mSession.load(mJudged.input);
    if (!mesh)
        return mesh.error();
    const Result<Json> now = costRecord(*mesh.value(), mJudged.input, {}, mProgress);
    if (now)
        mRecord["cost_now"] = now.value()["cost"];
    return Done{};
}

Result<Done> MeshReporter::measureCurve()
{
    const Result<LevelCurve> curve = levelCurve(mLevelZero->view(), mRadius);
    if (!curve)
        return curve.error();
    mRecord["curve"] = Json::array();
    for (const CurvePoint& point : curve.value().measured)
        mRecord["curve"].push_back(Json{{"triangles", point.triangles}, {"max", point.deviation}});
    mRecord["seam_factor"] = curve.value().seamFactor;
    mRecord["least_triangles"] = curve.value().least;
    mRecord["least_stop"] = toString(curve.value().leastStop);
    mProgress.report(0.9f);
    return Done{};
}

std::vector<DrawnLevel> MeshReporter::judgedLevels() const
{
    std::vector<DrawnLevel> levels;
    for (const Json& level : mRecord["levels"])
        if (level["distance"].is_number())
            levels.push_back({level["distance"].get<double>(), level["triangles"].get<double>()});
    return levels;
}

Result<std::vector<DrawnLevel>> MeshReporter::automaticLevels()
{
    if (mJudged.levelsFrom == "automatic")
        return judgedLevels();
    const Result<LodReport> report = ProgressiveMeshGenerator().generateAutoconfiguredLodLevels(mMesh, &mProgress);
    if (!report)
        return report.error();
    std::vector<DrawnLevel> levels{judgedLevels().front()};
    for (const LodLevelReport& level : report.value().levels) {
        if (level.skipped)
            continue;
        const Result<double> distance = switchDistance(*mMesh, static_cast<double>(level.value), mView);
        if (!distance)
            return distance.error();
        if (std::isfinite(distance.value()))
            levels.push_back({distance.value(), static_cast<double>(level.triangles)});
    }
    return levels;
}

Result<Done> MeshReporter::countDrawn()
{
    std::vector<DrawnLevel> now = judgedLevels();
    if (mJudged.levelsFrom != "file")
        now.resize(1);
    const Result<std::vector<DrawnLevel>> automatic = automaticLevels();
    if (!automatic)
        return automatic.error();
    const double near = mRadius * pixelsAtOne() / kNearPixels, far = mRadius * pixelsAtOne() / kFarPixels;
    const double before = meanTriangles(now, near, far), after = meanTriangles(automatic.value(), near, far);
    double from = near;
    const double excess = worstExcess(now, automatic.value(), near, far, from);
    Json levels = Json::array();
    for (const DrawnLevel& level : automatic.value())
        levels.push_back(Json{{"distance", level.distance}, {"triangles", level.triangles}});
    mRecord["drawn"] = Json{{"near", near},
                            {"far", far},
                            {"now", before},
                            {"automatic", after},
                            {"saved", before - after},
                            {"worst_excess", excess},
                            {"worst_excess_from", from}};
    mRecord["automatic_levels"] = std::move(levels);
    return Done{};
}

} // namespace

Result<Json> reportMesh(const ReportSettings& settings, const PlannedFile& file, Progress& progress)
{
    const Result<JudgedMesh> judged = judgedMesh(file, progress);
    if (!judged)
        return judged.error();
    Json record{{"file_bytes", fileBytes(file.input)}};
    const Result<Json> figures = MeshReporter(settings, judged.value(), progress).report();
    if (!figures) {
        Error error = figures.error();
        // The temporary file is nothing that people know.
        if (judged.value().directory && error.file == judged.value().file)
            error.file = file.input.string();
        return error;
    }
    record.update(figures.value());
    return record;
}

} // namespace lodsmith::cli
