#include "DrakeBody.h"
#include "DrakeSkeleton.h"
#include "ImplicitSurface.h"
#include "MeshExport.h"
#include "Models.h"
#include "Tube.h"

#include <OgreMath.h>
#include <OgreSkeletonSerializer.h>
#include <OgreVertexIndexData.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace lodsmith::media {

namespace {

using Ogre::Vector2;
using Ogre::Vector3;

constexpr float kCell = 0.045f;

/// A shape and, vertex for vertex, the bones that move it.
struct SkinnedShape {
    Shape shape;
    std::vector<std::vector<BoneShare>> shares;
};

/// A limb's place in the texture.
struct Chart {
    Vector2 corner;
    Vector2 size;
};

Chart chartOf(Limb limb)
{
    switch (limb) {
    case Limb::Torso: return {Vector2(0, 0), Vector2(1, 0.27f)};
    case Limb::Neck: return {Vector2(0, 0.27f), Vector2(1, 0.25f)};
    case Limb::Tail: return {Vector2(0, 0.52f), Vector2(1, 0.16f)};
    default: return {Vector2(0.25f * float(int(limb) - int(Limb::FrontLeft)), 0.68f), Vector2(0.25f, 0.32f)};
    }
}

constexpr float kMostTurns = 1.25f; ///< a chart's width in turns: triangles across the seam reach beyond the first
constexpr float kAlongStart = -0.25f, kAlongSize = 2.1f; ///< metres of a limb that its chart shows

Vector2 chartUv(Limb limb, const Vector2& coordinates)
{
    const Chart chart = chartOf(limb);
    const float u = Ogre::Math::Clamp(coordinates.x / kMostTurns, 0.0f, 1.0f);
    const float v = Ogre::Math::Clamp((coordinates.y - kAlongStart) / kAlongSize, 0.0f, 1.0f);
    return chart.corner + chart.size * Vector2(u, v);
}

/// Cuts the surface into one chart a limb, and each chart open along its seam.
SkinnedShape unwrap(const SurfaceMesh& surface)
{
    SkinnedShape skin;
    skin.shape.material = "lodsmith/drake/skin";
    std::map<std::tuple<std::uint32_t, Limb, bool>, std::uint32_t> wedges;
    for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
        const std::uint32_t corners[3] = {surface.indices[i], surface.indices[i + 1], surface.indices[i + 2]};
        const auto& p = surface.positions;
        const Limb limb = nearestLimb((p[corners[0]] + p[corners[1]] + p[corners[2]]) / 3.0f);
        Vector2 places[3];
        float most = 0.0f;
        for (int corner = 0; corner < 3; ++corner) {
            places[corner] = limbCoordinates(limb, p[corners[corner]]);
            most = std::max(most, places[corner].x);
        }
        for (int corner = 0; corner < 3; ++corner) {
            const bool beyond = most - places[corner].x > 0.5f;
            const Vector2 place = places[corner] + Vector2(beyond ? 1.0f : 0.0f, 0.0f);
            const auto [wedge, isNew] = wedges.emplace(std::tuple(corners[corner], limb, beyond), 0);
            if (isNew) {
                wedge->second =
                    skin.shape.add({p[corners[corner]], surface.normals[corners[corner]], chartUv(limb, place)});
                skin.shares.push_back(boneShares(p[corners[corner]]));
            }
            skin.shape.indices.push_back(wedge->second);
        }
    }
    return skin;
}

SkinnedShape makeSkin()
{
    const Ogre::AxisAlignedBox box(Vector3(-14 * kCell, -0.1f, -2.4f), Vector3(14 * kCell, 1.75f, 1.7f));
    return unwrap(followSurface(drakeField, box, kCell));
}

/// Adds a part that moves as the skin does at `anchor`.
void addRigid(SkinnedShape& skinned, Shape part, const Vector3& anchor)
{
    weld(part);
    skinned.shares.insert(skinned.shares.end(), part.vertices.size(), boneShares(anchor));
    skinned.shape.append(part);
}

