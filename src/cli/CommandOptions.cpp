#include "CommandOptions.h"

#include "Numbers.h"
#include "Table.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace lodsmith::cli {

namespace {

Error outOfRange(const std::string& text, const std::string& kind, const std::string& least, const std::string& most)
{
    return Error{ErrorCode::InvalidSetting, "'" + text + "' is no " + kind + " from " + least + " to " + most};
}

} // namespace

CLI::Option* addParsedOption(CLI::App& command, const std::string& name, const std::string& help,
                             std::function<Result<Done>(const std::string&)> parse)
{
    const auto take = [name, parse = std::move(parse)](const std::string& text) {
        if (const Result<Done> parsed = parse(text); !parsed)
            throw UsageError(name + ": " + parsed.error().message);
    };
    return command.add_option_function<std::string>(name, take, help);
}

CLI::Option* addNumberOption(CLI::App& command, const std::string& name, double& target, double least, double most,
                             const std::string& help)
{
    return addParsedOption(command, name, help, [&target, least, most](const std::string& text) -> Result<Done> {
        const std::optional<double> number = parseNumber(text);
        if (!number || *number < least || *number > most)
            return outOfRange(text, "number", formatNumber(least, 6), formatNumber(most, 6));
        target = *number;
        return Done{};
    });
}

CLI::Option* addCountOption(CLI::App& command, const std::string& name, unsigned& target, unsigned least, unsigned most,
                            const std::string& help)
{
    return addParsedOption(command, name, help, [&target, least, most](const std::string& text) -> Result<Done> {
        const std::optional<std::uint64_t> count = parseCount(text);
        if (!count || *count < least || *count > most)
            return outOfRange(text, "whole number", std::to_string(least), std::to_string(most));
        target = static_cast<unsigned>(*count);
        return Done{};
    });
}

void addWriteOptions(CLI::App& command, WriteOptions& options)
{
    command.add_flag_callback(
        "--force",
        [&options] {
            options.overwriting = {Existing::Replace, nextFileTime()};
        },
        "Overwrite files that are there already");
    addParsedOption(command, "--mesh-version", "Mesh format to write: 1.0, 1.4, 1.41, 1.8 or 1.10 [1.10]",
                    [&options](const std::string& word) -> Result<Done> {
                        const Result<Ogre::MeshVersion> version = parseMeshVersion(word);
                        if (!version)
                            return version.error();
                        options.format.version = version.value();
                        return Done{};
                    })
        ->type_name("VERSION");
    addParsedOption(command, "--endian", "Byte order to write: native, little or big [native]",
                    [&options](const std::string& word) -> Result<Done> {
                        const Result<Ogre::Serializer::Endian> endian = parseEndian(word);
                        if (!endian)
                            return endian.error();
                        options.format.endian = endian.value();
                        return Done{};
                    })
        ->type_name("ORDER");
}

void addTimeLimitOption(CLI::App& command, BatchOptions& options)
{
    addNumberOption(command, "--time-limit", options.secondsAFile, 0.0, 1e6,
                    "Give a file up after so many seconds; 0 for never [600]")
        ->type_name("SECONDS");
}

void printError(const Error& error)
{
    std::fprintf(stderr, "lodsmith: %s\n", printable(describe(error)).c_str());
}

bool finishOutput()
{
    if (std::fflush(stdout) == 0 && !std::ferror(stdout))
        return true;
    std::fprintf(stderr, "lodsmith: standard output cannot be written: %s\n", std::strerror(errno));
    return false;
}

std::uint64_t fileBytes(const std::filesystem::path& path)
{
    std::error_code code;
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    return code ? 0 : size;
}

int runBatch(const std::vector<BatchJob>& jobs, const BatchOptions& options,
             const std::function<void(std::size_t job, const Result<Json>& outcome)>& show)
{
    // What stdio holds back now would be written once more by every child.
    std::fflush(nullptr);
    ProgressBar progress(stderr, jobs.size());
    bool failed = false;
    BatchRunner(options, progress).run(jobs, [&](std::size_t job, const Result<Json>& outcome) {
        if (!outcome) {
            failed = true;
            printError(outcome.error());
        }
        show(job, outcome);
        std::fflush(stdout);
    });
    return !finishOutput() || failed ? kExitFailed : kExitDone;
}

} // namespace lodsmith::cli
