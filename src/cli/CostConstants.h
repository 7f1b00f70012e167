#pragma once

#include <lodsmith/analysis/StreamingCost.h>
#include <lodsmith/core/Result.h>

#include <string>

namespace lodsmith::cli {

/// Sets constants of the streaming cost from a text "NAME=VALUE,...": the names of docs/cli.md, numbers, for
/// switch_ratios several with '/' between them, for free_without_lowest and charge_duplicates yes or no.
/// Error: InvalidSetting (an unknown name, a name twice, no number, troubleWith()); `settings` is undefined then.
Result<Done> setCostConstants(const std::string& text, StreamingCostSettings& settings);

} // namespace lodsmith::cli
