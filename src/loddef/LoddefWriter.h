#pragma once

#include <lodsmith/core/Result.h>
#include <lodsmith/loddef/LodDefinition.h>

#include <tinyxml2.h>

namespace lodsmith {

/// Brings a document up to a definition: what it says already stays untouched, what it says differently is changed, what
/// it lacks is added in its place, and what this library does not know is left alone. The document has to be empty or
/// one that LoddefReader reads without errors; the definition has to be in order.
/// Error: BadFile when the `original` of a level is no level.
Result<Done> writeDefinition(const LodDefinition& definition, tinyxml2::XMLDocument& document);

} // namespace lodsmith
