#pragma once

#include <lodsmith/core/Result.h>
#include <lodsmith/core/Simplify.h>

#include <string>
#include <string_view>
#include <vector>

namespace lodsmith::cli {

/// One level as written on the command line: VALUE:METHOD:AMOUNT or VALUE:mesh:FILE.
struct LevelSpec {
    float value = 0.0f;   ///< what the strategy's user means, > 0 and at most 1e18
    std::string method;   ///< the word that was used
    LevelTarget target;   ///< not used by a hand-made level
    std::string meshFile; ///< path of a hand-made mesh; empty for a generated level

    bool isManual() const { return !meshFile.empty(); }
};

/// Whether the values of a list of levels rise (distances) or fall (pixel counts).
enum class LevelOrder { Rising, Falling };

/// Parses one level. Error: InvalidSetting, saying what was found and what is allowed.
Result<LevelSpec> parseLevelSpec(std::string_view text);

/// Parses levels with commas between them, nearest first. Error: InvalidSetting, also for values out of order.
Result<std::vector<LevelSpec>> parseLevelSpecs(std::string_view text, LevelOrder order);

} // namespace lodsmith::cli
