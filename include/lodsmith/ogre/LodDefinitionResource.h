#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>
#include <lodsmith/loddef/LodDefinition.h>

#include <OgreResource.h>

#include <memory>
#include <optional>
#include <vector>

namespace lodsmith {

/// A `.loddef` file as a resource of OGRE's: its name is the file's name in the resource group. Made by
/// LodDefinitionManager.
///
/// load() reads the file from its group, reload() reads it again. A file with errors is loaded all the same, and holds no
/// definition then; its errors and warnings are in OGRE's log, with file and line. A file that cannot be opened is an
/// exception of OGRE's from load(), as with every resource. Main thread only, as MeshReader.
class LODSMITH_API LodDefinitionResource final : public Ogre::Resource {
public:
    LodDefinitionResource(Ogre::ResourceManager* creator, const Ogre::String& name, Ogre::ResourceHandle handle,
                          const Ogre::String& group, bool isManual, Ogre::ManualResourceLoader* loader);
    ~LodDefinitionResource() override;

    /// Null while it is not loaded, and when its file has errors. Valid until it is unloaded, reloaded or set.
    const LodDefinition* definition() const { return mDefinition ? &*mDefinition : nullptr; }

    /// Why a loaded resource has no definition; empty when it has one.
    const std::vector<Error>& errors() const { return mErrors; }

    /// Whether the definition, or its absence, is what the file said when it was loaded: not after setDefinition().
    bool isFromFile() const { return mIsFromFile; }

    /// Takes a definition from elsewhere than the file, for manual loaders and editors; it lasts until the next unload or
    /// reload. The state count rises, as after a reload. A definition with errors (findErrors()) is misuse.
    void setDefinition(LodDefinition definition);

private:
    void loadImpl() override;
    void unloadImpl() override;
    std::size_t calculateSize() const override;

    std::optional<LodDefinition> mDefinition;
    std::vector<Error> mErrors;
    bool mIsFromFile = true;
};

using LodDefinitionResourcePtr = std::shared_ptr<LodDefinitionResource>;

} // namespace lodsmith
