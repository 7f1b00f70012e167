#pragma once

#include <functional>

#include <sys/types.h>

namespace lodsmith::test {

/// Starts a process that does some work and then ends, with 0 when the work returned true, else with 1.
pid_t startChild(const std::function<bool()>& work);

/// Waits until a process has ended; the status as of waitpid().
int waitFor(pid_t child);

/// Both, one after the other: whether the work returned true.
bool inChild(const std::function<bool()>& work);

} // namespace lodsmith::test