/// A horn, a claw or a spine: a cone that bends towards `bend` as it goes.
Shape makeSpike(const Vector3& foot, const Vector3& direction, const Vector3& bend, float length, float radius,
                std::uint32_t sides, int rings)
{
    std::vector<TubeRing> tube;
    for (int i = 0; i < rings; ++i) {
        const float t = float(i) / float(rings - 1);
        tube.push_back({foot + direction * (length * t) + bend * (length * t * t), radius * (1.0f - t)});
    }
    Shape spike;
    addTube(spike, tube, sides, 1.0f);
    return spike;
}

void addHorns(SkinnedShape& horn)
{
    for (const float side : {-1.0f, 1.0f}) {
        const Vector3 foot(side * 0.07f, 1.47f, 0.985f);
        const Vector3 direction = Vector3(side * 0.35f, 0.55f, -0.75f).normalisedCopy();
        addRigid(horn, makeSpike(foot, direction, Vector3(0, 0.3f, -0.1f), 0.34f, 0.04f, 9, 7), foot);
    }
}

void addClaws(SkinnedShape& horn)
{
    for (const DrakeBone& bone : drakeBones()) {
        if (bone.name.find("_foot") == std::string::npos)
            continue;
        const Vector3 along = Vector3(bone.to.x - bone.from.x, 0, bone.to.z - bone.from.z).normalisedCopy();
        for (int toe = -1; toe <= 1; ++toe) {
            const Vector3 direction = Ogre::Quaternion(Ogre::Degree(32.0f * float(toe)), Vector3::UNIT_Y) * along;
            const Vector3 foot = bone.to + direction * 0.035f;
            addRigid(horn, makeSpike(foot, direction, Vector3(0, -0.35f, 0), 0.11f, 0.024f, 6, 4), bone.to);
        }
    }
}

/// A row of spines along the back, from the nape to the tail's end.
void addSpines(SkinnedShape& horn)
{
    for (const char* name : {"neck2", "neck1", "chest", "spine", "pelvis", "tail1", "tail2", "tail3", "tail4"}) {
        const DrakeBone& bone = drakeBones()[std::size_t(drakeBone(name))];
        const Vector3 along = (bone.to - bone.from).normalisedCopy();
        const Vector3 up = along.crossProduct(Vector3::UNIT_X) * (along.z > 0 ? 1.0f : -1.0f);
        for (const float t : {0.25f, 0.75f}) {
            const float radius = bone.fromRadius + (bone.toRadius - bone.fromRadius) * t;
            const Vector3 foot = bone.from + (bone.to - bone.from) * t + up * (radius * 0.93f);
            const float length = 0.06f + 0.35f * radius;
            addRigid(horn, makeSpike(foot, up, Vector3(0, 0, -0.5f), length, 0.012f + 0.11f * radius, 6, 4), foot);
        }
    }
}

SkinnedShape makeHorn()
{
    SkinnedShape horn;
    horn.shape.material = "lodsmith/drake/horn";
    addHorns(horn);
    addClaws(horn);
    addSpines(horn);
    return horn;
}

SkinnedShape makeEyes()
{
    SkinnedShape eyes;
    eyes.shape.material = "lodsmith/drake/eye";
    constexpr float kRadius = 0.036f;
    std::vector<ProfilePoint> circle;
    for (int i = 0; i <= 7; ++i) {
        const float angle = Ogre::Math::PI * float(i) / 7.0f;
        circle.push_back({kRadius * std::sin(angle), -kRadius * std::cos(angle), false});
    }
    for (const float side : {-1.0f, 1.0f}) {
        const Vector3 centre(side * 0.098f, 1.428f, 1.125f);
        const Placement placement{centre, Vector3::UNIT_Y.getRotationTo(Vector3(side, 0.1f, 0.25f).normalisedCopy())};
        Shape ball;
        addLathe(ball, placement, circle, 12, 1.0f / (Ogre::Math::PI * kRadius));
        addRigid(eyes, ball, Vector3(0, 1.40f, 1.1f));
    }
    return eyes;
}

void addAssignments(Ogre::Mesh& mesh, const std::vector<SkinnedShape>& parts)
{
    unsigned int vertex = 0;
    for (const SkinnedShape& part : parts)
        for (const auto& shares : part.shares) {
            for (const BoneShare& share : shares) {
                Ogre::VertexBoneAssignment assignment;
                assignment.vertexIndex = vertex;
                assignment.boneIndex = static_cast<unsigned short>(share.bone);
                assignment.weight = share.weight;
                mesh.addBoneAssignment(assignment);
            }
            ++vertex;
        }
}

