#pragma once

#include "../../files/AtomicFile.h"

#include <lodsmith/core/Result.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// What report.json says of itself in its member `format`.
extern const char* const kReportFormat;

/// The files of a report on their way into its directory.
///
/// They are kept out of sight, in a file without a name, which vanishes with the process however that ends; publish()
/// then puts them in place, each whole, after all of them have been written beside their places. What an earlier report
/// has left and the new one has not goes away; what is no part of a report stays.
class ReportFiles {
public:
    /// Whether a report may go there: where nothing is, into an empty directory, over an earlier report, and with
    /// Existing::Replace into any directory. Error: Io; file is the directory.
    static Result<Done> check(const std::filesystem::path& directory, Existing existing);

    explicit ReportFiles(std::filesystem::path directory);

    /// @param name relative, with '/' between its parts; each once
    /// Error: Io.
    Result<Done> add(const std::string& name, const std::string& bytes);

    /// The names so far, in the order in which they came.
    std::vector<std::string> names() const;

    /// Puts everything in place, in the order in which it came. Errors: Io, InvalidSetting (a directory of the report
    /// is a link that leads elsewhere).
    Result<Done> publish();

private:
    struct Entry {
        std::string name;
        std::size_t bytes = 0;
    };

    Result<std::string> next(std::size_t bytes);
    Error spoolError(const char* what) const;

    std::filesystem::path mDirectory;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> mSpool;
    std::vector<Entry> mEntries;
};

} // namespace lodsmith::cli
