#pragma once

#include "BatchRunner.h"
#include "MeshFile.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// What a command line promises to people and scripts.
enum ExitCode { kExitDone = 0, kExitFailed = 1, kExitUsage = 2 };

/// The command line itself is wrong: leads to the message on standard error and to kExitUsage.
class UsageError : public CLI::ParseError {
public:
    explicit UsageError(const std::string& message) : CLI::ParseError("UsageError", message, kExitUsage) {}
};

/// An option whose text `parse` understands or refuses with an error.
CLI::Option* addParsedOption(CLI::App& command, const std::string& name, const std::string& help,
                             std::function<Result<Done>(const std::string&)> parse);

/// An option that takes a number between two bounds, both included; malformed and other numbers are usage errors.
CLI::Option* addNumberOption(CLI::App& command, const std::string& name, double& target, double least, double most,
                             const std::string& help);
CLI::Option* addCountOption(CLI::App& command, const std::string& name, unsigned& target, unsigned least, unsigned most,
                            const std::string& help);

/// How results are written.
struct WriteOptions {
    Overwriting overwriting;
    MeshFormat format;
};

/// --force, --mesh-version and --endian.
void addWriteOptions(CLI::App& command, WriteOptions& options);

/// --time-limit.
void addTimeLimitOption(CLI::App& command, BatchOptions& options);

/// Prints "lodsmith: FILE: message" on standard error.
void printError(const Error& error);

/// Flushes standard output; false, with a message, when not everything could be written to it.
bool finishOutput();

/// Size of a file in bytes, 0 when it cannot be told.
std::uint64_t fileBytes(const std::filesystem::path& path);

/// Runs a batch; outcomes go to `show` in order, failed ones after their error was printed. Returns the exit code.
int runBatch(const std::vector<BatchJob>& jobs, const BatchOptions& options,
             const std::function<void(std::size_t job, const Result<Json>& outcome)>& show);

} // namespace lodsmith::cli
