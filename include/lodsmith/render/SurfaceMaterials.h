#pragma once

#include <lodsmith/core/Export.h>

#include <OgreMaterial.h>
#include <OgreMesh.h>
#include <OgreTexture.h>

#include <vector>

namespace lodsmith {

/// What a surface is painted with.
enum class Paint {
    Own,     ///< the mesh's own materials; grey where one, or a texture of it, is missing or cannot be used
    Grey,    ///< grey, lit
    Faceted, ///< grey, each triangle in one shade
    Lines,   ///< lines over a surface that hides those behind it
    Checker, ///< squares by the first texture coordinates, lit; grey without them
    Plain,   ///< one shade all over
};

/// Materials made in code, which need no shaders and no files, but a render system with fixed functions. Where a part
/// has no normals, what is to be lit is drawn as Paint::Lines, since nothing else shows its shape.
class LODSMITH_API SurfaceMaterials {
public:
    /// @param group a resource group for them, whose name nothing else in OGRE has
    explicit SurfaceMaterials(const Ogre::String& group);
    ~SurfaceMaterials();
    SurfaceMaterials(const SurfaceMaterials&) = delete;
    SurfaceMaterials& operator=(const SurfaceMaterials&) = delete;

    /// How a part of a mesh is painted; `own` is what its own material has for it.
    Ogre::Technique* techniqueFor(Paint paint, Ogre::Renderable& part, Ogre::Technique* own) const;

    /// What Paint::Checker is made of.
    const Ogre::TexturePtr& checker() const { return mCheckerTexture; }
    /// For geometry with a colour for each vertex.
    const Ogre::MaterialPtr& vertexColours() const { return mVertexColours; }

private:
    /// One material, twice: for what is seen from the front alone, and for what is seen from both sides.
    struct Sides {
        Ogre::MaterialPtr front;
        Ogre::MaterialPtr both;
    };

    Ogre::MaterialPtr create(const Ogre::String& name) const;
    template <class Work>
    Sides bothWays(const Ogre::String& name, Work paint) const;
    void makeCheckerTexture();

    Ogre::String mGroup;
    Ogre::TexturePtr mCheckerTexture;
    Sides mGrey;
    Sides mFaceted;
    Sides mLines;
    Sides mChecker;
    Sides mPlain;
    Ogre::MaterialPtr mVertexColours;
};

/// Whether a mesh has texture coordinates to show a checker by, in all its parts.
LODSMITH_API bool hasTextureCoordinates(const Ogre::Mesh& mesh);

/// Whether OGRE put it in the place of a material that is missing or cannot be used.
LODSMITH_API bool isStandIn(const Ogre::Material& material);

/// The textures of a technique, once that is loaded, for which OGRE has drawn a warning since it could not read them.
LODSMITH_API std::vector<const Ogre::TextureUnitState*> texturesMissing(const Ogre::Technique& technique);

} // namespace lodsmith
