#pragma once

#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// The files of schema/, in order: step i leads from schema version i to i + 1. A step that a release had is never changed;
/// what changes is a further step.
const std::vector<std::string>& schemaSteps();

} // namespace lodsmith::benchmarks
