#pragma once

#include <atomic>

namespace lodsmith::test {

/// Allocations with operator new that still succeed, on all threads together; negative: no limit. A program that has
/// FailingMemory.cpp in it allocates by this.
extern std::atomic<long> allocationsLeft;

} // namespace lodsmith::test
