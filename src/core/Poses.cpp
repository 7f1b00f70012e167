#include "Poses.h"

#include "CollapseMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace lodsmith {

namespace {

constexpr double kLargest = 1e8; // scaled; the fourth power stays inside a float

using Point = std::array<float, 3>;

class PoseBuilder {
public:
    PoseBuilder(CollapseMesh& mesh, const MeshView& view)
        : mMesh(mesh), mView(view), mPlaces(mesh.wedgeMotion.empty() ? mesh.vertexCount() : mesh.wedgeMotion.size())
    {
    }

    std::optional<Error> build(std::size_t count)
    {
        mMesh.poses = Poses(count, mPlaces);
        for (std::size_t pose = 0; pose < count; ++pose) {
            const double radius = readPose(pose);
            if (!(radius <= kLargest))
                return Error{ErrorCode::InvalidGeometry,
                             "pose " + std::to_string(pose)
                                 + " is not finite, or more than 100 million times as large as the mesh at rest"};
            mMesh.poses.radius = std::max(mMesh.poses.radius, radius);
        }
        for (std::size_t group = 0; group < mMesh.poses.groups(); ++group)
            buildNormals(group);
        return std::nullopt;
    }

private:
    /// Fills one lane, and tells the radius; NaN or infinity when a position is not finite.
    double readPose(std::size_t pose)
    {
        double sum = 0.0; // finite as long as all of its summands are
        Point low, high;
        low.fill(std::numeric_limits<float>::max());
        high.fill(std::numeric_limits<float>::lowest());
        for (std::uint32_t wedge = 0; wedge < mMesh.nextWedge.size(); ++wedge) {
            const Point point = pointOf(wedge, pose);
            for (std::size_t i = 0; i < 3; ++i) {
                sum += std::abs(point[i]);
                low[i] = std::min(low[i], point[i]);
                high[i] = std::max(high[i], point[i]);
            }
            settle(wedge, pose, point);
        }
        double squared = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double half = 0.5 * (double{high[i]} - double{low[i]});
            squared += half > 0.0 ? half * half : 0.0;
        }
        return std::isfinite(sum) ? std::sqrt(squared) : sum;
    }

    Point pointOf(std::uint32_t wedge, std::size_t pose) const
    {
        const SubMeshView& subMesh = mView.subMeshes[mMesh.subMeshOfWedge(wedge)];
        Point point;
        positionsInPose(mView.vertexBuffers[subMesh.vertexBuffer], pose)
            .read(mMesh.wedgeSource[wedge], 3, point.data());
        for (float& coordinate : point)
            coordinate = static_cast<float>(coordinate * mMesh.scale);
        return point;
    }

    /// The first wedge of a place says where it is, and the others how far that is from the truth.
    void settle(std::uint32_t wedge, std::size_t pose, const Point& point)
    {
        const std::uint32_t place = mMesh.placeOf(wedge);
        Poses::Group& group = mMesh.poses.of(place)[pose / Poses::kLanes];
        const std::size_t lane = pose % Poses::kLanes;
        if (place == wedge) {
            group.position.x[lane] = point[0];
            group.position.y[lane] = point[1];
            group.position.z[lane] = point[2];
            return;
        }
        const Vec3 apart{double{point[0]} - group.position.x[lane], double{point[1]} - group.position.y[lane],
                         double{point[2]} - group.position.z[lane]};
        mMesh.poses.slack = std::max(mMesh.poses.slack, length(apart));
    }

    void buildNormals(std::size_t group)
    {
        struct Sum {
            Lanes3 area{};
            Lanes size{};
        };
        std::vector<Sum> sums(mPlaces);
        for (const CollapseMesh::Face& face : mMesh.faces) {
            const std::uint32_t at[3] = {mMesh.placeOf(face.wedge[0]), mMesh.placeOf(face.wedge[1]),
                                         mMesh.placeOf(face.wedge[2])};
            const Lanes3& corner = mMesh.poses.of(at[0])[group].position;
            const Lanes3 area =
                cross(mMesh.poses.of(at[1])[group].position - corner, mMesh.poses.of(at[2])[group].position - corner);
            const Lanes size = sqrt(dot(area, area));
            for (const std::uint32_t place : at) {
                sums[place].area = sums[place].area + area;
                sums[place].size = sums[place].size + size;
            }
        }
        for (std::uint32_t place = 0; place < mPlaces; ++place) {
            Poses::Group& entry = mMesh.poses.of(place)[group];
            for (std::size_t lane = 0; lane < Poses::kLanes; ++lane) {
                const Sum& sum = sums[place];
                const float scale = Poses::kNormalSteps / std::max(sum.size[lane], std::numeric_limits<float>::min());
                entry.x[lane] = static_cast<std::int8_t>(std::lround(scale * sum.area.x[lane]));
                entry.y[lane] = static_cast<std::int8_t>(std::lround(scale * sum.area.y[lane]));
                entry.z[lane] = static_cast<std::int8_t>(std::lround(scale * sum.area.z[lane]));
            }
        }
    }

    CollapseMesh& mMesh;
    const MeshView& mView;
    std::size_t mPlaces;
};

} // namespace

std::optional<Error> buildPoses(CollapseMesh& mesh, const MeshView& view)
{
    const std::size_t count = poseCount(view);
    return count == 0 ? std::nullopt : PoseBuilder(mesh, view).build(count);
}

} // namespace lodsmith
