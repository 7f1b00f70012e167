#include <lodsmith/render/SurfaceMaterials.h>

#include <OgreHardwarePixelBuffer.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreRenderable.h>
#include <OgreSubMesh.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lodsmith {

namespace {

const Ogre::ColourValue kGrey(0.72f, 0.72f, 0.70f);
const Ogre::ColourValue kFill(0.30f, 0.31f, 0.33f);
const Ogre::ColourValue kLine(0.85f, 0.92f, 1.0f);

void light(Ogre::Pass& pass, const Ogre::ColourValue& colour)
{
    pass.setLightingEnabled(true);
    pass.setAmbient(colour);
    pass.setDiffuse(colour);
    pass.setSpecular(Ogre::ColourValue::Black);
}

/// One colour all over: what is emitted, since without lighting OGRE takes the vertices' colours.
void plain(Ogre::Pass& pass, const Ogre::ColourValue& colour)
{
    pass.setLightingEnabled(true);
    pass.setAmbient(Ogre::ColourValue::Black);
    pass.setDiffuse(Ogre::ColourValue::Black);
    pass.setSpecular(Ogre::ColourValue::Black);
    pass.setSelfIllumination(colour);
    pass.setMaxSimultaneousLights(0);
}

/// Lines over a surface that hides those behind it.
void paintLines(Ogre::Technique& technique)
{
    Ogre::Pass& fill = *technique.getPass(0);
    plain(fill, kFill);
    fill.setDepthBias(-1.0f, -1.0f);
    Ogre::Pass& lines = *technique.createPass();
    plain(lines, kLine);
    lines.setPolygonMode(Ogre::PM_WIREFRAME);
}

bool has(const Ogre::VertexData* vertices, Ogre::VertexElementSemantic semantic)
{
    return vertices && vertices->vertexDeclaration->findElementBySemantic(semantic);
}

bool isSeenFromBothSides(const Ogre::Technique* technique)
{
    return technique && technique->getNumPasses() > 0 && technique->getPass(0)->getCullingMode() == Ogre::CULL_NONE;
}

} // namespace

SurfaceMaterials::SurfaceMaterials(const Ogre::String& group) : mGroup(group)
{
    Ogre::ResourceGroupManager::getSingleton().createResourceGroup(mGroup, false);
    makeCheckerTexture();
    mGrey = bothWays("grey", [](Ogre::Technique& technique) { light(*technique.getPass(0), kGrey); });
    mFaceted = bothWays("faceted", [](Ogre::Technique& technique) {
        light(*technique.getPass(0), kGrey);
        technique.getPass(0)->setShadingMode(Ogre::SO_FLAT);
    });
    mPlain = bothWays("plain", [](Ogre::Technique& technique) { plain(*technique.getPass(0), kGrey); });
    mLines = bothWays("lines", paintLines);
    mChecker = bothWays("checker", [this](Ogre::Technique& technique) {
        light(*technique.getPass(0), Ogre::ColourValue::White);
        technique.getPass(0)->createTextureUnitState()->setTexture(mCheckerTexture);
    });
    mVertexColours = create(mGroup + "/colours");
    Ogre::Pass& pass = *mVertexColours->getTechnique(0)->getPass(0);
    light(pass, Ogre::ColourValue::White);
    pass.setVertexColourTracking(Ogre::TVC_AMBIENT | Ogre::TVC_DIFFUSE);
    pass.setCullingMode(Ogre::CULL_NONE);
    mVertexColours->load();
}

SurfaceMaterials::~SurfaceMaterials()
{
    // Whoever holds the group's resources lets go of them first; OGRE may have been taken down before.
    mGrey = mFaceted = mLines = mChecker = mPlain = {};
    mVertexColours.reset();
    mCheckerTexture.reset();
    if (auto* groups = Ogre::ResourceGroupManager::getSingletonPtr())
        groups->destroyResourceGroup(mGroup);
}

Ogre::MaterialPtr SurfaceMaterials::create(const Ogre::String& name) const
{
    return Ogre::MaterialManager::getSingleton().create(name, mGroup);
}

