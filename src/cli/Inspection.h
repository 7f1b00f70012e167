#pragma once

#include "JsonRecord.h"

#include <lodsmith/core/Result.h>

#include <filesystem>

namespace lodsmith::cli {

/// Says what a mesh file is made of; see docs/cli.md for the members of the record.
/// Starts OGRE: to be called in a child process. Errors: those of loading, and of MeshReader and meshStatistics().
Result<Json> inspectFile(const std::filesystem::path& path);

} // namespace lodsmith::cli
