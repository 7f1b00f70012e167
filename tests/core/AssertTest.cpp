#include <lodsmith/core/Assert.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace lodsmith {

namespace {

void throwIt(const char* expression, const char* message, const char*, int)
{
    throw std::logic_error(std::string(expression) + ": " + message);
}

/// Puts the handler that was there before back, whatever the test does.
class ScopedHandler {
public:
    explicit ScopedHandler(AssertHandler handler) : mBefore(setAssertHandler(handler)) {}
    ~ScopedHandler() { setAssertHandler(mBefore); }
    ScopedHandler(const ScopedHandler&) = delete;
    ScopedHandler& operator=(const ScopedHandler&) = delete;

private:
    AssertHandler mBefore;
};

TEST(Assert, DoesNothingWhenThePromiseIsKept)
{
    const ScopedHandler handler(&throwIt);
    EXPECT_NO_THROW(LODSMITH_ASSERT(1 + 1 == 2, "sums"));
}

TEST(Assert, TellsTheHandlerWhatWasBroken)
{
    const ScopedHandler handler(&throwIt);
    try {
        LODSMITH_ASSERT(1 + 1 == 3, "sums");
        FAIL() << "the handler was not called";
    } catch (const std::logic_error& error) {
        EXPECT_STREQ(error.what(), "1 + 1 == 3: sums");
    }
}

TEST(Assert, ReturnsTheHandlerBefore)
{
    const AssertHandler first = setAssertHandler(&throwIt);
    EXPECT_EQ(setAssertHandler(nullptr), &throwIt);
    EXPECT_EQ(setAssertHandler(first), first);
}

TEST(AssertDeathTest, AbortsByDefault)
{
    EXPECT_DEATH(LODSMITH_ASSERT(false, "a promise"), "AssertTest.cpp:[0-9]+: assertion failed: a promise \\(false\\)");
}

TEST(AssertDeathTest, AbortsWhenTheHandlerReturns)
{
    const auto ignore = [](const char*, const char*, const char*, int) {};
    EXPECT_DEATH(
        {
            setAssertHandler(ignore);
            LODSMITH_ASSERT(false, "a promise");
        },
        "");
}

} // namespace

} // namespace lodsmith
