#pragma once

#include "../core/ClosestPoint.h"
#include "WeldedMesh.h"

#include <lodsmith/core/MeshView.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace lodsmith::analysis {

/// The frame in which two meshes are compared: the box around both lies in -0.5..0.5 and its longest side is at least
/// half as long, whatever their size in the world. Scales by a power of two, so that scaling rounds nothing.
class LocalFrame {
public:
    explicit LocalFrame(const std::vector<Position>& positions);

    Vec3 toLocal(const Position& position) const;
    double toWorld(double localLength) const;

private:
    Vec3 mCentre;
    int mExponent = 0; ///< a local length is 2^mExponent times the world's
};

/// Distances below this, in a LocalFrame, are taken as equal: wide enough for coordinates rounded to float, too small
/// to see.
constexpr double kTolerance = 1e-6;

/// A texture coordinate of 1..4 components.
struct UvPoint {
    int components = 0;
    std::array<double, 4> value{};
};

/// A mesh as a surface to sample and to search: the triangles that have three different corners, in a LocalFrame, with
/// their attributes. Keeps references to the view's memory and to the points.
class Surface {
public:
    /// @param points local position of each welded position
    Surface(const MeshView& mesh, const std::vector<WeldedTriangle>& triangles, const std::vector<Vec3>& points);

    const MeshView& mesh() const { return mMesh; }
    std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(mTriangles.size()); }
    const WeldedTriangle& triangle(std::uint32_t number) const { return mTriangles[number]; }
    const std::vector<Vec3>& points() const { return mPoints; }
    std::uint32_t subMesh(std::uint32_t triangle) const { return mTriangles[triangle].subMesh; }
    std::uint32_t vertexBuffer(std::uint32_t triangle) const { return mMesh.subMeshes[subMesh(triangle)].vertexBuffer; }
    /// Whether any triangle belongs to the submesh.
    bool draws(std::uint32_t subMesh) const { return mDraws[subMesh]; }

    const Corners& corners(std::uint32_t triangle) const { return mCorners[triangle]; }
    /// Along the front side, twice the area long.
    Vec3 faceNormal(std::uint32_t triangle) const;
    /// The interpolated normal, or the face's where there is none; of length 1, or 0 for a triangle without area.
    Vec3 shadingNormal(std::uint32_t triangle, const Barycentric& weights) const;
    /// The interpolated coordinate of set 0, where there is one.
    std::optional<UvPoint> uv(std::uint32_t triangle, const Barycentric& weights) const;

private:
    const VertexBufferView& bufferOf(std::uint32_t triangle) const;

    const MeshView& mMesh;
    const std::vector<Vec3>& mPoints;
    std::vector<WeldedTriangle> mTriangles;
    std::vector<Corners> mCorners; ///< side by side in memory, because searches read little else
    std::vector<bool> mDraws;
};

} // namespace lodsmith::analysis
