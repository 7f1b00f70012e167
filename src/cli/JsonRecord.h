#pragma once

#include <lodsmith/core/LodChain.h>
#include <lodsmith/core/Result.h>

#include <nlohmann/json.hpp>

#include <string>

namespace lodsmith::cli {

/// What a command found out about a file; keeps the order in which its members were set.
using Json = nlohmann::ordered_json;

/// One line of text; bytes that are no UTF-8 (file names may hold any) become replacement characters.
std::string toLine(const Json& record);

/// All members of an error, and back.
Json toJson(const Error& error);
Error errorFromJson(const Json& json);

/// Sets the member `error` to describe(error) and `error_code` to its word.
void setError(Json& record, const Error& error);

/// The word for a stop reason ("target_reached").
const char* toString(StopReason reason);

/// Why a level stopped short, for people, by that word; empty for "target_reached".
std::string stopSentence(const std::string& word);

} // namespace lodsmith::cli
