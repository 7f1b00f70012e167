#pragma once

#include "Configuration.h"
#include "Records.h"

#include "../Timing.h"

namespace lodsmith::benchmarks {

struct MeasurementOptions {
    TimingOptions timing;
    DeviationOptions deviation = kFewSamples;
};

/// What the database says of a mesh. Throws std::runtime_error where its statistics cannot be taken.
MeshRecord describeMesh(const Subject& subject);

/// Makes the levels of one configuration with each generator, and measures them, the time and the memory. The rounds are in
/// turn: every generator once, then every generator again. A generator that fails takes no further part.
/// @param origin      of the subject, for the processes in which each generator is tried first
/// @param generators  all of which the configuration suits
/// @return one record each, in that order
std::vector<RunRecord> measureTogether(Subject& subject, const std::string& origin, const Configuration& configuration,
                                       const std::vector<Peer*>& generators, const MeasurementOptions& options);

/// The command with which this program prints the growth of memory, and its arguments (PeakMemory.h).
inline constexpr const char* kPeakCommand = "peak";

} // namespace lodsmith::benchmarks
