#include "CutOutMaterials.h"

#include <lodsmith/render/SurfaceMaterials.h>

#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreTechnique.h>

namespace lodsmith {

namespace {

const Ogre::ColourValue kGrey(0.72f, 0.72f, 0.70f);

/// Colours from the light alone, alpha from the texture.
void takeAlphaAlone(Ogre::TextureUnitState& unit)
{
    unit.setColourOperationEx(Ogre::LBX_SOURCE1, Ogre::LBS_CURRENT, Ogre::LBS_CURRENT);
    unit.setAlphaOperation(Ogre::LBX_SOURCE1, Ogre::LBS_TEXTURE, Ogre::LBS_CURRENT);
}

void paint(Ogre::Pass& pass, const Ogre::TexturePtr& pattern)
{
    const Ogre::ColourValue& colour = pattern ? Ogre::ColourValue::White : kGrey;
    pass.setLightingEnabled(true);
    pass.setVertexColourTracking(Ogre::TVC_NONE);
    pass.setAmbient(colour);
    pass.setDiffuse(colour);
    pass.setSpecular(Ogre::ColourValue::Black);
    pass.setSelfIllumination(Ogre::ColourValue::Black);
    pass.setSceneBlending(Ogre::SBT_REPLACE);
    while (pass.getNumTextureUnitStates() > 1)
        pass.removeTextureUnitState(1);
    takeAlphaAlone(*pass.getTextureUnitState(0));
    if (!pattern)
        return;
    Ogre::TextureUnitState& unit = *pass.createTextureUnitState();
    unit.setTexture(pattern);
    unit.setAlphaOperation(Ogre::LBX_SOURCE1, Ogre::LBS_CURRENT, Ogre::LBS_CURRENT);
}

} // namespace

bool CutOutMaterials::hasHoles(const Ogre::Technique& technique)
{
    if (technique.getNumPasses() == 0)
        return false;
    const Ogre::Pass& pass = *technique.getPass(0);
    return pass.getAlphaRejectFunction() != Ogre::CMPF_ALWAYS_PASS && pass.getNumTextureUnitStates() > 0
           && !pass.isProgrammable() && texturesMissing(technique).empty();
}

Ogre::Technique* CutOutMaterials::techniqueFor(Ogre::Technique& own, const Ogre::TexturePtr& pattern)
{
    Ogre::MaterialPtr& material = mMaterials[{&own, pattern != nullptr}];
    if (!material) {
        material = Ogre::MaterialManager::getSingleton().create(
            mGroup + "/cut out " + std::to_string(mMaterials.size()), mGroup);
        Ogre::Pass& pass = *material->getTechnique(0)->getPass(0);
        pass = *own.getPass(0);
        paint(pass, pattern);
        material->load();
    }
    return material->getTechnique(0);
}

} // namespace lodsmith
