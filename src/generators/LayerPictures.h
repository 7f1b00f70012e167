#pragma once

#include "../analysis/SilhouetteScan.h"
#include "Leaves.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lodsmith::generators {

using PictureTriangle = std::array<analysis::SilhouettePoint, 3>;

inline PictureTriangle project(const analysis::SilhouetteFrame& frame, const std::array<Point, 3>& corner)
{
    return {analysis::project(frame, corner[0]), analysis::project(frame, corner[1]),
            analysis::project(frame, corner[2])};
}

/// For each pixel from each direction how many leaves are behind each other, or that wood is there.
class LayerPictures {
public:
    static constexpr std::uint32_t kWood = 0x80000000u; ///< added to the count of leaves

    /// The frame has to stay where it is.
    explicit LayerPictures(const analysis::SilhouetteFrame& frame) : mFrame(&frame), mLayers(frame.pixels()) {}

    const std::vector<std::uint32_t>& layers() const { return mLayers; }

    void addWood(const PictureTriangle& triangle)
    {
        analysis::forEachRun(*mFrame, triangle, [this](std::size_t first, std::size_t last) {
            for (std::size_t pixel = first; pixel < last; ++pixel)
                mLayers[pixel] |= kWood;
        });
    }

    void addLeaf(const PictureTriangle& triangle)
    {
        analysis::forEachRun(*mFrame, triangle, [this](std::size_t first, std::size_t last) {
            for (std::size_t pixel = first; pixel < last; ++pixel)
                ++mLayers[pixel];
        });
    }

private:
    const analysis::SilhouetteFrame* mFrame;
    std::vector<std::uint32_t> mLayers;
};

/// What layers look like.
class Opacity {
public:
    /// @param ofLeaf above 0, to 1
    explicit Opacity(double ofLeaf);

    /// 0..1
    double of(std::uint32_t layers) const
    {
        return layers >= LayerPictures::kWood ? 1.0 : mOf[std::min<std::size_t>(layers, mOf.size() - 1)];
    }

private:
    std::array<double, 256> mOf;
};

} // namespace lodsmith::generators
