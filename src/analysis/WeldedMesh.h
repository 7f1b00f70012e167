#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/MeshView.h>
#include <lodsmith/core/Result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lodsmith::analysis {

using Position = std::array<float, 3>;

/// Numbers positions so that equal ones (bit for bit, but -0 equal to +0) have the same number, counted from 0.
/// Exported, as the functions below, for the generators.
class LODSMITH_API PositionTable {
public:
    /// The number of a position, a new one if it is not there yet.
    std::uint32_t insert(Position position);
    const std::vector<Position>& positions() const { return mPositions; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(mPositions.size()); }

private:
    std::size_t slotOf(const Position& position) const;
    void grow();

    std::vector<Position> mPositions;
    std::vector<std::uint32_t> mSlots; ///< open addressing; a power of two, at most half full
};

/// A triangle in terms of welded positions, with the way back to the buffers.
struct WeldedTriangle {
    std::array<std::uint32_t, 3> position; ///< numbers in the PositionTable
    std::array<std::uint32_t, 3> vertex;   ///< in the submesh's vertex buffer
    std::uint32_t subMesh;

    /// Two corners at one position: no surface at all.
    bool collapsed() const
    {
        return position[0] == position[1] || position[1] == position[2] || position[2] == position[0];
    }
};

/// All triangles of all submeshes, in order, on welded positions.
/// Meshes welded with the same table have the same number for the same place.
/// Errors: IndexOutOfRange; InvalidGeometry for a referenced position that is not finite.
LODSMITH_API Result<std::vector<WeldedTriangle>> weldTriangles(const MeshView& mesh, PositionTable& table);

/// The same with the positions of a pose, for the triangles that have three different ones at rest.
Result<std::vector<WeldedTriangle>> weldTrianglesInPose(const MeshView& mesh, std::size_t pose, PositionTable& table);

/// What makes a triangle the repetition of another with the same three positions.
enum class Repetition {
    AnyWinding,           ///< nothing else
    SameWindingAndSubMesh ///< it runs the same way round and belongs to the same submesh
};

/// For each triangle, whether it repeats an earlier one. A collapsed triangle neither repeats nor is repeated.
LODSMITH_API std::vector<bool> findRepeated(const std::vector<WeldedTriangle>& triangles, Repetition kind);

} // namespace lodsmith::analysis
