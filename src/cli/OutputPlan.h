#pragma once

#include <lodsmith/core/Result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// One file to work on and where its result goes.
struct PlannedFile {
    std::filesystem::path input;
    std::filesystem::path output; ///< empty when `error` is set
    std::optional<Error> error{}; ///< why there is nothing to work on: no such file, an unreadable or empty directory
    std::string name{}; ///< relative to the output directory, '/' between directories; with an error the input
};

/// One spelling for a path, so that "a/../b", "b" and a link to it are the same file, even before it exists.
std::filesystem::path identity(const std::filesystem::path& path);

/// Decides which files a command reads and which it writes, before it does either.
///
/// `output` is a directory when it is one already, ends in '/', or when there are several inputs or one that is a
/// directory; otherwise it is a file. A directory input stands for all `.mesh` files below it, sorted by name, which
/// keep their relative paths; an output directory below it is not searched.
/// Errors: InvalidSetting when two inputs have one output, when an output is another's input, or when `output` is a
/// file where a directory is needed.
Result<std::vector<PlannedFile>> planOutputs(const std::vector<std::string>& inputs, const std::string& output);

/// The same for a command that writes nothing: the files alone, each `output` empty. A file that several inputs name is
/// there once for each.
std::vector<PlannedFile> planInputs(const std::vector<std::string>& inputs);

} // namespace lodsmith::cli
