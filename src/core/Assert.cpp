#include <lodsmith/core/Assert.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace lodsmith {

namespace {

void printAndAbort(const char* expression, const char* message, const char* file, int line)
{
    std::fprintf(stderr, "%s:%d: assertion failed: %s (%s)\n", file, line, message, expression);
    std::abort();
}

std::atomic<AssertHandler> currentHandler{&printAndAbort};

} // namespace

AssertHandler setAssertHandler(AssertHandler handler)
{
    return currentHandler.exchange(handler ? handler : &printAndAbort);
}

namespace detail {

void assertFailed(const char* expression, const char* message, const char* file, int line)
{
    currentHandler.load()(expression, message, file, line);
    std::abort();
}

} // namespace detail

} // namespace lodsmith
