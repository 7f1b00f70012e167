#include "MeshExport.h"
#include "Models.h"
#include "Random.h"

#include <OgreMath.h>

#include <algorithm>
#include <cmath>

namespace lodsmith::media {

namespace {

using Ogre::Vector2;
using Ogre::Vector3;

constexpr float kLength = 7.0f, kDepth = 5.0f; ///< of the outer walls, along X and Z
constexpr float kWallHeight = 2.6f, kRise = 2.7f, kThickness = 0.28f;
constexpr float kEaves = 0.45f, kVerge = 0.40f; ///< how far the roof stands out, below and at the sides
constexpr float kUvScale = 0.5f;

struct Cottage {
    Shape plaster{"lodsmith/cottage/plaster", {}, {}};
    Shape timber{"lodsmith/cottage/timber", {}, {}};
    Shape tiles{"lodsmith/cottage/tiles", {}, {}};
    Shape bricks{"lodsmith/cottage/bricks", {}, {}};
    Shape panes{"lodsmith/cottage/panes", {}, {}};
};

/// A hole in a wall: metres from the wall's left end and from the ground.
struct Opening {
    float left = 0.0f, bottom = 0.0f, right = 0.0f, top = 0.0f;
};

/// One outer wall as seen from outside, from its left end at the ground.
struct Wall {
    Vector3 origin;
    Vector3 along; ///< unit length, to the right
    float width = 0.0f;
    std::vector<Opening> openings;
    bool gable = false;

