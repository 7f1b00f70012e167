#pragma once

#include "../JsonRecord.h"

namespace lodsmith::cli {

/// What there is to say against a mesh and its levels, by its record (docs/report.md): an array of objects with the
/// members `code`, `level` (null for the mesh as a whole) and `text`, a sentence for people in plain text.
/// @param pixelBudget visible error that a switch may have
Json warningsOf(const Json& record, double pixelBudget);

} // namespace lodsmith::cli
