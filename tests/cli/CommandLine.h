#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include <sys/types.h>

namespace lodsmith::cli::test {

/// What a program did.
struct Outcome {
    int exitCode = -1; ///< -1 when a signal ended it
    std::string out;
    std::string err;

    /// Standard output as JSON Lines; throws when a line is no JSON object.
    std::vector<nlohmann::json> records() const;
};

/// Runs the lodsmith program as a child process. `fileSizeLimit` bounds the files it may write, in bytes; 0 for no
/// bound.
Outcome runLodsmith(const std::vector<std::string>& arguments, unsigned long fileSizeLimit = 0);

/// Starts the lodsmith program in a process group of its own, with its output going nowhere: its process, for
/// waitForGroup().
pid_t startLodsmith(const std::vector<std::string>& arguments);

/// Waits until a process that startLodsmith() has started, and all of its children, have ended. Its exit code, or -1 when a
/// signal ended it.
int waitForGroup(pid_t leader);

/// Any program with a standard output of its own; looked for on the PATH.
Outcome runProgram(const std::vector<std::string>& command, unsigned long fileSizeLimit = 0);

} // namespace lodsmith::cli::test
