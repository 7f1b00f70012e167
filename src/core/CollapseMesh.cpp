#include "CollapseMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodsmith {

namespace {

constexpr std::uint32_t kPrefetched = 12; // faces a vertex, at most
constexpr std::uint32_t kListSlack =
    2; // a collapse between vertices of ordinary valence adds two faces to the destination

constexpr double kRightAngle = 1.5707963;
constexpr float kLeastFloat = std::numeric_limits<float>::min();

/// To a float, never below (but for what is too small for a float to be exact about).
float roundUp(double bound)
{
    return static_cast<float>(bound * (1.0 + std::numeric_limits<float>::epsilon()));
}

/// Angle at a corner between the side that leaves it and the one that arrives; to 0.1.
float angleBetween(const Vec3& leaving, const Vec3& arriving)
{
    const double cosine =
        std::clamp(-dot(leaving, arriving) / std::sqrt(lengthSquared(leaving) * lengthSquared(arriving)), -1.0, 1.0);
    return static_cast<float>(kRightAngle * std::max(0.0, 1.0 - cosine * (0.64 + 0.36 * cosine * cosine)));
}

} // namespace

void CollapseMesh::setPlane(Face& face, const Vec3& doubledArea)
{
    const double size = length(doubledArea);
    const double inverse = size > 0.0 ? 1.0 / size : 0.0;
    face.normal[0] = static_cast<float>(doubledArea.x * inverse);
    face.normal[1] = static_cast<float>(doubledArea.y * inverse);
    face.normal[2] = static_cast<float>(doubledArea.z * inverse);
    face.area = static_cast<float>(0.5 * size);
}

void CollapseMesh::buildPlanes()
{
    struct Sum {
        float normal[3] = {0.0f, 0.0f, 0.0f}, weight = 0.0f;
    };
    std::vector<Sum> sums(vertices.size());
    for (Face& face : faces) {
        const auto [a, b, c] = cornersOf(face);
        const Vec3 sides[3] = {b - a, c - b, a - c};
        setPlane(face, cross(sides[2], sides[0]));
        area += face.area;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Sum& sum = sums[vertexOf(face.wedge[corner])];
            const float weight = angleBetween(sides[corner], sides[(corner + 2) % 3]);
            for (int i = 0; i < 3; ++i)
                sum.normal[i] += weight * face.normal[i];
            sum.weight += weight;
        }
    }
    meanNormals.resize(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v)
        for (std::size_t i = 0; i < 3; ++i) {
            const float steps = kNormalSteps * sums[v].normal[i] / std::max(sums[v].weight, kLeastFloat);
            meanNormals[v][i] = static_cast<std::int8_t>(steps + std::copysign(0.5f, steps));
        }
}

void CollapseMesh::prefetchFaces(std::uint32_t vertex) const
{
    const std::uint32_t* list = faceList(vertex);
    for (std::uint32_t i = 0; i < std::min(vertices[vertex].faceSlots, kPrefetched); ++i)
        prefetch(&faces[list[i]]);
}

void CollapseMesh::prefetchNeighbours(std::uint32_t vertex) const
{
    const std::uint32_t* list = faceList(vertex);
    for (std::uint32_t i = 0; i < std::min(vertices[vertex].faceSlots, kPrefetched); ++i) {
        const Face& face = faces[list[i]];
        if (isGone(face))
            continue;
        // Around a closed fan, the corner after the vertex's own comes to each neighbour once.
        const int next = vertexOf(face.wedge[0]) == vertex ? 1 : vertexOf(face.wedge[1]) == vertex ? 2 : 0;
        prefetch(&vertices[vertexOf(face.wedge[next])]);
        prefetch(attributesOf(face.wedge[next]));
        prefetch(&meanNormals[vertexOf(face.wedge[next])]);
    }
}

void CollapseMesh::countFaces()
{
    for (Vertex& vertex : vertices)
        vertex.liveFaces = 0;
    liveFaces = liveVertices = 0;
    for (const Face& face : faces) {
        if (isGone(face))
            continue;
        ++liveFaces;
        for (std::uint32_t wedge : face.wedge)
            liveVertices += vertices[vertexOf(wedge)].liveFaces++ == 0;
    }
}