    Vector3 outward() const { return along.crossProduct(Vector3::UNIT_Y); }
    /// @param depth  0 at the outer face, kThickness at the inner one
    Vector3 point(float x, float y, float depth) const
    {
        return origin + along * x + Vector3(0, y, 0) - outward() * depth;
    }
};

std::vector<float> sortedCuts(std::vector<float> cuts)
{
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
}

std::vector<float> cutsAlong(const Wall& wall)
{
    std::vector<float> cuts{0.0f, kThickness, wall.width - kThickness, wall.width};
    for (const Opening& opening : wall.openings)
        cuts.insert(cuts.end(), {opening.left, opening.right});
    return sortedCuts(cuts);
}

std::vector<float> cutsUp(const Wall& wall)
{
    std::vector<float> cuts{0.0f, kWallHeight};
    for (const Opening& opening : wall.openings)
        cuts.insert(cuts.end(), {opening.bottom, opening.top});
    return sortedCuts(cuts);
}

bool isOpen(const Wall& wall, float x, float y)
{
    return std::any_of(wall.openings.begin(), wall.openings.end(), [=](const Opening& opening) {
        return x > opening.left && x < opening.right && y > opening.bottom && y < opening.top;
    });
}

bool hasInside(const Wall& wall, float x)
{
    return x > kThickness && x < wall.width - kThickness;
}

/// Both faces, cut into a grid along the openings so that no vertex lies on another's edge.
void addWallFaces(Shape& plaster, const Wall& wall)
{
    const std::vector<float> xs = cutsAlong(wall), ys = cutsUp(wall);
    for (std::size_t i = 1; i < xs.size(); ++i)
        for (std::size_t j = 1; j < ys.size(); ++j) {
            const float x0 = xs[i - 1], x1 = xs[i], y0 = ys[j - 1], y1 = ys[j], x = 0.5f * (x0 + x1);
            if (isOpen(wall, x, 0.5f * (y0 + y1)))
                continue;
            addFlatQuad(plaster, wall.point(x0, y0, 0), wall.point(x1, y0, 0), wall.point(x1, y1, 0),
                        wall.point(x0, y1, 0), kUvScale);
            if (hasInside(wall, x))
                addFlatQuad(plaster, wall.point(x1, y0, kThickness), wall.point(x0, y0, kThickness),
                            wall.point(x0, y1, kThickness), wall.point(x1, y1, kThickness), kUvScale);
        }
}

void addGable(Shape& plaster, const Wall& wall)
{
    const std::vector<float> xs = cutsAlong(wall);
    const float middle = 0.5f * wall.width;
    const float innerRise = kRise * (middle - kThickness) / middle;
    for (std::size_t i = 1; i < xs.size(); ++i) {
        const float x0 = xs[i - 1], x1 = xs[i];
        addFlatTriangle(plaster, wall.point(x0, kWallHeight, 0), wall.point(x1, kWallHeight, 0),
                        wall.point(middle, kWallHeight + kRise, 0), kUvScale);
        if (hasInside(wall, 0.5f * (x0 + x1)))
            addFlatTriangle(plaster, wall.point(x1, kWallHeight, kThickness), wall.point(x0, kWallHeight, kThickness),
                            wall.point(middle, kWallHeight + innerRise, kThickness), kUvScale);
    }
}

/// The thickness of the wall, seen in its openings. A door has no sill: there is no floor either.
void addReveals(Shape& plaster, const Wall& wall)
{
    for (const Opening& o : wall.openings) {
        const auto side = [&](float x0, float y0, float x1, float y1) {
            addFlatQuad(plaster, wall.point(x0, y0, 0), wall.point(x1, y1, 0), wall.point(x1, y1, kThickness),
                        wall.point(x0, y0, kThickness), kUvScale);
        };
        side(o.left, o.top, o.left, o.bottom);
        side(o.right, o.bottom, o.right, o.top);
        side(o.right, o.top, o.left, o.top);
        if (o.bottom > 0.0f)
            side(o.left, o.bottom, o.right, o.bottom);
    }
}

void addTwoSided(Shape& shape, const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
    addFlatQuad(shape, a, b, c, d, kUvScale);
    addFlatQuad(shape, d, c, b, a, kUvScale);
}

void addWindow(Cottage& cottage, const Wall& wall, const Opening& o)
{
    const Vector3 out = wall.outward();
    const float depth = 0.10f, middle = 0.5f * (o.left + o.right);
    const Vector2 section(0.07f, 0.07f);
    const auto bar = [&](float x0, float y0, float x1, float y1) {
        addBeam(cottage.timber, wall.point(x0, y0, depth), wall.point(x1, y1, depth), out, section, 0.012f, kUvScale);
    };
    bar(o.left, o.bottom + 0.035f, o.right, o.bottom + 0.035f);
    bar(o.left, o.top - 0.035f, o.right, o.top - 0.035f);
    bar(o.left + 0.035f, o.bottom, o.left + 0.035f, o.top);
    bar(o.right - 0.035f, o.bottom, o.right - 0.035f, o.top);
    bar(middle, o.bottom, middle, o.top);
    bar(o.left, 0.4f * o.bottom + 0.6f * o.top, o.right, 0.4f * o.bottom + 0.6f * o.top);
    addBeam(cottage.timber, wall.point(o.left - 0.1f, o.bottom - 0.04f, -0.05f),
            wall.point(o.right + 0.1f, o.bottom - 0.04f, -0.05f), Vector3::UNIT_Y, Vector2(0.18f, 0.07f), 0.015f,
            kUvScale);
    addTwoSided(cottage.panes, wall.point(o.left, o.bottom, depth), wall.point(o.right, o.bottom, depth),
                wall.point(o.right, o.top, depth), wall.point(o.left, o.top, depth));
    const float leaf = 0.5f * (o.right - o.left);
    for (const float hinge : {o.left - 0.02f, o.right + 0.02f}) {
        const float edge = hinge < middle ? hinge - 0.9f * leaf : hinge + 0.9f * leaf;
        const float left = std::min(hinge, edge), right = std::max(hinge, edge);
        const float leftDepth = left == hinge ? -0.03f : -0.22f, rightDepth = right == hinge ? -0.03f : -0.22f;
        addTwoSided(cottage.timber, wall.point(left, o.bottom, leftDepth), wall.point(right, o.bottom, rightDepth),
                    wall.point(right, o.top, rightDepth), wall.point(left, o.top, leftDepth));
    }
}

void addDoor(Cottage& cottage, const Wall& wall, const Opening& o)
{
    const Vector3 out = wall.outward();
    const int planks = 5;
    for (int i = 0; i < planks; ++i) {
        const float x = o.left + (o.right - o.left) * (float(i) + 0.5f) / planks;
        addBeam(cottage.timber, wall.point(x, 0.02f, 0.14f), wall.point(x, o.top, 0.14f), out,
                Vector2((o.right - o.left) / planks - 0.008f, 0.06f), 0.014f, kUvScale);
    }
    for (const float height : {0.35f, 1.65f})
        addBeam(cottage.timber, wall.point(o.left + 0.06f, height, 0.10f), wall.point(o.right - 0.06f, height, 0.10f),
                out, Vector2(0.12f, 0.04f), 0.01f, kUvScale);
    for (const float x : {o.left - 0.06f, o.right + 0.06f})
        addBeam(cottage.timber, wall.point(x, 0, -0.02f), wall.point(x, o.top + 0.08f, -0.02f), out,
                Vector2(0.14f, 0.12f), 0.02f, kUvScale);
    addBeam(cottage.timber, wall.point(o.left - 0.2f, o.top + 0.08f, -0.02f),
            wall.point(o.right + 0.2f, o.top + 0.08f, -0.02f), out, Vector2(0.16f, 0.14f), 0.02f, kUvScale);
}

/// The frame of beams on a wall's outer face.
void addFrame(Shape& timber, const Wall& wall)
{
    const Vector3 out = wall.outward();
    const auto beam = [&](float x0, float y0, float x1, float y1, float width) {
        addBeam(timber, wall.point(x0, y0, -0.01f), wall.point(x1, y1, -0.01f), out, Vector2(width, 0.10f), 0.02f,
                kUvScale);
    };
    const float w = wall.width, h = kWallHeight;
    beam(0.0f, h - 0.1f, w, h - 0.1f, 0.2f);
    for (const float x : {0.1f, w - 0.1f})
        beam(x, 0.0f, x, h - 0.2f, 0.2f);
    beam(0.2f, 1.35f, 0.95f, h - 0.2f, 0.14f);
    beam(w - 0.2f, 1.35f, w - 0.95f, h - 0.2f, 0.14f);
    if (!wall.gable)
        return;
    beam(0.5f * w, h, 0.5f * w, h + kRise - 0.15f, 0.18f);
    beam(0.24f * w, h + 0.44f * kRise, 0.76f * w, h + 0.44f * kRise, 0.16f);
    for (const float side : {-1.0f, 1.0f})
        beam(w * (0.5f + 0.24f * side), h, w * (0.5f + 0.07f * side), h + 0.43f * kRise, 0.13f);
}

void addWall(Cottage& cottage, const Wall& wall)
{
    addWallFaces(cottage.plaster, wall);
    addReveals(cottage.plaster, wall);
    if (wall.gable)
        addGable(cottage.plaster, wall);
    addFrame(cottage.timber, wall);
    for (const Opening& opening : wall.openings)
        if (opening.bottom > 0.0f)
            addWindow(cottage, wall, opening);
        else
            addDoor(cottage, wall, opening);
}

/// One side of the roof: rows of tiles whose lower edges stand up, and the boards below them.
void addSlope(Cottage& cottage, float side, Random& random)
{
    constexpr int kRows = 11, kColumns = 13;
    const float half = 0.5f * kDepth, slope = kRise / half;
    const Vector3 up = Vector3(0, half, side * kRise).normalisedCopy();
    const auto place = [&](float x, float t, float lift) {
        const float z = (half + kEaves) * (1.0f - t);
        return Vector3(-side * x, kWallHeight + 0.12f + (half - z) * slope, side * z) + up * lift;
    };
    const auto column = [&](int i) { return (kLength + 2.0f * kVerge) * (float(i) / kColumns - 0.5f); };
    for (int row = 0; row < kRows; ++row) {
        const float low = float(row) / kRows, high = float(row + 1) / kRows;
        std::vector<float> lifts;
        for (int i = 0; i <= kColumns; ++i)
            lifts.push_back(random.range(0.045f, 0.085f));
        for (int i = 0; i < kColumns; ++i) {
            const float left = column(i), right = column(i + 1);
            const float a = lifts[std::size_t(i)], b = lifts[std::size_t(i) + 1];
            addFlatQuad(cottage.tiles, place(right, low, b), place(left, low, a), place(left, high, 0.01f),
                        place(right, high, 0.01f), kUvScale);
            addFlatQuad(cottage.tiles, place(right, low, 0.0f), place(left, low, 0.0f), place(left, low, a),
                        place(right, low, b), kUvScale);
        }
    }
    for (int i = 0; i < kColumns; ++i)
        addFlatQuad(cottage.timber, place(column(i), 0, 0), place(column(i + 1), 0, 0), place(column(i + 1), 1, 0),
                    place(column(i), 1, 0), kUvScale);
    for (const float end : {-1.0f, 1.0f}) {
        const float x = end * (0.5f * kLength + kVerge - 0.03f);
        addBeam(cottage.timber, place(x, -0.01f, -0.06f), place(x, 1.0f, -0.06f), up, Vector2(0.08f, 0.20f), 0.015f,
                kUvScale);
    }
}

void addChimney(Cottage& cottage)
{
    const Vector3 foot(1.9f, 0, -0.75f);
    addBox(cottage.bricks, {foot + Vector3(0, 5.0f, 0), Ogre::Quaternion::IDENTITY}, Vector3(0.75f, 2.2f, 0.75f), 0.02f,
           1.0f);
    addBox(cottage.bricks, {foot + Vector3(0, 6.05f, 0), Ogre::Quaternion::IDENTITY}, Vector3(0.92f, 0.16f, 0.92f),
           0.03f, 1.0f);
    for (const float x : {-0.18f, 0.18f})
        addBox(cottage.bricks, {foot + Vector3(x, 6.28f, 0), Ogre::Quaternion::IDENTITY}, Vector3(0.24f, 0.34f, 0.24f),
               0.04f, 1.0f);
}

/// A canopy over the door: one sheet with two sides, no thickness.
void addCanopy(Cottage& cottage, const Wall& front, const Opening& door)
{
    const float left = door.left - 0.5f, right = door.right + 0.5f, high = 2.52f, low = 2.18f, reach = -1.15f;
    constexpr int kSheets = 6;
    for (int i = 0; i < kSheets; ++i) {
        const float a = left + (right - left) * float(i) / kSheets, b = left + (right - left) * float(i + 1) / kSheets;
        addTwoSided(cottage.tiles, front.point(a, low, reach), front.point(b, low, reach), front.point(b, high, -0.06f),
                    front.point(a, high, -0.06f));
    }
    for (const float x : {left + 0.08f, right - 0.08f}) {
        addBeam(cottage.timber, front.point(x, 0, -1.0f), front.point(x, low, -1.0f), front.outward(),
                Vector2(0.12f, 0.12f), 0.02f, kUvScale);
        addBeam(cottage.timber, front.point(x, low + 0.0f, -1.1f), front.point(x, high - 0.04f, -0.05f),
                Vector3::UNIT_Y, Vector2(0.09f, 0.09f), 0.015f, kUvScale);
    }
    addBeam(cottage.timber, front.point(left, low - 0.04f, -1.0f), front.point(right, low - 0.04f, -1.0f),
            Vector3::UNIT_Y, Vector2(0.1f, 0.1f), 0.015f, kUvScale);
}

Cottage buildCottage()
{
    const float x = 0.5f * kLength, z = 0.5f * kDepth;
    const Opening door{3.0f, 0.0f, 4.0f, 2.1f};
    const Wall front{Vector3(-x, 0, z),
                     Vector3::UNIT_X,
                     kLength,
                     {{1.05f, 0.9f, 1.95f, 2.1f}, door, {5.05f, 0.9f, 5.95f, 2.1f}},
                     false};
    const Wall right{Vector3(x, 0, z), Vector3::NEGATIVE_UNIT_Z, kDepth, {{2.0f, 0.9f, 3.0f, 2.1f}}, true};
    const Wall back{Vector3(x, 0, -z),
                    Vector3::NEGATIVE_UNIT_X,
                    kLength,
                    {{1.4f, 0.9f, 2.3f, 2.1f}, {4.7f, 0.9f, 5.6f, 2.1f}},
                    false};
    const Wall left{Vector3(-x, 0, -z), Vector3::UNIT_Z, kDepth, {{2.0f, 0.9f, 3.0f, 2.1f}}, true};
    Cottage cottage;
    for (const Wall* wall : {&front, &right, &back, &left})
        addWall(cottage, *wall);
    Random random(1573);
    addSlope(cottage, 1.0f, random);
    addSlope(cottage, -1.0f, random);
    const float ridge = kWallHeight + kRise + 0.16f;
    addBeam(cottage.tiles, Vector3(-x - kVerge, ridge, 0), Vector3(x + kVerge, ridge, 0), Vector3::UNIT_Y,
            Vector2(0.3f, 0.16f), 0.06f, kUvScale);
    addChimney(cottage);
    addCanopy(cottage, front, door);
    return cottage;
}

Ogre::ColourValue plasterColour(float u, float v)
{
    return Ogre::ColourValue(0.86f, 0.82f, 0.72f) * (1.0f + 0.16f * fractalNoise(u, v, 4, 6, 1));
}

Ogre::ColourValue timberColour(float u, float v)
{
    const float grain = fractalNoise(u, v * 0.125f, 32, 3, 2) + 0.5f * fractalNoise(u, v, 4, 4, 5);
    return Ogre::ColourValue(0.36f, 0.25f, 0.16f) * (1.0f + 0.5f * grain);
}

/// Rows of rounded tiles, every second row half a tile aside.
Ogre::ColourValue tileColour(float u, float v)
{
    const float row = std::floor(v * 4.0f), x = u * 6.0f + (int(row) % 2 ? 0.5f : 0.0f);
    const float gap = std::abs(x - std::floor(x) - 0.5f) > 0.45f || v * 4.0f - row > 0.93f ? 0.6f : 1.0f;
    const float shade = 1.0f + 0.15f * tilingNoise(std::floor(x), row, 12, 9) + 0.25f * fractalNoise(u, v, 8, 4, 4);
    return Ogre::ColourValue(0.62f, 0.30f, 0.20f) * (gap * shade);
}

Ogre::ColourValue brickColour(float u, float v)
{
    const float row = std::floor(v * 8.0f), x = u * 4.0f + (int(row) % 2 ? 0.5f : 0.0f);
    const bool mortar = x - std::floor(x) < 0.06f || v * 8.0f - row < 0.12f;
    const float shade =
        1.0f + 0.3f * tilingNoise(std::floor(x) + 0.5f, row + 0.5f, 8, 6) + 0.3f * fractalNoise(u, v, 16, 3, 8);
    return (mortar ? Ogre::ColourValue(0.70f, 0.67f, 0.62f) : Ogre::ColourValue(0.55f, 0.28f, 0.21f)) * shade;
}

std::string texturedMaterial(const std::string& name)
{
    return "material lodsmith/cottage/" + name
           + "\n{\n    technique\n    {\n        pass\n        {\n"
             "            texture_unit\n            {\n                texture cottage_"
           + name
           + ".png\n"
             "            }\n        }\n    }\n}\n\n";
}

const char* kPanes = R"(material lodsmith/cottage/panes
{
    technique
    {
        pass
        {
            ambient 0.35 0.45 0.52
            diffuse 0.35 0.45 0.52
            specular 0.9 0.9 0.9 1 60
        }
    }
}
)";

} // namespace

void makeCottage(const std::filesystem::path& directory)
{
    Cottage cottage = buildCottage();
    for (Shape* shape : {&cottage.plaster, &cottage.timber, &cottage.tiles, &cottage.bricks, &cottage.panes})
        weld(*shape);
    exportMesh(*makeMesh("cottage.mesh",
                         {cottage.plaster, cottage.timber, cottage.tiles, cottage.bricks, cottage.panes}, false),
               directory);
    writePicture(directory / "cottage_plaster.png", 128, plasterColour);
    writePicture(directory / "cottage_timber.png", 128, timberColour);
    writePicture(directory / "cottage_tiles.png", 128, tileColour);
    writePicture(directory / "cottage_bricks.png", 128, brickColour);
    writeText(directory / "cottage.material", texturedMaterial("plaster") + texturedMaterial("timber")
                                                  + texturedMaterial("tiles") + texturedMaterial("bricks") + kPanes);
}

} // namespace lodsmith::media
