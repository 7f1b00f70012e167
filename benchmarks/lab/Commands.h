#pragma once

#include <CLI/CLI.hpp>

namespace lodsmith::benchmarks {

// Exit status of every command.
inline constexpr int kExitDone = 0;
inline constexpr int kExitFailed = 1; ///< something could not be measured, read or written, or has got worse
inline constexpr int kExitUsage = 2;

/// Each adds its command; when that is chosen it is run and `exitCode` set. `exitCode` outlives the parsing.
void addRunCommand(CLI::App& app, int& exitCode);
void addPeakCommand(CLI::App& app, int& exitCode); ///< not for people: what `run` starts processes for
void addShowCommand(CLI::App& app, int& exitCode);
void addTablesCommand(CLI::App& app, int& exitCode);
void addPlotsCommand(CLI::App& app, int& exitCode);
void addCompareCommand(CLI::App& app, int& exitCode);

} // namespace lodsmith::benchmarks
