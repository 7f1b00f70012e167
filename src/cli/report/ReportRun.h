#pragma once

#include "../BatchRunner.h"
#include "../OutputPlan.h"
#include "MeshReport.h"
#include "ReportFiles.h"

#include <string>
#include <vector>

namespace lodsmith::cli {

/// One mesh of a report and its page.
struct ReportPage {
    PlannedFile file; ///< its output is not written; only the file's name counts
    std::string name; ///< of the page, relative to the report; empty when there is no file to work on
};

/// Which meshes a report is about, each file once, in the order in which they were given, and what their pages are
/// called: index.html for a mesh that was given alone, else a name below pages/ made from its path. Hand-made levels
/// that definitions name go along with their meshes and have no pages. Errors: those of planOutputs().
Result<std::vector<ReportPage>> planPages(const std::vector<std::string>& inputs, const std::string& output);

/// A report in the making.
class ReportRun {
public:
    /// @param pages    must not be empty; kept
    /// @param settings kept by reference
    ReportRun(std::vector<ReportPage> pages, const ReportSettings& settings, const std::filesystem::path& directory);

    /// The figures of each mesh, followed by its pictures where there is an X display. They refer to this object.
    std::vector<BatchJob> jobs() const;

    /// Takes in what job number `job` has found. The entry of report.json, once all about a mesh has come; null before.
    Json take(std::size_t job, const Result<Json>& outcome);

    /// Writes the report. Errors: those of ReportFiles.
    Result<Done> finish();

private:
    Json takeFigures(const ReportPage& page, const Result<Json>& outcome) const;
    void notePictures(Json& mesh, const Result<Json>& outcome);
    void add(const std::string& name, const std::string& bytes);

    std::vector<ReportPage> mPages;
    const ReportSettings& mSettings;
    ReportFiles mFiles;
    bool mHasDisplay;
    Json mMeshes = Json::array();
    Json mMesh;                     ///< the one whose pictures are to come
    Result<Done> mWritten = Done{}; ///< the first failure
};

} // namespace lodsmith::cli
