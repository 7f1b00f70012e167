#include "SeparateFoliage.h"

#include "Numbers.h"

#include <lodsmith/analysis/Coverage.h>
#include <lodsmith/analysis/MeshStatistics.h>
#include <lodsmith/generators/FoliageLevels.h>
#include <lodsmith/ogre/FoliageMesh.h>
#include <lodsmith/ogre/LevelReader.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace lodsmith::cli {

namespace {

constexpr double kEnoughKept = 0.95;
// A closed surface has half as many vertices as triangles, cards have twice as many: saves looking for leaves where
// none are.
constexpr double kVerticesPerTriangle = 0.6;

std::string percent(double share)
{
    return formatNumber(100.0 * share, 3) + " %";
}

class FoliageTreatment {
public:
    FoliageTreatment(const MeshPlan& plan, const LodReport& report, const PlannedFile& file, const MeshFormat& format,
                     Progress& progress)
        : mPlan(plan), mMesh(*plan.config.mesh), mReport(report), mFile(file), mFormat(format), mProgress(progress)
    {
    }

    Result<FoliageReport> treat(bool permitted)
    {
        Result<std::shared_ptr<const MeshData>> data = LevelReader::readLevelZero(mMesh);
        if (!data)
            return data.error();
        mData = std::move(data).value();
        const Result<FoliageLevels> found = foliageLevels(mData->view(), {}, {}, &mProgress);
        if (!found)
            return found.error();
        if (found.value().leaves == 0)
            return FoliageReport{};
        Result<CoverageMeter> meter = CoverageMeter::of(mData->view());
        if (!meter)
            return meter.error();
        mMeter = std::make_unique<CoverageMeter>(std::move(meter).value());
        if (auto measured = measureGenerated(); !measured)
            return measured.error();
        if (!permitted)
            noteLosses();
        else if (auto replaced = replaceThin(); !replaced)
            return replaced.error();
        return std::move(mTreated);
    }

private:
    Result<Done> measureGenerated()
    {
        unsigned stored = 0;
        for (std::size_t i = 0; i < mReport.levels.size(); ++i) {
            const LodLevelReport& level = mReport.levels[i];
            stored += level.skipped ? 0 : 1;
            if (level.skipped || level.manual)
                continue;
            const Result<LevelData> data = LevelReader::read(mMesh, mData, stored);
            if (!data)
                return data.error();
            const Result<Coverage> coverage = mMeter->measure(data.value().view());
            if (!coverage)
                return coverage.error();
            FoliageRecord& record = mTreated.levels[i];
            record.kept = record.keptByIndices = coverage.value().kept;
            mStored[i] = stored;
        }
        return Done{};
    }

    /// Under which number people know a level of the report: candidates that were not chosen are not shown.
    std::size_t shownNumber(std::size_t number) const
    {
        return mPlan.config.mostLevels > 0 ? mStored.at(number) : number + 1;
    }

    void noteLosses()
    {
        for (const auto& [i, record] : mTreated.levels)
            if (record.kept < kEnoughKept)
                mTreated.notes.push_back(
                    "level " + std::to_string(shownNumber(i)) + " covers " + percent(record.kept)
                    + " of what the mesh does, for leaves are gone; --separate-meshes would let it "
                      "have larger ones");
    }

    Result<Done> replaceThin()
    {
        std::vector<std::size_t> thin;
        std::vector<std::uint32_t> triangles;
        for (const auto& [i, record] : mTreated.levels)
            if (record.kept < kEnoughKept) {
                thin.push_back(i);
                triangles.push_back(mReport.levels[i].triangles);
            }
        const Result<FoliageLevels> made = foliageLevels(mData->view(), triangles, options(), &mProgress);
        if (!made)
            return made.error();
        for (std::size_t i = 0; i < thin.size(); ++i)
            if (auto replaced = replaceIfBetter(thin[i], made.value().levels[i]); !replaced)
                return replaced;
        return Done{};
    }

    FoliageOptions options() const
    {
        FoliageOptions options;
        options.simplify = mPlan.config.options;
        return options;
    }

    Result<Done> replaceIfBetter(std::size_t number, const FoliageLevel& level)
    {
        if (!level.made)
            return Done{};
        const MeshView view = level.view(mData->view());
        const Result<Coverage> coverage = mMeter->measure(view);
        if (!coverage)
            return coverage.error();
        FoliageRecord& record = mTreated.levels[number];
        if (coverage.value().kept <= record.kept)
            return Done{};
        const Result<MeshStatistics> statistics = meshStatistics(view);
        if (!statistics)
            return statistics.error();
        const std::string name = separateName(mFile.output, shownNumber(number));
        if (mPlan.handMade.count(name) > 0)
            return Error{ErrorCode::InvalidSetting, "level " + std::to_string(shownNumber(number)) + " would be '"
                                                        + name
                                                        + "' beside the output, as a hand-made level is already"};
        if (auto written = attach(number, level, name); !written)
            return written;
        record.kept = coverage.value().kept;
        record.file = name;
        record.vertices = statistics.value().vertices;
        record.triangles = statistics.value().triangles;
        record.bytes = mTreated.files.back().content->size();
        return Done{};
    }

    Result<Done> attach(std::size_t number, const FoliageLevel& level, const std::string& name)
    {
        const Result<Ogre::MeshPtr> mesh = makeFoliageMesh(mMesh, *mData, level, name);
        if (!mesh)
            return mesh.error();
        Result<std::string> bytes = meshBytes(*mesh.value(), mFormat);
        if (!bytes)
            return bytes.error();
        mTreated.files.push_back({mFile.input, name, std::move(bytes).value()});
        return replaceLevel(mMesh, mStored[number], mesh.value());
    }

    const MeshPlan& mPlan;
    Ogre::Mesh& mMesh;
    const LodReport& mReport;
    const PlannedFile& mFile;
    const MeshFormat& mFormat;
    Progress& mProgress;
    std::shared_ptr<const MeshData> mData;
    std::unique_ptr<CoverageMeter> mMeter;
    std::map<std::size_t, unsigned> mStored; // OGRE's number of each level
    FoliageReport mTreated;
};

} // namespace

std::string separateName(const std::filesystem::path& output, std::size_t level)
{
    return output.stem().string() + ".lod" + std::to_string(level) + ".mesh";
}

std::string stemOfSeparate(const std::filesystem::path& file)
{
    const std::string name = file.filename().string();
    const std::size_t mark = name.rfind(".lod");
    if (mark == std::string::npos || file.extension() != ".mesh")
        return {};
    const std::size_t number = mark + 4, end = name.size() - 5;
    const bool isNumber =
        number < end && std::all_of(&name[number], &name[end], [](char c) { return c >= '0' && c <= '9'; });
    return isNumber ? name.substr(0, mark) : std::string();
}

Result<FoliageReport> treatFoliage(const MeshPlan& plan, const LodReport& report, const PlannedFile& file,
                                   const MeshFormat& format, bool permitted, Progress& progress)
{
    if (!permitted && report.vertices < kVerticesPerTriangle * report.triangles)
        return FoliageReport{};
    return FoliageTreatment(plan, report, file, format, progress).treat(permitted);
}

} // namespace lodsmith::cli
