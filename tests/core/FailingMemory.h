#pragma once

#include <atomic>

namespace lodsmith::test {

/// Allocations with operator new until one fails, counted over all threads; negative: none does. It is below 0 again when one
/// has failed. A program that has FailingMemory.cpp in it allocates by this.
extern std::atomic<long> allocationsLeft;

} // namespace lodsmith::test
