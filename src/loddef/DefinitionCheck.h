#pragma once

#include "LoddefWords.h"

#include <lodsmith/loddef/LodDefinition.h>

#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace lodsmith {

/// Where the parts of a level stand in a file, from 1; -1 for what is absent.
struct LevelLines {
    int level = -1;
    int value = -1;
    int amount = -1;
    int meshName = -1;
};

/// Where the parts of a definition stand in a file.
struct DefinitionLines {
    int weights = -1;
    int weightOf[std::size(kWeights)] = {-1, -1, -1, -1};
    std::vector<LevelLines> levels; ///< one for each level of the definition
    std::vector<int> subMeshes;     ///< one for each submesh of the definition
};

/// findErrors(), with the lines in which things were read; null for a definition that comes from no file.
std::vector<Error> findErrors(const LodDefinition& definition, const DefinitionLines* lines);

/// "WHAT is 'FOUND'; allowed: ALLOWED".
std::string notAllowed(const std::string& what, std::string_view found, const std::string& allowed);

/// A text from a file, cut when it is too long for a message.
std::string shortened(std::string_view text);

/// The same in quotes.
std::string quoted(std::string_view text);

} // namespace lodsmith
