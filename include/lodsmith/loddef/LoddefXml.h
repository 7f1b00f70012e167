#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/loddef/LodDefinition.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lodsmith {

/// The version that is written into files. One without a version is in the original grammar of 2012, which this one holds.
/// It is raised only when an older library would misunderstand a file, which is why newer files are refused.
constexpr int kLoddefVersion = 1;

/// Larger files are refused unread.
constexpr std::size_t kMaxLoddefBytes = 1 << 20;

/// At most so many errors, and as many warnings, are reported of one file.
constexpr std::size_t kMaxLoddefErrors = 100;

/// What came of reading a definition.
struct LoddefReading {
    std::optional<LodDefinition> definition; ///< none when there are errors
    std::vector<Error> errors;               ///< all that were found, in the order of their lines
    std::vector<Error> warnings; ///< unknown elements and attributes, which are kept, and amounts left to the default

    bool ok() const { return definition.has_value(); }
};

/// Reads a definition from XML, whatever the locale. docs/loddef.md has the grammar.
///
/// Each error has file and line and says what was found and what is allowed. Codes: BadFile (no XML, a document type
/// declaration, unknown words, malformed numbers, what is missing or double), InvalidSetting (findErrors()), Unsupported
/// (a newer version). Hostile input costs no more than time and memory in proportion to its size, at most
/// kMaxLoddefBytes. Any thread.
///
/// @param fileName for the errors only; may be empty
LODSMITH_API LoddefReading parseLoddef(std::string_view text, const std::string& fileName);

/// Reads a definition from a file. Errors: those of parseLoddef(), NotFound, Io (also for a larger file).
LODSMITH_API LoddefReading readLoddefFile(const std::filesystem::path& path);

/// A definition as XML. Numbers are the shortest that are read as the same again. Written on top of
/// LodDefinition::original: what need not change stays as it was written, white space between elements excepted.
/// Writing, reading and writing again gives the same bytes.
///
/// Errors: the first of findErrors(), BadFile when an `original` is no definition or level, or when the text would
/// be larger than kMaxLoddefBytes.
LODSMITH_API Result<std::string> loddefText(const LodDefinition& definition);

/// Writes a definition to a file, which is replaced whole or not at all; directories on the way are made.
/// Errors: those of loddefText(), Io.
LODSMITH_API Result<Done> writeLoddefFile(const std::filesystem::path& path, const LodDefinition& definition);

} // namespace lodsmith
