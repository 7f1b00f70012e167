#include "ShapeChoice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

constexpr std::size_t kMostVertices = 4096; // looked at, evenly spread
constexpr double kLeastNews = 1e-3;         // of the radius

/// Some of a mesh's vertices, and where poses and morph frames move them.
class Shapes {
public:
    Shapes(const MeshView& mesh, const OffsetMoments& offsets) : mMesh(mesh), mOffsets(offsets)
    {
        std::size_t vertices = 0;
        for (const VertexBufferView& buffer : mesh.vertexBuffers)
            vertices += buffer.vertexCount;
        mStride = vertices / kMostVertices + 1;
        for (const std::vector<PoseMoment>& ofBuffer : offsets)
            for (const PoseMoment& moment : ofBuffer)
                if (std::find(mMoments.begin(), mMoments.end(), moment) == mMoments.end())
                    mMoments.push_back(moment);
    }

    const std::vector<PoseMoment>& moments() const { return mMoments; }

    /// How far a shape moves each of the vertices, x, y and z after one another.
    std::vector<float> offsetsOf(const PoseMoment& moment) const
    {
        std::vector<float> moved;
        for (std::size_t b = 0; b < mMesh.vertexBuffers.size(); ++b) {
            const VertexBufferView& buffer = mMesh.vertexBuffers[b];
            const auto at = std::find(mOffsets[b].begin(), mOffsets[b].end(), moment);
            for (std::size_t v = 0; v < buffer.vertexCount; v += mStride) {
                float offset[3] = {0.0f, 0.0f, 0.0f};
                if (at != mOffsets[b].end())
                    buffer.offsets[static_cast<std::size_t>(at - mOffsets[b].begin())].read(v, 3, offset);
                moved.insert(moved.end(), offset, offset + 3);
            }
        }
        return moved;
    }

    /// Half the diagonal of the box around the vertices, squared.
    double squaredRadius() const
    {
        double low[3], high[3], sum = 0.0;
        std::fill(low, low + 3, std::numeric_limits<double>::max());
        std::fill(high, high + 3, std::numeric_limits<double>::lowest());
        for (const VertexBufferView& buffer : mMesh.vertexBuffers)
            for (std::size_t v = 0; v < buffer.vertexCount; v += mStride) {
                float position[3];
                buffer.positions.read(v, 3, position);
                for (std::size_t i = 0; i < 3; ++i) {
                    low[i] = std::min<double>(low[i], position[i]);
                    high[i] = std::max<double>(high[i], position[i]);
                }
            }
        for (std::size_t i = 0; i < 3; ++i)
            sum += 0.25 * (high[i] - low[i]) * (high[i] - low[i]);
        return sum;
    }

private:
    const MeshView& mMesh;
    const OffsetMoments& mOffsets;
    std::size_t mStride = 1;
    std::vector<PoseMoment> mMoments;
};

/// Mean of the squared distances.
double squaredDistance(const std::vector<float>& a, const std::vector<float>& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += (double{a[i]} - b[i]) * (double{a[i]} - b[i]);
    return 3.0 * sum / static_cast<double>(a.size());
}

} // namespace

std::vector<PoseMoment> chooseShapes(const MeshView& mesh, const OffsetMoments& offsets, std::size_t most)
{
    const Shapes shapes(mesh, offsets);
    const std::vector<PoseMoment>& moments = shapes.moments();
    if (moments.empty())
        return {};
    std::vector<double> news(moments.size(), std::numeric_limits<double>::infinity());
    std::vector<float> shown(shapes.offsetsOf(moments[0]).size(), 0.0f);
    const double least = kLeastNews * kLeastNews * shapes.squaredRadius();
    std::vector<PoseMoment> chosen;
    while (true) {
        std::size_t next = moments.size();
        double farthest = least;
        for (std::size_t i = 0; i < moments.size(); ++i) {
            const double distance = squaredDistance(shapes.offsetsOf(moments[i]), shown);
            news[i] = std::isfinite(distance) ? std::min(news[i], distance) : 0.0;
            if (news[i] > farthest) {
                farthest = news[i];
                next = i;
            }
        }
        if (next == moments.size() || chosen.size() == most)
            return chosen;
        chosen.push_back(moments[next]);
        shown = shapes.offsetsOf(moments[next]);
    }
}

} // namespace lodsmith
