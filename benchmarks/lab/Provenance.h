#pragma once

#include "Records.h"

namespace lodsmith::benchmarks {

/// The machine that this runs on. Linux only.
Machine thisMachine();

/// What this program was built from.
/// @param label  what comparisons call it; empty for its version and revision
Build thisBuild(const std::string& label);

} // namespace lodsmith::benchmarks
