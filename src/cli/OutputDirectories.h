#pragma once

#include "OutputPlan.h"

#include <lodsmith/core/Result.h>

#include <filesystem>
#include <set>
#include <vector>

namespace lodsmith::cli {

/// The directory of a file, "." for a bare name.
std::filesystem::path directoryOf(const std::filesystem::path& file);

/// Where the files of a plan and their records go.
std::set<std::filesystem::path> outputDirectories(const std::vector<PlannedFile>& plan);

/// Waits until all that has been written to the file systems of some directories is on the disk. Error: Io.
Result<Done> syncFileSystems(const std::set<std::filesystem::path>& directories);

} // namespace lodsmith::cli
