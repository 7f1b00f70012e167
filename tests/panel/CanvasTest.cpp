#include "Canvas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lodsmith::test {
namespace {

constexpr Rgba kBlack = {0, 0, 0, 255};
constexpr Rgba kRed = {255, 0, 0, 255};

Canvas black(unsigned width, unsigned height)
{
    Canvas canvas(width, height);
    canvas.fill(kBlack);
    return canvas;
}

TEST(CanvasTest, IsTransparentBeforeItIsFilled)
{
    const Canvas canvas(3, 2);
    EXPECT_EQ(canvas.pixel(2, 1), (Rgba{0, 0, 0, 0}));
}

TEST(CanvasTest, HasAtLeastOnePixel)
{
    const Canvas canvas(0, 0);
    EXPECT_EQ(canvas.width(), 1u);
    EXPECT_EQ(canvas.height(), 1u);
}

TEST(CanvasTest, LevelLineOnPixelCentresIsSharp)
{
    Canvas canvas = black(20, 9);
    canvas.line(4.5f, 4.5f, 15.5f, 4.5f, 1, kRed);
    for (unsigned x = 4; x <= 15; ++x) {
        EXPECT_EQ(canvas.pixel(x, 4), kRed) << x;
        EXPECT_EQ(canvas.pixel(x, 3), kBlack) << x;
        EXPECT_EQ(canvas.pixel(x, 5), kBlack) << x;
    }
    EXPECT_EQ(canvas.pixel(3, 4), kBlack);
    EXPECT_EQ(canvas.pixel(16, 4), kBlack);
}

TEST(CanvasTest, LineBetweenPixelsIsSharedByThem)
{
    Canvas canvas = black(20, 10);
    canvas.line(2, 5, 18, 5, 1, kRed);
    EXPECT_NEAR(canvas.pixel(10, 4)[0], 128, 1);
    EXPECT_NEAR(canvas.pixel(10, 5)[0], 128, 1);
    EXPECT_EQ(canvas.pixel(10, 3), kBlack);
}

TEST(CanvasTest, SlantedLineGoesThroughItsPixelsAndIsSmoothed)
{
    Canvas canvas = black(40, 40);
    canvas.line(5.5f, 5.5f, 34.5f, 20.0f, 2, kRed);
    for (unsigned x = 6; x < 34; ++x) {
        const float y = 5.5f + (static_cast<float>(x) + 0.5f - 5.5f) * 0.5f;
        EXPECT_EQ(canvas.pixel(x, static_cast<unsigned>(y))[0], 255) << x;
        EXPECT_EQ(canvas.pixel(x, static_cast<unsigned>(y) + 3)[0], 0) << x;
    }
    unsigned between = 0;
    for (unsigned y = 0; y < 40; ++y)
        between += canvas.pixel(20, y)[0] > 0 && canvas.pixel(20, y)[0] < 255;
    EXPECT_GE(between, 1u);
}

TEST(CanvasTest, HalfTransparentColourMixes)
{
    Canvas canvas = black(5, 5);
    canvas.line(0, 2.5f, 5, 2.5f, 1, {255, 255, 255, 128});
    EXPECT_EQ(canvas.pixel(2, 2), (Rgba{128, 128, 128, 255}));
}

TEST(CanvasTest, DiscCoversItsArea)
{
    Canvas canvas = black(41, 41);
    canvas.disc(20.5f, 20.5f, 10, kRed);
    double covered = 0;
    for (unsigned y = 0; y < 41; ++y)
        for (unsigned x = 0; x < 41; ++x)
            covered += canvas.pixel(x, y)[0] / 255.0;
    EXPECT_NEAR(covered, 3.14159 * 100, 3);
    EXPECT_EQ(canvas.pixel(20, 20), kRed);
    EXPECT_EQ(canvas.pixel(20, 9), kBlack);
}

TEST(CanvasTest, WhatIsBeyondTheEdgesIsLeftOut)
{
    Canvas canvas = black(8, 8);
    canvas.line(-1000, 3.5f, 1000, 3.5f, 1, kRed);
    canvas.disc(-50, -50, 3, kRed);
    canvas.disc(1e9f, 4, 3, kRed);
    EXPECT_EQ(canvas.pixel(0, 3), kRed);
    EXPECT_EQ(canvas.pixel(7, 3), kRed);
    EXPECT_EQ(canvas.pixel(0, 0), kBlack);
    EXPECT_EQ(canvas.pixel(7, 4), kBlack);
}

} // namespace
} // namespace lodsmith::test
