#include "OutputPlan.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

bool isMeshName(const fs::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extension == ".mesh";
}

PlannedFile failed(const fs::path& input, ErrorCode code, std::string message)
{
    Error error{code, std::move(message)};
    error.file = input.string();
    return {input, {}, std::move(error), input.generic_string()};
}

/// `skipped` is an identity(), or nothing.
Result<std::vector<fs::path>> findMeshFiles(const fs::path& directory, const std::optional<fs::path>& skipped)
{
    std::vector<fs::path> files;
    std::error_code code;
    fs::recursive_directory_iterator entry(directory, code);
    fs::path last = directory; // where it is when something is wrong
    for (const fs::recursive_directory_iterator end; !code && entry != end; entry.increment(code)) {
        std::error_code ignored;
        last = entry->path();
        if (skipped && entry->is_directory(ignored) && identity(entry->path()) == *skipped)
            entry.disable_recursion_pending();
        else if (isMeshName(entry->path()) && !entry->is_directory(ignored))
            files.push_back(entry->path());
    }
    if (code)
        return Error{ErrorCode::Io, "the directory cannot be read: " + code.message() + " (" + last.string() + ')'};
    std::sort(files.begin(), files.end());
    return files;
}

/// Without an `output` the files alone.
void planDirectory(const fs::path& directory, const std::optional<fs::path>& output, std::vector<PlannedFile>& plan)
{
    Result<std::vector<fs::path>> files =
        findMeshFiles(directory, output ? std::optional(identity(*output)) : std::nullopt);
    if (!files)
        plan.push_back(failed(directory, files.error().code, files.error().message));
    else if (files.value().empty())
        plan.push_back(failed(directory, ErrorCode::NotFound, "the directory holds no .mesh file"));
    else
        for (const fs::path& file : files.value()) {
            const fs::path name = file.lexically_relative(directory);
            plan.push_back({file, output ? *output / name : fs::path(), std::nullopt, name.generic_string()});
        }
}

Error invalid(std::string message)
{
    return Error{ErrorCode::InvalidSetting, std::move(message)};
}

Result<Done> checkCollisions(const std::vector<PlannedFile>& plan)
{
    std::map<fs::path, const PlannedFile*> byOutput;
    for (const PlannedFile& file : plan) {
        if (file.error)
            continue;
        const auto [other, isNew] = byOutput.emplace(identity(file.output), &file);
        if (!isNew)
            return invalid("both '" + other->second->input.string() + "' and '" + file.input.string()
                           + "' would become '" + file.output.string() + "'");
    }
    for (const PlannedFile& file : plan) {
        if (file.error)
            continue;
        const auto writer = byOutput.find(identity(file.input));
        if (writer != byOutput.end() && writer->second != &file)
            return invalid("the output of '" + writer->second->input.string() + "' is the input '" + file.input.string()
                           + "'");
    }
    return Done{};
}

} // namespace

fs::path identity(const fs::path& path)
{
    std::error_code code;
    const fs::path canonical = fs::weakly_canonical(fs::absolute(path, code), code);
    return code ? fs::absolute(path, code).lexically_normal() : canonical;
}

Result<std::vector<PlannedFile>> planOutputs(const std::vector<std::string>& inputs, const std::string& output)
{
    if (output.empty())
        return invalid("the output has no name");
    std::error_code ignored;
    const bool severalFiles = inputs.size() > 1 || fs::is_directory(inputs.front(), ignored);
    const bool intoDirectory = severalFiles || fs::is_directory(output, ignored) || output.back() == '/';
    // A file is not found under its name with a slash behind it.
    const fs::path name = output.back() == '/' ? fs::path(output).parent_path() : fs::path(output);
    if (intoDirectory && fs::exists(name, ignored) && !fs::is_directory(name, ignored))
        return invalid("the output '" + output + "' has to be a directory, and there is a file of that name");

    std::vector<PlannedFile> plan;
    for (const fs::path input : inputs) {
        if (fs::is_directory(input, ignored))
            planDirectory(input, fs::path(output), plan);
        else if (!fs::exists(input, ignored))
            plan.push_back(failed(input, ErrorCode::NotFound, "no such file"));
        else
            plan.push_back({input, intoDirectory ? fs::path(output) / input.filename() : fs::path(output), std::nullopt,
                            input.filename().string()});
    }
    if (auto distinct = checkCollisions(plan); !distinct)
        return distinct.error();
    return plan;
}

std::vector<PlannedFile> planInputs(const std::vector<std::string>& inputs)
{
    std::vector<PlannedFile> plan;
    for (const fs::path input : inputs) {
        std::error_code ignored;
        if (fs::is_directory(input, ignored))
            planDirectory(input, std::nullopt, plan);
        else if (!fs::exists(input, ignored))
            plan.push_back(failed(input, ErrorCode::NotFound, "no such file"));
        else
            plan.push_back({input, {}, std::nullopt});
    }
    return plan;
}

} // namespace lodsmith::cli