void CollapseMesh::buildFaceLists()
{
    std::uint32_t first = 0;
    for (Vertex& vertex : vertices) {
        vertex.firstFace = first;
        vertex.faceSlots = 0;
        vertex.faceCapacity = vertex.liveFaces != 0 ? vertex.liveFaces + kListSlack : 0;
        first += vertex.faceCapacity;
    }
    mFaceLists.reserve(first + first / 8);
    mFaceLists.resize(first);
    for (std::uint32_t i = 0; i < faces.size(); ++i) {
        if (isGone(faces[i]))
            continue;
        for (std::uint32_t wedge : faces[i].wedge) {
            Vertex& vertex = vertices[vertexOf(wedge)];
            mFaceLists[vertex.firstFace + vertex.faceSlots++] = i;
        }
    }
}

void CollapseMesh::compactFaceList(std::uint32_t vertexNumber)
{
    Vertex& vertex = vertices[vertexNumber];
    if (vertex.faceSlots == vertex.liveFaces)
        return;
    std::uint32_t* list = mFaceLists.data() + vertex.firstFace;
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < vertex.faceSlots; ++i) {
        list[kept] = list[i];
        kept += isGone(faces[list[i]]) ? 0 : 1;
    }
    vertex.faceSlots = kept;
}

void CollapseMesh::moveFaces(std::uint32_t from, std::uint32_t to, const std::uint32_t* moved, std::uint32_t count)
{
    if (count == 0)
        return;
    Vertex& vertex = vertices[to];
    if (vertex.faceSlots + count > vertex.faceCapacity)
        compactFaceList(to);
    if (vertex.faceSlots + count > vertex.faceCapacity)
        growFaceList(vertex, vertex.faceSlots + count);
    std::copy(moved, moved + count, mFaceLists.begin() + vertex.firstFace + vertex.faceSlots);
    vertex.faceSlots += count;
    // Removing the faces on the edge may have left the destination without any for a moment.
    if (vertex.liveFaces != 0)
        --liveVertices;
    vertex.liveFaces += count;
    vertices[from].liveFaces = vertices[from].faceSlots = 0;
}

void CollapseMesh::growFaceList(Vertex& vertex, std::uint32_t needed)
{
    const std::uint32_t capacity = needed + needed / 4 + 1; // a share, so that a hub of many faces is copied seldom
    if (mFaceLists.size() + capacity > mFaceLists.capacity())
        compactAllFaceLists();
    const std::size_t first = mFaceLists.size();
    mFaceLists.resize(first + capacity);
    std::copy_n(mFaceLists.begin() + vertex.firstFace, vertex.faceSlots,
                mFaceLists.begin() + static_cast<std::ptrdiff_t>(first));
    vertex.firstFace = static_cast<std::uint32_t>(first);
    vertex.faceCapacity = capacity;
}

void CollapseMesh::compactAllFaceLists()
{
    std::size_t entries = 0;
    for (std::uint32_t v = 0; v < vertexCount(); ++v) {
        compactFaceList(v);
        entries += vertices[v].faceSlots;
    }
    std::vector<std::uint32_t> packed;
    packed.reserve(entries + kListSlack * std::size_t{liveVertices} + entries / 4 + 1024);
    for (Vertex& vertex : vertices) {
        const auto list = mFaceLists.begin() + vertex.firstFace;
        vertex.firstFace = static_cast<std::uint32_t>(packed.size());
        packed.insert(packed.end(), list, list + vertex.faceSlots);
        vertex.faceCapacity = vertex.faceSlots + (vertex.faceSlots != 0 ? kListSlack : 0);
        packed.resize(vertex.firstFace + vertex.faceCapacity);
    }
    mFaceLists.swap(packed);
}

void CollapseMesh::raiseFaceDeviation(std::uint32_t face, double deviation)
{
    faces[face].deviation = std::max(faces[face].deviation, roundUp(deviation));
}

void CollapseMesh::raiseDeviation(std::uint32_t vertex, double deviation)
{
    compactFaceList(vertex);
    for (std::uint32_t i = 0; i < vertices[vertex].faceSlots; ++i)
        raiseFaceDeviation(faceList(vertex)[i], deviation);
}

void CollapseMesh::removeFace(std::uint32_t number)
{
    Face& face = faces[number];
    for (std::uint32_t wedge : face.wedge)
        if (--vertices[vertexOf(wedge)].liveFaces == 0)
            --liveVertices;
    face.wedge[0] = kNone;
    --liveFaces;
}

} // namespace lodsmith
