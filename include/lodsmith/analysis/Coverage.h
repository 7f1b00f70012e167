#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lodsmith {

/// How much of the original's outline a level fills, as means over all directions. Shares of the original's pixels.
struct Coverage {
    double kept = 1.0;      ///< pixels of the original that the level covers too, 0..1
    double gained = 0.0;    ///< pixels that the level covers and the original does not, >= 0
    double leastKept = 1.0; ///< the direction in which `kept` is least, 0..1

    /// All pixels of the level, >= 0.
    double size() const { return kept + gained; }
};

/// Draws silhouettes of a mesh from the side and compares those of other meshes, its levels, with them.
///
/// Orthographic, from eight directions at right angles to +y, 22.5 degrees apart, over half a turn: opposite directions
/// show the same outline. A pixel is covered when its centre is inside any triangle, from either side; textures, and
/// what they make transparent, are ignored. How many pixels a picture has makes figures rougher or finer and leaves
/// their means as they are.
///
///     const auto meter = CoverageMeter::of(tree);
///     const auto coverage = meter.value().measure(level);
///     if (coverage && coverage.value().kept < 0.95) ...
///
/// Deterministic. Thread-safe once made; throws nothing.
class LODSMITH_API CoverageMeter {
public:
    static constexpr unsigned kMinPixels = 8;
    static constexpr unsigned kMaxPixels = 4096;

    /// Keeps nothing of `original`. Errors: IndexOutOfRange, InvalidGeometry (a referenced position is not finite, or
    /// beyond +-1e18), with submesh and index or vertex; OutOfMemory.
    /// @param pixels kMinPixels..kMaxPixels, others are misuse: the diameter of the original's bounding sphere (farthest
    ///               referenced position from the bounding box's centre); pictures have a margin of an eighth all round
    static Result<CoverageMeter> of(const MeshView& original, unsigned pixels = 512);

    /// A mesh in the same place, of any vertex buffers and submeshes. Where the original covers nothing, everything is
    /// kept. Errors: as of().
    Result<Coverage> measure(const MeshView& level) const;

private:
    std::array<double, 3> mCentre = {0.0, 0.0, 0.0};
    double mPixelsPerUnit = 0.0;
    std::size_t mSide = 0;                ///< pixels a row of a picture, and rows
    std::vector<std::uint64_t> mOriginal; ///< one bit a pixel, picture after picture
};

} // namespace lodsmith
