#pragma once

#include <lodsmith/core/Export.h>

namespace lodsmith {

/// Called when the programmer misused the library. Must not return normally: it may throw (tests do) or abort.
using AssertHandler = void (*)(const char* expression, const char* message, const char* file, int line);

/// Replaces the handler of failed asserts and returns the one before; null restores the default, which prints to
/// standard error and aborts. Thread-safe.
LODSMITH_API AssertHandler setAssertHandler(AssertHandler handler);

namespace detail {
[[noreturn]] LODSMITH_API void assertFailed(const char* expression, const char* message, const char* file, int line);
} // namespace detail

} // namespace lodsmith

/// Checks a promise of the caller, in every build type: a broken one is a bug in the calling program, never bad data.
#define LODSMITH_ASSERT(condition, message)                                                                            \
    ((condition) ? static_cast<void>(0) : ::lodsmith::detail::assertFailed(#condition, message, __FILE__, __LINE__))
