#include "MeshExport.h"
#include "Models.h"
#include "Random.h"
#include "Tube.h"

#include <OgreMath.h>

#include <algorithm>
#include <cmath>

namespace lodsmith::media {

namespace {

using Ogre::Quaternion;
using Ogre::Radian;
using Ogre::Vector2;
using Ogre::Vector3;

constexpr float kGoldenAngle = 2.3999632f;
const Vector3 kCrownCentre(0.1f, 4.9f, 0.0f);

/// A twig's end, where leaves grow.
struct Tip {
    Vector3 position;
    Vector3 direction;
};

struct Crown {
    Shape wood;
    std::vector<Tip> tips;
};

std::vector<TubeRing> trunkRings()
{
    std::vector<TubeRing> rings;
    constexpr int kRings = 13;
    for (int i = 0; i < kRings; ++i) {
        const float t = float(i) / float(kRings - 1);
        const float flare = 0.26f * std::exp(-9.0f * t);
        const Vector3 bend(0.22f * std::sin(2.6f * t), 0.0f, 0.16f * std::sin(4.1f * t));
        rings.push_back({Vector3(0, 5.6f * t, 0) + bend, (0.27f + flare) * (1.0f - t) + 0.035f * t});
    }
    return rings;
}

/// A branch that sets out along `direction` and turns upwards as it goes.
std::vector<TubeRing> branchRings(const Vector3& start, Vector3 direction, float length, float radius, int count,
                                  Random& random)
{
    std::vector<TubeRing> rings{{start, radius}};
    for (int i = 1; i < count; ++i) {
        const float t = float(i) / float(count - 1);
        const Vector3 wander(random.range(-0.16f, 0.16f), random.range(-0.08f, 0.16f), random.range(-0.16f, 0.16f));
        direction = (direction + wander + Vector3(0, 0.09f, 0)).normalisedCopy();
        rings.push_back({rings.back().centre + direction * (length / float(count - 1)), radius * (1.0f - 0.9f * t)});
    }
    return rings;
}

Vector3 between(const std::vector<TubeRing>& rings, float t)
{
    const float place = t * float(rings.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), rings.size() - 2);
    return rings[i].centre + (rings[i + 1].centre - rings[i].centre) * (place - float(i));
}

void addTip(Crown& crown, const std::vector<TubeRing>& rings)
{
    const Vector3& end = rings.back().centre;
    crown.tips.push_back({end, (end - rings[rings.size() - 2].centre).normalisedCopy()});
}

void growTwigs(Crown& crown, const std::vector<TubeRing>& branch, float length, Random& random)
{
    for (int i = 0; i < 5; ++i) {
        const float t = 0.4f + 0.12f * float(i);
        const Vector3 along = (branch.back().centre - branch.front().centre).normalisedCopy();
        const Quaternion round(Radian(kGoldenAngle * float(i) + random.range(0.0f, 0.7f)), along);
        const Vector3 aside = round * along.perpendicular();
        const auto twig = branchRings(between(branch, t), (along + aside * 1.1f).normalisedCopy(),
                                      length * random.range(0.34f, 0.5f), 0.028f, 4, random);
        addTube(crown.wood, twig, 4, 1.0f);
        addTip(crown, twig);
    }
}

Crown growCrown(Random& random)
{
    Crown crown;
    crown.wood.material = "lodsmith/tree/bark";
    const std::vector<TubeRing> trunk = trunkRings();
    addTube(crown.wood, trunk, 11, 3.0f);
    addTip(crown, trunk);
    constexpr int kBranches = 13;
    for (int i = 0; i < kBranches; ++i) {
        const float t = float(i) / float(kBranches - 1);
        const float angle = kGoldenAngle * float(i) + random.range(-0.25f, 0.25f);
        const float rise = 0.25f + 0.75f * t;
        const Vector3 direction = Vector3(std::cos(angle), rise, std::sin(angle)).normalisedCopy();
        const float length = (2.35f - 1.15f * t) * random.range(0.9f, 1.1f);
        const auto branch =
            branchRings(between(trunk, 0.36f + 0.56f * t), direction, length, 0.105f - 0.055f * t, 7, random);
        addTube(crown.wood, branch, 7, 2.0f);
        addTip(crown, branch);
        growTwigs(crown, branch, length, random);
    }
    return crown;
}

/// One card: a quad folded along its middle, its normals those of the crown as a whole so that light falls softly.
void addCard(Shape& leaves, const Tip& tip, const Vector3& aside, float size, int sheet)
{
    const Vector3 along = tip.direction;
    const Vector3 fold = aside.crossProduct(along) * (0.22f * size);
    const float u = 0.5f * float(sheet % 2), v = 0.5f * float(sheet / 2);
    std::uint32_t corner[6];
    for (int i = 0; i < 6; ++i) {
        const float x = float(i % 3) - 1.0f, y = float(i / 3);
        const Vector3 position =
            tip.position + aside * (0.5f * size * x) + along * (size * (y - 0.12f)) - fold * std::abs(x);
        const Vector3 normal = ((position - kCrownCentre).normalisedCopy() + Vector3(0, 0.35f, 0)).normalisedCopy();
        corner[i] = leaves.add({position, normal, Vector2(u + 0.25f * (x + 1.0f), v + 0.5f * (1.0f - y))});
    }
    leaves.addQuad(corner[0], corner[1], corner[4], corner[3]);
    leaves.addQuad(corner[1], corner[2], corner[5], corner[4]);
}

Shape growLeaves(const std::vector<Tip>& tips, Random& random)
{
    Shape leaves;
    leaves.material = "lodsmith/tree/leaves";
    int sheet = 0;
    for (const Tip& tip : tips)
        for (int card = 0; card < 5; ++card) {
            Tip turned = tip;
            const Vector3 spread(random.range(-0.9f, 0.9f), random.range(-0.7f, 0.6f), random.range(-0.9f, 0.9f));
            turned.direction = (tip.direction + spread).normalisedCopy();
            turned.position -= tip.direction * (0.11f * float(card));
            const Vector3 aside =
                Quaternion(Radian(random.range(0.0f, 6.28f)), turned.direction) * turned.direction.perpendicular();
            addCard(leaves, turned, aside, random.range(0.62f, 0.9f), sheet++ % 4);
        }
    return leaves;
}

/// How deep a point lies inside a leaf that starts at the origin and points along +Y with length 1; negative outside.
float insideLeaf(float x, float y)
{
    if (y < 0.0f || y > 1.0f)
        return -1.0f;
    const float width = 0.32f * std::pow(y, 0.6f) * std::sqrt(1.0f - y) * 1.5f;
    return width - std::abs(x);
}

/// One of four twigs of a leaf sheet, x and y 0..1, y up; transparent green where there is neither leaf nor stalk.
Ogre::ColourValue twigColour(float x, float y, std::uint32_t sheet)
{
    Ogre::ColourValue colour(0.20f, 0.34f, 0.10f, 0.0f);
    if (std::abs(x - 0.5f) < 0.012f && y < 0.75f)
        colour = Ogre::ColourValue(0.30f, 0.22f, 0.12f, 1.0f);
    Random random(40 + sheet);
    for (int leaf = 0; leaf < 17; ++leaf) {
        const float height = leaf == 16 ? 0.70f : 0.06f + 0.041f * float(leaf);
        const float side = leaf == 16 ? 0.0f : (leaf % 2 ? 1.0f : -1.0f);
        const float angle = side * random.range(0.75f, 1.25f);
        const float length = random.range(0.22f, 0.29f) * (1.15f - 0.25f * height);
        const float shade = random.range(0.75f, 1.15f);
        const float dx = (x - 0.5f) / length, dy = (y - height) / length;
        const float along = dx * std::sin(angle) + dy * std::cos(angle);
        const float across = dx * std::cos(angle) - dy * std::sin(angle);
        if (const float depth = insideLeaf(across, along); depth > 0.0f) {
            const float vein = std::abs(across) < 0.025f ? 0.82f : 1.0f;
            colour = Ogre::ColourValue(0.24f + 0.12f * along, 0.42f + 0.1f * along, 0.11f) * (shade * vein);
            colour.a = 1.0f;
        }
    }
    return colour;
}

Ogre::ColourValue leafColour(float u, float v)
{
    const std::uint32_t sheet = (u >= 0.5f ? 1u : 0u) + (v >= 0.5f ? 2u : 0u);
    return twigColour(std::fmod(2.0f * u, 1.0f), 1.0f - std::fmod(2.0f * v, 1.0f), sheet);
}

Ogre::ColourValue barkColour(float u, float v)
{
    const float ridge = fractalNoise(u * 1.0f, v * 0.25f, 12, 3, 7);
    const float grain = fractalNoise(u, v, 24, 3, 19);
    const float light = 0.36f + 0.28f * std::abs(ridge) + 0.14f * grain;
    return Ogre::ColourValue(light * 1.05f, light * 0.86f, light * 0.68f);
}

const char* kMaterials = R"(material lodsmith/tree/bark
{
    technique
    {
        pass
        {
            texture_unit
            {
                texture tree_bark.png
            }
        }
    }
}

material lodsmith/tree/leaves
{
    technique
    {
        pass
        {
            alpha_rejection greater_equal 128
            cull_hardware none
            cull_software none
            texture_unit
            {
                texture tree_leaves.png
                tex_address_mode clamp
            }
        }
    }
}
)";

} // namespace

void makeTree(const std::filesystem::path& directory)
{
    Random random(2012);
    Crown crown = growCrown(random);
    Shape leaves = growLeaves(crown.tips, random);
    exportMesh(*makeMesh("tree.mesh", {crown.wood, leaves}, false), directory);
    writePicture(directory / "tree_bark.png", 128, barkColour);
    writePicture(directory / "tree_leaves.png", 256, leafColour);
    writeText(directory / "tree.material", kMaterials);
}

} // namespace lodsmith::media
