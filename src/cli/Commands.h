#pragma once

#include <CLI/CLI.hpp>

namespace lodsmith::cli {

/// Each adds one command to the command line. When that command is chosen, it is run by the parser's callback, which
/// sets `exitCode` or throws a UsageError.
void addGenerateCommand(CLI::App& app, int& exitCode);
void addInspectCommand(CLI::App& app, int& exitCode);
void addMeasureCommand(CLI::App& app, int& exitCode);
void addCostCommand(CLI::App& app, int& exitCode);
void addRenderCommand(CLI::App& app, int& exitCode);
void addImportCommand(CLI::App& app, int& exitCode);
void addReportCommand(CLI::App& app, int& exitCode);
void addStripCommand(CLI::App& app, int& exitCode);
void addValidateCommand(CLI::App& app, int& exitCode);

} // namespace lodsmith::cli
