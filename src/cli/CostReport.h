#pragma once

#include "JsonRecord.h"

#include <string>

namespace lodsmith::cli {

/// A record of costRecord() and its `input` for people: a table of the levels, what to shrink first, and the cheapest
/// chain if it was asked for.
std::string costReport(const Json& record);

} // namespace lodsmith::cli
