#include "ReportFiles.h"

#include "../../files/InsidePath.h"
#include "../JsonRecord.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>
#include <utility>

namespace fs = std::filesystem;

namespace lodsmith::cli {

const char* const kReportFormat = "lodsmith-report";

namespace {

constexpr const char* kIndexOfFiles = "report.json";
constexpr std::uintmax_t kLargestIndex = std::uintmax_t(1) << 30;

Error ioError(const std::string& message, const fs::path& path)
{
    Error error{ErrorCode::Io, message};
    error.file = path.string();
    return error;
}

/// What the report in a directory says of itself; null when there is none.
Json reportIn(const fs::path& directory)
{
    const Result<std::string> text = readFile(directory / kIndexOfFiles, kLargestIndex);
    if (!text)
        return nullptr;
    Json report = Json::parse(text.value(), nullptr, false);
    const bool isOurs = report.is_object() && report.contains("format") && report["format"] == kReportFormat;
    return isOurs ? report : Json(nullptr);
}

/// The files of the report in a directory that are no part of the new one.
std::vector<fs::path> leftBy(const Json& report, const fs::path& directory, const std::set<std::string>& kept)
{
    std::vector<fs::path> files;
    if (!report.is_object() || !report.contains("files") || !report["files"].is_array())
        return files;
    for (const Json& name : report["files"]) {
        if (!name.is_string() || kept.count(name.get<std::string>()) > 0)
            continue;
        if (const Result<fs::path> path = pathInside(directory, name.get<std::string>()); path)
            files.push_back(path.value());
    }
    return files;
}

} // namespace

Result<Done> ReportFiles::check(const fs::path& directory, Existing existing)
{
    std::error_code code;
    const fs::file_status status = fs::status(directory, code);
    if (status.type() == fs::file_type::not_found)
        return Done{};
    if (!fs::is_directory(status))
        return ioError("is there already and is no directory", directory);
    const bool isEmpty = fs::is_empty(directory, code);
    if (code)
        return ioError("the directory cannot be read: " + code.message(), directory);
    if (isEmpty || existing == Existing::Replace || !reportIn(directory).is_null())
        return Done{};
    return ioError("the directory holds other things than a report; --force puts one beside them", directory);
}

ReportFiles::ReportFiles(fs::path directory) : mDirectory(std::move(directory)), mSpool(std::tmpfile(), &std::fclose) {}

Error ReportFiles::spoolError(const char* what) const
{
    return ioError(std::string("the temporary file of the report cannot be ") + what + ": " + std::strerror(errno),
                   mDirectory);
}

Result<Done> ReportFiles::add(const std::string& name, const std::string& bytes)
{
    if (!mSpool)
        return spoolError("made");
    if (std::fwrite(bytes.data(), 1, bytes.size(), mSpool.get()) != bytes.size())
        return spoolError("written");
    mEntries.push_back({name, bytes.size()});
    return Done{};
}

std::vector<std::string> ReportFiles::names() const
{
    std::vector<std::string> names;
    for (const Entry& entry : mEntries)
        names.push_back(entry.name);
    return names;
}

Result<std::string> ReportFiles::next(std::size_t bytes)
{
    std::string text(bytes, '\0');
    if (std::fread(text.data(), 1, bytes, mSpool.get()) != bytes)
        return spoolError("read");
    return text;
}

Result<Done> ReportFiles::publish()
{
    if (!mSpool || std::fflush(mSpool.get()) != 0)
        return spoolError("written");
    std::rewind(mSpool.get());
    std::set<std::string> names;
    std::vector<std::unique_ptr<AtomicFile>> files;
    for (const Entry& entry : mEntries) {
        const Result<fs::path> path = pathInside(mDirectory, entry.name);
        if (!path)
            return path.error();
        const Result<std::string> bytes = next(entry.bytes);
        if (!bytes)
            return bytes.error();
        files.push_back(std::make_unique<AtomicFile>(path.value(), Existing::Replace));
        if (auto prepared = files.back()->prepare(bytes.value()); !prepared)
            return prepared;
        names.insert(entry.name);
    }
    const std::vector<fs::path> left = leftBy(reportIn(mDirectory), mDirectory, names);
    for (const auto& file : files)
        if (auto committed = file->commit(); !committed)
            return committed;
    std::error_code ignored;
    for (const fs::path& file : left)
        fs::remove(file, ignored);
    return Done{};
}

} // namespace lodsmith::cli
