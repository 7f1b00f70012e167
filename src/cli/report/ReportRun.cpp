#include "ReportRun.h"

#include "../../files/TemporaryDirectory.h"
#include "../CommandOptions.h"
#include "../DefinitionFiles.h"
#include "HtmlText.h"
#include "MeshPage.h"
#include "OverviewPage.h"
#include "PictureJob.h"
#include "ReportWarnings.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <set>
#include <utility>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

constexpr const char* kFront = "index.html";
constexpr std::size_t kLongestName = 120;

/// A file name of letters that need no care anywhere, not yet taken.
std::string pageName(const fs::path& path, std::set<std::string>& taken)
{
    std::string plain = path.generic_string();
    std::transform(plain.begin(), plain.end(), plain.begin(), [](unsigned char c) {
        const bool isPlain = c < 0x80 && (std::isalnum(c) || c == '-' || c == '.');
        return isPlain ? static_cast<char>(c) : '_';
    });
    if (plain.size() > kLongestName)
        plain.erase(0, plain.size() - kLongestName);
    std::string name = plain;
    for (int number = 2; !taken.insert(name).second; ++number)
        name = std::string(plain).append("-").append(std::to_string(number));
    return "pages/" + name + ".html";
}

Json totalsOf(const Json& meshes)
{
    std::size_t failed = 0, withoutLevels = 0, aboveBudget = 0, warnings = 0;
    double now = 0.0, saved = 0.0;
    for (const Json& mesh : meshes) {
        if (!mesh["error"].is_null()) {
            ++failed;
            continue;
        }
        withoutLevels += mesh["levels_from"] == "file" ? 0 : 1;
        aboveBudget += largestVisibleError(mesh) > mesh["pixel_budget"].get<double>() ? 1 : 0;
        warnings += mesh["warnings"].size();
        now += mesh["drawn"]["now"].get<double>();
        saved += std::max(mesh["drawn"]["saved"].get<double>(), 0.0);
    }
    return Json{{"meshes", meshes.size()},
                {"failed", failed},
                {"without_levels", withoutLevels},
                {"above_budget", aboveBudget},
                {"warnings", warnings},
                {"drawn_now", now},
                {"saved", saved}};
}

bool hasDisplay()
{
    const char* display = std::getenv("DISPLAY");
    return display && *display;
}

} // namespace

Result<std::vector<ReportPage>> planPages(const std::vector<std::string>& inputs, const std::string& output)
{
    std::vector<ReportPage> pages;
    std::set<std::string> taken;
    std::set<fs::path> known;
    std::error_code ignored;
    const bool isAlone = inputs.size() == 1 && !fs::is_directory(inputs.front(), ignored);
    for (const std::string& input : inputs) {
        // One at a time: that two have files of one name does no harm here.
        Result<std::vector<PlannedFile>> plan = planOutputs({input}, (fs::path(output) / "").string());
        if (!plan)
            return plan.error();
        for (PlannedFile& file : withoutHandMade(std::move(plan).value(), {})) {
            if (!known.insert(fs::weakly_canonical(file.input, ignored)).second)
                continue;
            ReportPage page{std::move(file), ""};
            if (!page.file.error)
                page.name = isAlone ? kFront : pageName(page.file.output.lexically_relative(output), taken);
            pages.push_back(std::move(page));
        }
    }
    return pages;
}

ReportRun::ReportRun(std::vector<ReportPage> pages, const ReportSettings& settings, const fs::path& directory)
    : mPages(std::move(pages)), mSettings(settings), mFiles(directory), mHasDisplay(hasDisplay())
{
}

std::vector<BatchJob> ReportRun::jobs() const
{
    std::vector<BatchJob> jobs;
    for (const ReportPage& page : mPages) {
        BatchJob job;
        job.file = page.file.input.string();
        job.inputBytes = fileBytes(page.file.input);
        job.outputDirectories = {TemporaryDirectory::parent()};
        job.work = [&page, this](Progress& progress) -> Result<Json> {
            if (page.file.error)
                return *page.file.error;
            return reportMesh(mSettings, page.file, progress);
        };
        jobs.push_back(job);
        if (!mHasDisplay)
            continue;
        // A driver that fails takes no figures along.
        job.work = [&page](Progress& progress) -> Result<Json> {
            if (page.file.error)
                return Json(nullptr);
            const Result<Json> pictures = takePictures(page.file, progress);
            return pictures ? pictures : Json{{"trouble", describe(pictures.error())}};
        };
        jobs.push_back(job);
    }
    return jobs;
}

