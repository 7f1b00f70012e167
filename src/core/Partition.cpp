#include "Partition.h"

#include "Parallel.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace lodsmith {

namespace {

constexpr std::size_t kSample = 1024;   // points that tell where to cut
constexpr std::size_t kFaceChunks = 64; // that faces are listed in; fixed, so that the lists are
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Point {
    float position[3];
    std::uint32_t vertex;
};

/// A range of points that lie together.
struct Range {
    std::size_t begin, end;
    std::size_t size() const { return end - begin; }
};

class Bisection {
public:
    Bisection(const CollapseMesh& mesh, std::size_t largest, double share) : mLargest(largest), mShare(share)
    {
        mPoints.reserve(mesh.liveVertices);
        for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v)
            if (mesh.isAlive(v)) {
                const float* p = mesh.vertices[v].position;
                mPoints.push_back({{p[0], p[1], p[2]}, v});
            }
    }

    /// Cuts all ranges that are too large at once, until there is none.
    std::vector<Range> run(unsigned threads)
    {
        std::vector<Range> done, open{{0, mPoints.size()}};
        while (!open.empty()) {
            std::vector<std::size_t> middle(open.size());
            inParallel(threads, open.size(), [&](std::size_t i) { middle[i] = cut(open[i]); });
            std::vector<Range> next;
            for (std::size_t i = 0; i < open.size(); ++i) {
                const Range halves[] = {{open[i].begin, middle[i]}, {middle[i], open[i].end}};
                const bool isWhole = halves[0].size() == 0 || halves[1].size() == 0;
                for (const Range& half : halves)
                    if (half.size() != 0)
                        (isWhole || half.size() <= mLargest ? done : next).push_back(half);
            }
            open.swap(next);
        }
        return done;
    }

    const std::vector<Point>& points() const { return mPoints; }

private:
    /// Sorts the points of a range to both sides of a plane; the place between.
    std::size_t cut(const Range& range)
    {
        const std::size_t axis = longestAxis(range);
        const float plane = planeAcross(range, axis);
        std::size_t middle = range.begin; // not std::partition(), whose order is the library's own affair
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const bool before = mPoints[i].position[axis] < plane;
            std::swap(mPoints[middle], mPoints[i]);
            middle += before ? 1 : 0;
        }
        return middle;
    }

    float planeAcross(const Range& range, std::size_t axis) const
    {
        std::array<float, kSample> sample{};
        const std::size_t count = std::min(kSample, range.size());
        for (std::size_t i = 0; i < count; ++i)
            sample[i] = mPoints[range.begin + i * range.size() / count].position[axis];
        const auto end = sample.begin() + static_cast<std::ptrdiff_t>(count);
        std::sort(sample.begin(), end);
        const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(mShare * static_cast<double>(count));
        if (*middle != sample[0])
            return *middle;
        const auto next = std::upper_bound(sample.begin(), end, *middle); // so that something is before the plane
        return next == end ? *middle : *next;
    }

    std::size_t longestAxis(const Range& range) const
    {
        std::array<float, 3> low, high, size;
        low.fill(kInfinity);
        high.fill(-kInfinity);
        for (std::size_t i = range.begin; i < range.end; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], mPoints[i].position[axis]);
                high[axis] = std::max(high[axis], mPoints[i].position[axis]);
            }
        for (std::size_t axis = 0; axis < 3; ++axis)
            size[axis] = high[axis] - low[axis];
        return static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    }

    std::vector<Point> mPoints;
    std::size_t mLargest;
    double mShare;
};

/// Turns counts into where each entry's share of a list begins; the whole length.
template <class Counts>
std::uint32_t toOffsets(Counts& counts)
{
    std::uint32_t sum = 0;
    for (std::uint32_t& count : counts) {
        sum += count;
        count = sum - count;
    }
    return sum;
}

} // namespace

Partition::Partition(const CollapseMesh& mesh, std::uint32_t largest, double share, unsigned threads)
{
    std::vector<std::uint32_t> partOf(mesh.vertexCount(), kNone);
    std::size_t parts;
    {
        Bisection bisection(mesh, largest, share);
        const std::vector<Range> ranges = bisection.run(threads);
        parts = ranges.size();
        inParallel(threads, parts, [&](std::size_t i) {
            for (std::size_t point = ranges[i].begin; point < ranges[i].end; ++point)
                partOf[bisection.points()[point].vertex] = static_cast<std::uint32_t>(i);
        });
    }
    listVertices(partOf, parts);
    listFaces(mesh, partOf, threads);
}

void Partition::listVertices(const std::vector<std::uint32_t>& partOf, std::size_t parts)
{
    firstVertex.assign(parts + 1, 0);
    for (const std::uint32_t part : partOf)
        if (part != kNone)
            ++firstVertex[part];
    vertices.resize(toOffsets(firstVertex));
    place.assign(partOf.size(), kNone);
    std::vector<std::uint32_t> next = firstVertex;
    for (std::uint32_t v = 0; v < partOf.size(); ++v)
        if (partOf[v] != kNone) {
            place[v] = next[partOf[v]]++;
            vertices[place[v]] = v;
        }
}

/// In chunks of faces: how many each has for each part tells where it writes them.
void Partition::listFaces(const CollapseMesh& mesh, const std::vector<std::uint32_t>& partOf, unsigned threads)
{
    const std::size_t parts = count();
    std::vector<std::uint32_t> next(kFaceChunks * parts, 0);
    const auto eachPart = [&](std::size_t chunk, auto&& visit) {
        const std::size_t begin = chunk * mesh.faces.size() / kFaceChunks,
                          end = (chunk + 1) * mesh.faces.size() / kFaceChunks;
        std::uint32_t* row = next.data() + chunk * parts;
        for (std::size_t i = begin; i < end; ++i) {
            const CollapseMesh::Face& face = mesh.faces[i];
            if (mesh.isGone(face))
                continue;
            const std::uint32_t a = partOf[mesh.vertexOf(face.wedge[0])], b = partOf[mesh.vertexOf(face.wedge[1])],
                                c = partOf[mesh.vertexOf(face.wedge[2])];
            visit(row[a], i);
            if (b != a)
                visit(row[b], i);
            if (c != a && c != b)
                visit(row[c], i);
        }
    };
    inParallel(threads, kFaceChunks,
               [&](std::size_t chunk) { eachPart(chunk, [](std::uint32_t& at, std::size_t) { ++at; }); });
    std::uint32_t sum = 0;
    for (std::size_t part = 0; part < parts; ++part) {
        firstFace.push_back(sum);
        for (std::size_t chunk = 0; chunk < kFaceChunks; ++chunk) {
            std::uint32_t& at = next[chunk * parts + part];
            sum += at;
            at = sum - at;
        }
    }
    firstFace.push_back(sum);
    faces.resize(sum);
    inParallel(threads, kFaceChunks, [&](std::size_t chunk) {
        eachPart(chunk, [&](std::uint32_t& at, std::size_t face) { faces[at++] = static_cast<std::uint32_t>(face); });
    });
}

} // namespace lodsmith
