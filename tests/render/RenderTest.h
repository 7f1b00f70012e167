#pragma once

#include <support/RenderSession.h>

#include <gtest/gtest.h>

#include <memory>

namespace lodsmith::test {

/// A test that draws. Skipped where there is no Xvfb.
class RenderTest : public testing::Test {
protected:
    explicit RenderTest(std::uint32_t width = 640, std::uint32_t height = 480) : mWidth(width), mHeight(height) {}

    void SetUp() override
    {
        if (!VirtualDisplay::isAvailable())
            GTEST_SKIP() << "Xvfb is not installed";
        mSession = std::make_unique<RenderSession>(mWidth, mHeight);
    }

    std::unique_ptr<RenderSession> mSession;

private:
    std::uint32_t mWidth;
    std::uint32_t mHeight;
};

} // namespace lodsmith::test
