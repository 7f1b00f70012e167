#pragma once

#include "Peer.h"

#include <optional>
#include <string>

namespace lodsmith::benchmarks {

/// How far the process's resident memory rises above where it was, in kB, while a peer makes its chain. Linux only.
long peakGrowthKb(Peer& peer, Subject& subject);

/// The same in a process of its own, so that no peer finds memory that another left behind.
/// @param arguments  what makes this program print peakGrowthKb() on standard output
/// @return nothing when that process failed
std::optional<long> peakGrowthInOwnProcess(const std::vector<std::string>& arguments);

} // namespace lodsmith::benchmarks