template <class Work>
SurfaceMaterials::Sides SurfaceMaterials::bothWays(const Ogre::String& name, Work paint) const
{
    Sides sides{create(mGroup + "/" + name), create(mGroup + "/" + name + "/both")};
    for (const Ogre::MaterialPtr& material : {sides.front, sides.both}) {
        Ogre::Technique& technique = *material->getTechnique(0);
        paint(technique);
        for (Ogre::Pass* pass : technique.getPasses())
            pass->setCullingMode(material == sides.both ? Ogre::CULL_NONE : Ogre::CULL_CLOCKWISE);
        material->load();
    }
    return sides;
}

/// Eight by eight squares over the unit square, the first row blue and the first column red, so that directions are
/// seen.
void SurfaceMaterials::makeCheckerTexture()
{
    constexpr std::uint32_t kSize = 256, kSquare = 32;
    std::vector<std::uint8_t> rgb;
    for (std::uint32_t y = 0; y < kSize; ++y)
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const std::uint32_t column = x / kSquare, row = y / kSquare;
            const bool isLight = (column + row) % 2 == 0;
            const std::uint8_t full = isLight ? 225 : 95, low = isLight ? 150 : 45;
            rgb.push_back(row == 0 ? low : full);
            rgb.push_back(row == 0 || column == 0 ? low : full);
            rgb.push_back(column == 0 && row > 0 ? low : full);
        }
    mCheckerTexture = Ogre::TextureManager::getSingleton().createManual(
        mGroup + "/checker", mGroup, Ogre::TEX_TYPE_2D, kSize, kSize, Ogre::MIP_UNLIMITED, Ogre::PF_BYTE_RGB,
        Ogre::TU_STATIC | Ogre::TU_AUTOMIPMAP);
    mCheckerTexture->getBuffer()->blitFromMemory(
        Ogre::PixelBox(Ogre::Box(0, 0, kSize, kSize), Ogre::PF_BYTE_RGB, rgb.data()));
}

Ogre::Technique* SurfaceMaterials::techniqueFor(Paint paint, Ogre::Renderable& part, Ogre::Technique* own) const
{
    if (own->getParent() == mVertexColours.get()
        || (paint == Paint::Own && !isStandIn(*own->getParent()) && texturesMissing(*own).empty()))
        return own;
    Ogre::RenderOperation operation;
    part.getRenderOperation(operation);
    const Sides* sides = paint == Paint::Faceted ? &mFaceted : &mGrey;
    if (paint == Paint::Plain)
        sides = &mPlain;
    else if (paint == Paint::Lines || !has(operation.vertexData, Ogre::VES_NORMAL))
        sides = &mLines; // without normals nothing but lines shows the shape
    else if (paint == Paint::Checker && has(operation.vertexData, Ogre::VES_TEXTURE_COORDINATES))
        sides = &mChecker;
    return (isSeenFromBothSides(own) ? sides->both : sides->front)->getTechnique(0);
}

bool isStandIn(const Ogre::Material& material)
{
    return material.getName() == "BaseWhite" || material.getName() == "BaseWhiteNoLighting";
}

std::vector<const Ogre::TextureUnitState*> texturesMissing(const Ogre::Technique& technique)
{
    std::vector<const Ogre::TextureUnitState*> missing;
    for (const Ogre::Pass* pass : technique.getPasses())
        for (const Ogre::TextureUnitState* unit : pass->getTextureUnitStates())
            if (unit->isTextureLoadFailing())
                missing.push_back(unit);
    return missing;
}

bool hasTextureCoordinates(const Ogre::Mesh& mesh)
{
    return std::all_of(mesh.getSubMeshes().begin(), mesh.getSubMeshes().end(), [&](const Ogre::SubMesh* part) {
        return has(part->useSharedVertices ? mesh.sharedVertexData : part->vertexData, Ogre::VES_TEXTURE_COORDINATES);
    });
}

} // namespace lodsmith
