#include "Tube.h"

#include <cmath>

namespace lodsmith::media {

namespace {

using Ogre::Vector2;
using Ogre::Vector3;

constexpr float kTurn = 6.2831853f;

/// Angle of corner `i`; the last corner lies exactly on the first.
float cornerAngle(std::uint32_t i, std::uint32_t sides)
{
    return kTurn * float(i % sides) / float(sides);
}

Vector3 tangentAt(const std::vector<TubeRing>& rings, std::size_t i)
{
    const std::size_t before = i == 0 ? 0 : i - 1, behind = i + 1 == rings.size() ? i : i + 1;
    return (rings[behind].centre - rings[before].centre).normalisedCopy();
}

/// Joins two rows of `columns + 1` vertices each.
void joinRows(Shape& shape, std::uint32_t lower, std::uint32_t upper, std::uint32_t columns)
{
    for (std::uint32_t i = 0; i < columns; ++i)
        shape.addQuad(lower + i, lower + i + 1, upper + i + 1, upper + i);
}

/// One straight piece of a profile, or a smooth run of them.
void addLatheRun(Shape& shape, const Placement& placement, const std::vector<ProfilePoint>& run, std::uint32_t sides,
                 float uvScale)
{
    float along = 0.0f;
    std::uint32_t previous = 0;
    for (std::size_t i = 0; i < run.size(); ++i) {
        const ProfilePoint& before = run[i == 0 ? 0 : i - 1];
        const ProfilePoint& behind = run[i + 1 == run.size() ? i : i + 1];
        const Vector2 outward = Vector2(behind.height - before.height, before.radius - behind.radius).normalisedCopy();
        if (i > 0)
            along += Vector2(run[i].radius - before.radius, run[i].height - before.height).length();
        const auto row = static_cast<std::uint32_t>(shape.vertices.size());
        for (std::uint32_t corner = 0; corner <= sides; ++corner) {
            const float angle = cornerAngle(corner, sides);
            const Vector3 radial(std::cos(angle), 0.0f, -std::sin(angle));
            const Vector3 position = radial * run[i].radius + Vector3(0.0f, run[i].height, 0.0f);
            const Vector3 normal = radial * outward.x + Vector3(0.0f, outward.y, 0.0f);
            shape.add({placement.position + placement.orientation * position, placement.orientation * normal,
                       Vector2(float(corner) / float(sides), along * uvScale)});
        }
        if (i > 0)
            joinRows(shape, previous, row, sides);
        previous = row;
    }
}

} // namespace

void addTube(Shape& shape, const std::vector<TubeRing>& rings, std::uint32_t sides, float uvRepeats)
{
    Vector3 across = tangentAt(rings, 0).perpendicular();
    float along = 0.0f;
    std::uint32_t previous = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const Vector3 tangent = tangentAt(rings, i);
        across = (across - tangent * across.dotProduct(tangent)).normalisedCopy();
        const Vector3 third = tangent.crossProduct(across);
        if (i > 0)
            along += (rings[i].centre - rings[i - 1].centre).length();
        const auto row = static_cast<std::uint32_t>(shape.vertices.size());
        for (std::uint32_t corner = 0; corner <= sides; ++corner) {
            const float angle = cornerAngle(corner, sides);
            const Vector3 radial = across * std::cos(angle) + third * std::sin(angle);
            shape.add(
                {rings[i].centre + radial * rings[i].radius, radial,
                 Vector2(uvRepeats * float(corner) / float(sides), -along * uvRepeats / (kTurn * rings[0].radius))});
        }
        if (i > 0)
            joinRows(shape, previous, row, sides);
        previous = row;
    }
}

void addLathe(Shape& shape, const Placement& placement, const std::vector<ProfilePoint>& profile, std::uint32_t sides,
              float uvScale)
{
    std::vector<ProfilePoint> run{profile.front()};
    for (std::size_t i = 1; i < profile.size(); ++i) {
        run.push_back(profile[i]);
        if (profile[i].hard || i + 1 == profile.size()) {
            addLatheRun(shape, placement, run, sides, uvScale);
            run = {profile[i]};
        }
    }
}

void addTorus(Shape& shape, const Placement& placement, float ringRadius, float wireRadius, std::uint32_t ringSides,
              std::uint32_t wireSides, float uvScale)
{
    const auto first = static_cast<std::uint32_t>(shape.vertices.size());
    for (std::uint32_t ring = 0; ring <= ringSides; ++ring) {
        const float turn = cornerAngle(ring, ringSides);
        const Vector3 radial(std::cos(turn), std::sin(turn), 0.0f);
        for (std::uint32_t wire = 0; wire <= wireSides; ++wire) {
            const float angle = cornerAngle(wire, wireSides);
            const Vector3 normal = radial * std::cos(angle) + Vector3(0.0f, 0.0f, -std::sin(angle));
            shape.add({placement.position + placement.orientation * (radial * ringRadius + normal * wireRadius),
                       placement.orientation * normal,
                       Vector2(kTurn * ringRadius * uvScale * float(ring) / float(ringSides),
                               kTurn * wireRadius * uvScale * float(wire) / float(wireSides))});
        }
    }
    for (std::uint32_t ring = 0; ring < ringSides; ++ring)
        joinRows(shape, first + ring * (wireSides + 1), first + (ring + 1) * (wireSides + 1), wireSides);
}

} // namespace lodsmith::media
