#include "Canvas.h"

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

/// Where a point lies on the way from one end to the other, 0..1, when moved onto the line.
float shareOfWay(float x, float y, float wayX, float wayY)
{
    const float squared = wayX * wayX + wayY * wayY;
    return squared > 0 ? std::clamp((x * wayX + y * wayY) / squared, 0.0f, 1.0f) : 0.0f;
}

/// The first and the one past the last pixel that something from `low` to `high` touches, among `count`.
std::pair<unsigned, unsigned> pixelsOf(float low, float high, unsigned count)
{
    const auto limit = static_cast<float>(count);
    return {static_cast<unsigned>(std::clamp(std::floor(low), 0.0f, limit)),
            static_cast<unsigned>(std::clamp(std::ceil(high), 0.0f, limit))};
}

} // namespace

Canvas::Canvas(unsigned width, unsigned height)
    : mWidth(std::max(width, 1u)), mHeight(std::max(height, 1u)), mPixels(std::size_t(mWidth) * mHeight)
{
}

void Canvas::fill(const Rgba& colour)
{
    std::fill(mPixels.begin(), mPixels.end(), colour);
}

void Canvas::blend(unsigned x, unsigned y, float coverage, const Rgba& colour)
{
    Rgba& pixel = mPixels[std::size_t(y) * mWidth + x];
    const float share = coverage * static_cast<float>(colour[3]) / 255.0f;
    for (std::size_t i = 0; i < 3; ++i)
        pixel[i] = static_cast<std::uint8_t>(
            std::lround(static_cast<float>(pixel[i]) * (1 - share) + static_cast<float>(colour[i]) * share));
    pixel[3] = static_cast<std::uint8_t>(std::lround(static_cast<float>(pixel[3]) * (1 - share) + 255.0f * share));
}

void Canvas::line(float fromX, float fromY, float toX, float toY, float thickness, const Rgba& colour)
{
    if (!std::isfinite(fromX + fromY + toX + toY + thickness))
        return;
    const float reach = thickness / 2 + 0.5f;
    const auto [left, right] = pixelsOf(std::min(fromX, toX) - reach, std::max(fromX, toX) + reach, mWidth);
    const auto [top, bottom] = pixelsOf(std::min(fromY, toY) - reach, std::max(fromY, toY) + reach, mHeight);
    const float wayX = toX - fromX, wayY = toY - fromY;
    for (unsigned row = top; row < bottom; ++row)
        for (unsigned column = left; column < right; ++column) {
            const float x = static_cast<float>(column) + 0.5f - fromX, y = static_cast<float>(row) + 0.5f - fromY;
            const float share = shareOfWay(x, y, wayX, wayY);
            const float distance = std::hypot(x - share * wayX, y - share * wayY);
            blend(column, row, std::clamp(reach - distance, 0.0f, 1.0f), colour);
        }
}

} // namespace lodsmith
