#include "BuildRecord.h"

#include "../files/AtomicFile.h"
#include "OutputDirectories.h"

#include <OgrePrerequisites.h>

#include <algorithm>
#include <cstdio>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

constexpr const char* kDirectory = ".lodsmith";
constexpr int kFormat = 1;
constexpr std::uintmax_t kLargestRecord = std::uintmax_t(64) << 20;

/// File names may hold any byte, JSON only UTF-8.
std::string encoded(const fs::path& path)
{
    std::string text;
    for (const char c : path.generic_string()) {
        const auto byte = static_cast<unsigned char>(c);
        char escape[4];
        std::snprintf(escape, sizeof escape, "%%%02x", byte);
        text += byte < 0x20 || byte >= 0x7f || c == '%' ? std::string(escape) : std::string(1, c);
    }
    return text;
}

fs::path decoded(const std::string& text)
{
    const auto digit = [](char c) { return c >= 'a' ? c - 'a' + 10 : c - '0'; };
    std::string path;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escape = text[i] == '%' && i + 2 < text.size();
        path += escape ? static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2])) : text[i];
        i += escape ? 2 : 0;
    }
    return path;
}

/// Paths as a record spells them, for one output. Links on the way are kept: one that leads elsewhere by now is a change.
class RelativePaths {
public:
    explicit RelativePaths(const fs::path& output) : mDirectory(identity(directoryOf(output))) {}

    std::string text(const fs::path& path) const { return encoded(fs::absolute(path).lexically_relative(mDirectory)); }
    fs::path path(const std::string& text) const { return mDirectory / decoded(text); }

    Json object(const FileHashes& hashes) const
    {
        Json files = Json::object();
        for (const auto& [file, hash] : hashes)
            files[text(file)] = hash ? Json(*hash) : Json(nullptr);
        return files;
    }

    FileHashes hashes(const Json& object) const
    {
        FileHashes files;
        for (const auto& [file, hash] : object.items())
            files[path(file)] = hash.is_null() ? std::nullopt : std::optional(hash.get<std::string>());
        return files;
    }

private:
    fs::path mDirectory;
};

Json readJson(const fs::path& output)
{
    const Result<std::string> text = readFile(recordFile(output), kLargestRecord);
    return text ? Json::parse(text.value(), nullptr, false) : Json();
}

bool isUnchanged(const FileHashes& files)
{
    for (const auto& [file, hash] : files)
        if (fileHash(file) != hash)
            return false;
    return true;
}

} // namespace

std::string recordVersion()
{
    return "lodsmith " LODSMITH_VERSION ", OGRE " + std::to_string(OGRE_VERSION_MAJOR) + "."
           + std::to_string(OGRE_VERSION_MINOR) + "." + std::to_string(OGRE_VERSION_PATCH);
}

fs::path recordFile(const fs::path& output)
{
    return directoryOf(output) / kDirectory / (output.filename().string() + ".json");
}

bool isRecorded(const fs::path& output)
{
    std::error_code ignored;
    return fs::exists(recordFile(output), ignored);
}

std::string recordText(const BuildRecord& record, const fs::path& output)
{
    const RelativePaths paths(output);
    const Json json{
        {"format", kFormat},           {"version", record.version},         {"input", paths.text(record.input)},
        {"settings", record.settings}, {"read", paths.object(record.read)}, {"written", paths.object(record.written)},
        {"result", record.result}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<BuildRecord> readRecord(const fs::path& output)
{
    const RelativePaths paths(output);
    try {
        const Json json = readJson(output);
        if (!json.is_object() || json.at("format") != kFormat || !json.at("result").at("levels").is_array())
            return std::nullopt;
        BuildRecord record;
        record.version = json.at("version").get<std::string>();
        record.settings = json.at("settings");
        record.input = paths.path(json.at("input").get<std::string>());
        record.read = paths.hashes(json.at("read"));
        record.written = paths.hashes(json.at("written"));
        record.result = json.at("result");
        const bool isOfOutput = std::any_of(record.written.begin(), record.written.end(), [&](const auto& file) {
            return file.first.filename() == output.filename();
        });
        return isOfOutput && record.read.count(record.input) > 0 ? std::optional(std::move(record)) : std::nullopt;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

bool isCurrent(const BuildRecord& record, const Json& settings)
{
    return record.version == recordVersion() && record.settings == settings && isUnchanged(record.read);
}

bool isWhole(const BuildRecord& record)
{
    return isUnchanged(record.written);
}

std::string companionRecordText(const CompanionRecord& record, const fs::path& companion)
{
    const RelativePaths paths(companion);
    const Json json{{"format", kFormat}, {"input", paths.text(record.source)}, {"mesh", paths.text(record.mesh)}};
    return json.dump(1) + "\n";
}

std::optional<CompanionRecord> readCompanionRecord(const fs::path& companion)
{
    const RelativePaths paths(companion);
    try {
        const Json json = readJson(companion);
        if (!json.is_object())
            return std::nullopt;
        const std::string mesh = json.value("mesh", companion.filename().string());
        return CompanionRecord{paths.path(json.at("input").get<std::string>()), paths.path(mesh)};
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

} // namespace lodsmith::cli
