#include "MeshExport.h"
#include "Models.h"
#include "Tube.h"

#include <OgreMath.h>

#include <cmath>

namespace lodsmith::media {

namespace {

using Ogre::Quaternion;
using Ogre::Radian;
using Ogre::Vector3;

constexpr float kTurn = 6.2831853f;
constexpr int kPosts = 6;
constexpr float kPostRing = 0.112f; ///< from the axis to the middle of a post
constexpr float kFloor = 0.085f;    ///< where the panes begin
constexpr float kCeiling = 0.335f;  ///< and where they end

Placement around(float angle, float radius, float height)
{
    return {Vector3(radius * std::cos(angle), height, -radius * std::sin(angle)),
            Quaternion(Radian(angle), Vector3::UNIT_Y)};
}

void addBase(Shape& metal)
{
    addLathe(metal, {},
             {{0.0f, 0.0f},
              {0.128f, 0.0f},
              {0.136f, 0.008f},
              {0.136f, 0.026f},
              {0.128f, 0.034f, false},
              {0.117f, 0.044f, false},
              {0.113f, 0.058f},
              {0.126f, 0.062f},
              {0.132f, 0.068f},
              {0.132f, 0.079f},
              {0.126f, kFloor},
              {0.0f, kFloor}},
             24, 4.0f);
    for (int i = 0; i < 3; ++i)
        addLathe(metal, around(kTurn * float(i) / 3.0f, 0.1f, -0.014f),
                 {{0.0f, 0.0f}, {0.014f, 0.0f}, {0.020f, 0.005f, false}, {0.021f, 0.015f}}, 10, 4.0f);
}

void addRoof(Shape& metal)
{
    addLathe(metal, {},
             {{0.0f, kCeiling},        {0.128f, kCeiling},      {0.150f, 0.327f},        {0.157f, 0.333f},
              {0.157f, 0.342f},        {0.146f, 0.349f},        {0.117f, 0.364f, false}, {0.092f, 0.385f, false},
              {0.074f, 0.412f, false}, {0.062f, 0.440f},        {0.066f, 0.444f},        {0.066f, 0.466f},
              {0.058f, 0.474f},        {0.047f, 0.486f, false}, {0.030f, 0.495f, false}, {0.014f, 0.499f},
              {0.014f, 0.513f},        {0.019f, 0.517f, false}, {0.019f, 0.529f, false}, {0.012f, 0.536f, false},
              {0.0f, 0.538f}},
             24, 4.0f);
    for (int i = 0; i < 8; ++i) {
        Placement vent = around(kTurn * (float(i) + 0.5f) / 8.0f, 0.067f, 0.455f);
        addBox(metal, vent, Vector3(0.006f, 0.013f, 0.020f), 0.002f, 4.0f);
    }
}

void addCage(Shape& metal)
{
    for (int i = 0; i < kPosts; ++i) {
        const float angle = kTurn * float(i) / kPosts;
        addBox(metal, around(angle, kPostRing, 0.5f * (kFloor + kCeiling)),
               Vector3(0.016f, kCeiling - kFloor + 0.004f, 0.018f), 0.003f, 4.0f);
        for (const float height : {kFloor + 0.012f, kCeiling - 0.012f}) {
            Placement bolt = around(angle, kPostRing + 0.007f, height);
            bolt.orientation = bolt.orientation * Quaternion(Radian(-kTurn / 4.0f), Vector3::UNIT_Z);
            addLathe(metal, bolt, {{0.006f, 0.0f}, {0.006f, 0.003f}, {0.003f, 0.0055f, false}, {0.0f, 0.006f}}, 6,
                     4.0f);
        }
    }
    const Quaternion lying(Radian(kTurn / 4.0f), Vector3::UNIT_X);
    for (const float height : {0.165f, 0.255f})
        addTorus(metal, {Vector3(0, height, 0), lying}, 0.121f, 0.0038f, 24, 5, 4.0f);
}

/// A wire from one ear over the top to the other.
void addHandle(Shape& metal)
{
    for (const float side : {-1.0f, 1.0f})
        addTorus(metal, {Vector3(side * 0.157f, 0.352f, 0), Quaternion::IDENTITY}, 0.012f, 0.004f, 10, 5, 4.0f);
    addTorus(metal, {Vector3(0, 0.560f, 0), Quaternion::IDENTITY}, 0.024f, 0.004f, 14, 5, 4.0f);
    std::vector<TubeRing> wire;
    constexpr int kRings = 25;
    for (int i = 0; i < kRings; ++i) {
        const float angle = kTurn / 2.0f * float(i) / float(kRings - 1);
        wire.push_back({Vector3(0.157f * std::cos(angle), 0.360f + 0.235f * std::sin(angle), 0), 0.0042f});
    }
    addTube(metal, wire, 7, 1.0f);
    const Quaternion alongX(Radian(-kTurn / 4.0f), Vector3::UNIT_Z);
    addLathe(metal, {Vector3(-0.04f, 0.592f, 0), alongX},
             {{0.0f, 0.0f},
              {0.008f, 0.0f},
              {0.011f, 0.005f, false},
              {0.013f, 0.04f, false},
              {0.011f, 0.075f, false},
              {0.008f, 0.08f},
              {0.0f, 0.08f}},
             12, 4.0f);
}

Shape makePanes()
{
    Shape glass;
    glass.material = "lodsmith/lantern/glass";
    for (int i = 0; i < kPosts; ++i) {
        const Placement left = around(kTurn * (float(i) + 0.06f) / kPosts, kPostRing - 0.004f, 0.0f);
        const Placement right = around(kTurn * (float(i) + 0.94f) / kPosts, kPostRing - 0.004f, 0.0f);
        const Vector3 low(0, kFloor, 0), high(0, kCeiling, 0);
        addFlatQuad(glass, left.position + low, right.position + low, right.position + high, left.position + high,
                    4.0f);
        addFlatQuad(glass, right.position + low, left.position + low, left.position + high, right.position + high,
                    4.0f);
    }
    return glass;
}

Shape makeBurner()
{
    Shape burner;
    burner.material = "lodsmith/lantern/brass";
    addLathe(burner, {},
             {{0.052f, kFloor},
              {0.052f, 0.108f},
              {0.046f, 0.120f, false},
              {0.030f, 0.130f, false},
              {0.020f, 0.134f},
              {0.020f, 0.146f},
              {0.014f, 0.150f},
              {0.008f, 0.151f},
              {0.008f, 0.160f},
              {0.0f, 0.160f}},
             20, 4.0f);
    return burner;
}

Shape makeFlame()
{
    Shape flame;
    flame.material = "lodsmith/lantern/flame";
    addLathe(flame, {},
             {{0.0f, 0.158f, false},
              {0.010f, 0.165f, false},
              {0.0155f, 0.180f, false},
              {0.013f, 0.200f, false},
              {0.006f, 0.222f, false},
              {0.0f, 0.242f}},
             12, 4.0f);
    return flame;
}

Ogre::ColourValue metalColour(float u, float v)
{
    const float grain = fractalNoise(u, v, 8, 5, 3);
    const float rust = std::max(0.0f, fractalNoise(u, v, 4, 4, 11) * 2.4f - 0.35f);
    const Ogre::ColourValue iron = Ogre::ColourValue(0.30f, 0.31f, 0.33f) * (1.0f + 0.5f * grain);
    const Ogre::ColourValue brown = Ogre::ColourValue(0.42f, 0.24f, 0.13f) * (1.0f + 0.6f * grain);
    const float share = std::min(rust, 1.0f);
    return iron * (1.0f - share) + brown * share;
}

const char* kMaterials = R"(material lodsmith/lantern/metal
{
    technique
    {
        pass
        {
            specular 0.4 0.4 0.42 1 24
            texture_unit
            {
                texture lantern_metal.png
            }
        }
    }
}

material lodsmith/lantern/brass
{
    technique
    {
        pass
        {
            ambient 0.75 0.58 0.26
            diffuse 0.75 0.58 0.26
            specular 0.6 0.5 0.3 1 32
        }
    }
}

material lodsmith/lantern/glass
{
    technique
    {
        pass
        {
            scene_blend alpha_blend
            depth_write off
            diffuse 0.8 0.9 0.95 0.25
            specular 1 1 1 0.25 64
        }
    }
}

material lodsmith/lantern/flame
{
    technique
    {
        pass
        {
            lighting off
            diffuse 1 0.75 0.3
            texture_unit
            {
                colour_op_ex source1 src_manual src_current 1 0.75 0.3
            }
        }
    }
}
)";

} // namespace

void makeLantern(const std::filesystem::path& directory)
{
    Shape metal;
    metal.material = "lodsmith/lantern/metal";
    addBase(metal);
    addRoof(metal);
    addCage(metal);
    addHandle(metal);
    std::vector<Shape> shapes{metal, makeBurner(), makeFlame(), makePanes()};
    for (Shape& shape : shapes)
        weld(shape);
    exportMesh(*makeMesh("lantern.mesh", shapes, false), directory);
    writePicture(directory / "lantern_metal.png", 128, metalColour);
    writeText(directory / "lantern.material", kMaterials);
}

} // namespace lodsmith::media