/// Scales: how far a point lies from the rim of its cell in a honeycomb, 0..1.
float scalePattern(float x, float y)
{
    y *= 1.1547f;
    const float row = std::floor(y);
    x += int(row) % 2 ? 0.5f : 0.0f;
    const float dx = x - std::floor(x) - 0.5f, dy = y - row - 0.5f;
    return std::max(0.0f, 1.0f - 2.0f * std::sqrt(dx * dx + dy * dy));
}

Ogre::ColourValue skinColour(float u, float v)
{
    const bool legs = v >= 0.68f;
    const float width = legs ? 0.25f : 1.0f;
    const float turn = std::fmod(u, width) / width * kMostTurns;
    const float belly = legs ? 0.0f : std::pow(0.5f + 0.5f * std::cos(Ogre::Math::TWO_PI * turn), 3.0f);
    const float stripes = 0.5f + 0.5f * std::sin(60.0f * v + 3.0f * fractalNoise(u, v, 4, 3, 21));
    const float back = (1.0f - belly) * (0.35f + 0.65f * stripes);
    const Ogre::ColourValue green(0.30f, 0.40f, 0.20f), dark(0.17f, 0.25f, 0.15f), pale(0.74f, 0.66f, 0.42f);
    Ogre::ColourValue colour = green * (1.0f - back) + dark * back;
    colour = colour * (1.0f - belly) + pale * belly;
    return colour * (0.78f + 0.4f * scalePattern(u * 72.0f, v * 72.0f) + 0.25f * fractalNoise(u, v, 8, 4, 31));
}

/// Pupil at the eye's front, which is where the texture's v is 1.
Ogre::ColourValue eyeColour(float, float v)
{
    if (v > 0.86f)
        return Ogre::ColourValue(0.03f, 0.03f, 0.03f);
    return v > 0.66f ? Ogre::ColourValue(0.95f, 0.66f, 0.10f) : Ogre::ColourValue(0.55f, 0.30f, 0.10f);
}

const char* kMaterials = R"(material lodsmith/drake/skin
{
    technique
    {
        pass
        {
            specular 0.15 0.15 0.15 1 16
            texture_unit
            {
                texture drake_skin.png
            }
        }
    }
}

material lodsmith/drake/horn
{
    technique
    {
        pass
        {
            ambient 0.82 0.76 0.62
            diffuse 0.82 0.76 0.62
            specular 0.3 0.3 0.3 1 24
        }
    }
}

material lodsmith/drake/eye
{
    technique
    {
        pass
        {
            specular 0.9 0.9 0.9 1 80
            texture_unit
            {
                texture drake_eye.png
                tex_address_mode clamp
            }
        }
    }
}
)";

} // namespace

void makeDrake(const std::filesystem::path& directory)
{
    const std::vector<SkinnedShape> parts{makeSkin(), makeHorn(), makeEyes()};
    std::vector<Shape> shapes;
    for (const SkinnedShape& part : parts)
        shapes.push_back(part.shape);
    Ogre::MeshPtr mesh = makeMesh("drake.mesh", shapes, true);
    Ogre::SkeletonPtr skeleton = makeDrakeSkeleton();
    mesh->_notifySkeleton(skeleton);
    // Skinning on the processor writes positions and normals anew: nothing else may be in their buffer.
    Ogre::VertexData& vertices = *mesh->sharedVertexData;
    vertices.reorganiseBuffers(vertices.vertexDeclaration->getAutoOrganisedDeclaration(true, false, false));
    addAssignments(*mesh, parts);
    exportMesh(*mesh, directory);
    Ogre::SkeletonSerializer().exportSkeleton(skeleton.get(), (directory / "drake.skeleton").string());
    writePicture(directory / "drake_skin.png", 256, skinColour);
    writePicture(directory / "drake_eye.png", 32, eyeColour);
    writeText(directory / "drake.material", kMaterials);
}

} // namespace lodsmith::media
