#pragma once

#include "ContentHash.h"
#include "JsonRecord.h"

#include <filesystem>
#include <optional>
#include <string>

namespace lodsmith::cli {

/// What a mesh was made of and what came out, kept as `.lodsmith/NAME.json` in the directory of the output NAME.
///
/// The file, however damaged, says that NAME is this program's to make again. docs/batch.md has its format.
struct BuildRecord {             // NOLINT(bugprone-exception-escape): moving a JSON value throws nothing
    std::string version;         ///< of this program and of OGRE
    Json settings;               ///< the options that decide what comes out, as they were given
    std::filesystem::path input; ///< the file that the output stands for
    FileHashes read;             ///< every file that was read, and those that were looked for and not there
    FileHashes written;          ///< the output, and what went along
    Json result;                 ///< what `generate --json` says of it, without paths and times
};

/// The version that records of this program carry.
std::string recordVersion();

/// Where the record of an output is.
std::filesystem::path recordFile(const std::filesystem::path& output);

/// Whether an output, or a file that went along, was made by this program.
bool isRecorded(const std::filesystem::path& output);

/// The record as text; paths are relative to the output's directory, so that both may be moved together.
std::string recordText(const BuildRecord& record, const std::filesystem::path& output);

/// The record of an output; nothing when there is none, or it is damaged, or that of a file that went along.
std::optional<BuildRecord> readRecord(const std::filesystem::path& output);

/// Whether a mesh would be made of the same now: by the same version, with the same settings, of files that are as they were.
/// Hashes them all; trusts no time stamps.
bool isCurrent(const BuildRecord& record, const Json& settings);

/// Whether everything that was written is as it was, by hash.
bool isWhole(const BuildRecord& record);

/// Where a file that went along with a mesh came from, kept as its record.
struct CompanionRecord {
    std::filesystem::path source;
    std::filesystem::path mesh; ///< the output that it went along with first
};

/// The record as text, as recordText().
std::string companionRecordText(const CompanionRecord& record, const std::filesystem::path& companion);

/// The record of a file that went along; that of a mesh counts as one that went along with itself. Nothing when there is
/// none, or it is damaged.
std::optional<CompanionRecord> readCompanionRecord(const std::filesystem::path& companion);

} // namespace lodsmith::cli
