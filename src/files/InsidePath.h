#pragma once

#include <lodsmith/core/Result.h>

#include <filesystem>
#include <string_view>

namespace lodsmith {

/// The path of a file below a directory, for a name that comes from data: it cannot lead out of the directory.
///
/// Names are relative, with '/' between their parts. Refused are empty names and parts, "." and "..", backslashes, colons
/// (drives, streams) and control characters, on every system; and names whose directories lead out of `directory` over
/// symbolic links. Links that stay inside are followed; the last part is not looked at, since AtomicFile replaces a link
/// and does not follow it. Neither `directory` nor what is below has to exist. Whoever may change the directory while this
/// runs can get round it.
///
/// Errors: InvalidSetting (a name as above, no directory), Io; file is the name.
Result<std::filesystem::path> pathInside(const std::filesystem::path& directory, std::string_view name);

} // namespace lodsmith