Json ReportRun::takeFigures(const ReportPage& page, const Result<Json>& outcome) const
{
    Json mesh{{"mesh", page.file.input.string()}, {"page", nullptr}, {"thumbnail", nullptr}};
    if (!outcome) {
        setError(mesh, outcome.error());
        return mesh;
    }
    mesh["page"] = page.name;
    mesh["error"] = nullptr;
    mesh["pixel_budget"] = mSettings.pixelBudget;
    mesh.update(outcome.value());
    mesh["no_pictures"] = "there is no X display.";
    mesh["seen"] = nullptr;
    mesh["picture_notes"] = Json::array();
    return mesh;
}

void ReportRun::notePictures(Json& mesh, const Result<Json>& outcome)
{
    mesh["no_pictures"] = outcome ? Json(nullptr) : Json(describe(outcome.error()));
    if (!outcome || !outcome.value().is_object())
        return;
    if (outcome.value().contains("trouble")) {
        mesh["no_pictures"] = outcome.value()["trouble"];
        return;
    }
    LODSMITH_ASSERT(outcome.value()["seen"].size() == mesh["levels"].size(),
                    "pictures are of the levels that are judged");
    mesh["seen"] = outcome.value()["seen"];
    mesh["picture_notes"] = outcome.value()["notes"];
}

Json ReportRun::take(std::size_t job, const Result<Json>& outcome)
{
    const std::size_t jobsAPage = mHasDisplay ? 2 : 1;
    const ReportPage& page = mPages[job / jobsAPage];
    if (job % jobsAPage == 0)
        mMesh = takeFigures(page, outcome);
    if (job % jobsAPage + 1 < jobsAPage)
        return nullptr;
    Json pictures;
    if (mMesh["error"].is_null()) {
        if (mHasDisplay)
            notePictures(mMesh, outcome);
        if (mMesh["no_pictures"].is_null())
            pictures = outcome.value();
        mMesh["warnings"] = warningsOf(mMesh, mSettings.pixelBudget);
        const bool isAlone = page.name == kFront;
        if (!pictures.is_null() && !isAlone) {
            mMesh["thumbnail"] = fs::path(page.name).replace_extension(".png").string();
            add(mMesh["thumbnail"].get<std::string>(), fromBase64(pictures["thumbnail"].get<std::string>()));
        }
        add(page.name,
            meshPage(mMesh, pictures.is_null() ? Json() : pictures["levels"], isAlone ? "" : "../index.html"));
    }
    mMeshes.push_back(mMesh);
    return mMesh;
}

void ReportRun::add(const std::string& name, const std::string& bytes)
{
    if (mWritten)
        mWritten = mFiles.add(name, bytes);
}

Result<Done> ReportRun::finish()
{
    Json report{{"format", kReportFormat},
                {"version", 1},
                {"settings", {{"pixel_budget", mSettings.pixelBudget}, {"samples", mSettings.samples}}},
                {"totals", totalsOf(mMeshes)},
                {"meshes", mMeshes}};
    if (!mWritten)
        return mWritten;
    std::vector<std::string> names = mFiles.names();
    // A mesh that was given alone and has failed leaves the place of its page free.
    const bool hasOverview = std::find(names.begin(), names.end(), kFront) == names.end();
    if (hasOverview)
        names.emplace_back(kFront);
    names.emplace_back("report.json");
    report["files"] = names;
    if (auto added = mFiles.add("report.json", report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
        !added)
        return added;
    if (hasOverview)
        if (auto added = mFiles.add(kFront, overviewPage(report)); !added)
            return added;
    return mFiles.publish();
}

} // namespace lodsmith::cli
