#pragma once

#include "JsonRecord.h"

#include <string>

namespace lodsmith::cli {

/// The record of a generated mesh as people read it: a table of its levels, times, and what there is to say about them.
std::string generationReport(const Json& record, unsigned repeat);

} // namespace lodsmith::cli
