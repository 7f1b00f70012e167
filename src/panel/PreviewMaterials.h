#pragma once

#include <lodsmith/panel/MeshPreview.h>

#include <OgreMaterial.h>
#include <OgreTexture.h>

namespace lodsmith {

/// What the preview's modes paint with: materials made in code, which need no shaders and no files.
class PreviewMaterials {
public:
    /// @param group a resource group for them, whose name nothing else in OGRE has
    explicit PreviewMaterials(const Ogre::String& group);
    ~PreviewMaterials();
    PreviewMaterials(const PreviewMaterials&) = delete;
    PreviewMaterials& operator=(const PreviewMaterials&) = delete;

    /// How a part of a mesh is painted in a mode; `own` is what its own material has for it.
    Ogre::Technique* techniqueFor(ViewMode mode, Ogre::Renderable& part, Ogre::Technique* own) const;

    /// For geometry with a colour for each vertex.
    const Ogre::MaterialPtr& vertexColours() const { return mVertexColours; }

private:
    /// One material, twice: for what is seen from the front alone, and for what is seen from both sides.
    struct Sides {
        Ogre::MaterialPtr front;
        Ogre::MaterialPtr both;
    };

    Ogre::MaterialPtr create(const Ogre::String& name) const;
    template <class Paint>
    Sides bothWays(const Ogre::String& name, Paint paint) const;
    void makeCheckerTexture();

    Ogre::String mGroup;
    Ogre::TexturePtr mCheckerTexture;
    Sides mGrey;
    Sides mFaceted;
    Sides mLines;
    Sides mChecker;
    Ogre::MaterialPtr mVertexColours;
};

/// Whether a mesh has texture coordinates to show a checker by, in all its parts.
bool hasTextureCoordinates(const Ogre::Mesh& mesh);

} // namespace lodsmith
