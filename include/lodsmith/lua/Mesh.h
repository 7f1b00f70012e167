#pragma once

#include <lodsmith/lua/Returned.h>

#include <OgreMesh.h>

#include <memory>

namespace lodsmith::lua {

/// A mesh of OGRE's, which may go at any time: docs/lua.md. Main thread only.
class LODSMITH_API Mesh final : public Handle {
public:
    /// @param mesh not null
    explicit Mesh(const Ogre::MeshPtr& mesh);
    ~Mesh() override;

    /// Null when it is gone.
    Ogre::MeshPtr lock() const;
    /// Loaded, or why not: NotFound when it is gone, InvalidSetting when it is not loaded.
    Result<Ogre::MeshPtr> loaded() const;

    Returned name() const;
    Returned group() const;
    Returned isLoaded() const;
    Returned isGone() const;
    Returned load() const;
    Returned equals(const Mesh& other) const;
    Returned path() const;
    Returned info() const;
    Returned triangles(double level) const;

private:
    std::weak_ptr<Ogre::Mesh> mMesh;
};

} // namespace lodsmith::lua
