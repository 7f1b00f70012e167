#pragma once

#include "BuildRecord.h"
#include "Generation.h"

#include <lodsmith/core/Result.h>

#include <filesystem>

namespace lodsmith::cli {

/// Whether a mesh may be written: nothing is there, or what is there is of this program's making, or `force`.
/// Error: Io, also when it is no regular file; file is the output.
Result<Done> checkProduct(const std::filesystem::path& output, bool force);

/// Writes a mesh that has a record, what goes along with it, and the record. `record` needs what was written filled in by this.
///
/// Each file appears whole or not at all. The record is there before the mesh is: a process that is killed in between
/// leaves a record that the mesh does not fit, and the mesh is made again. Nothing is waited for to be on the disk, for
/// what a power cut takes away is found missing in the same way; sync the file system once all is written.
///
/// A file that goes along is replaced unless another mesh brings a different one of that name. Any number of processes may write to one directory; of two that write one mesh at a time, one wins.
///
/// Errors: Io, NotFound, InvalidSetting (another mesh has brought a different file of the same name); file is the one that
/// failed.
Result<Done> writeProduct(const std::filesystem::path& output, const GeneratedMesh& mesh, BuildRecord record,
                          bool force);

} // namespace lodsmith::cli
