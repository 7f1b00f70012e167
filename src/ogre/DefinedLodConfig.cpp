#include <lodsmith/ogre/DefinedLodConfig.h>

#include "BesideDefinition.h"
#include "GenerationSteps.h"
#include "LodPlan.h"
#include "MainThread.h"

#include <lodsmith/core/Assert.h>
#include <lodsmith/loddef/LoddefFileName.h>

#include <OgreStringConverter.h>

#include <utility>

namespace lodsmith {

namespace {

/// Puts a configuration together; what cannot be had goes to `leftOut`.
class DefinedLevels {
public:
    DefinedLevels(const LodDefinition& definition, const Ogre::MeshPtr& mesh, Ogre::String definitionName)
        : mDefinition(definition), mMesh(*mesh), mDefinitionName(std::move(definitionName))
    {
        mDefined.config.mesh = mesh;
    }

    DefinedLodConfig build()
    {
        mDefined.config.strategy = ogreName(mDefinition.strategy);
        mDefined.config.options = simplifyOptions(mDefinition);
        for (const LodLevelDefinition& level : levelsNearestFirst(mDefinition))
            addLevel(level);
        for (const SubMeshImportance& entry : mDefinition.subMeshes)
            addImportance(entry);
        return std::move(mDefined);
    }

private:
    void leaveOut(Error error)
    {
        error.file = mDefinitionName;
        mDefined.leftOut.push_back(std::move(error));
    }

    void addLevel(const LodLevelDefinition& level)
    {
        LodLevel added{level.value, level.target, {}};
        if (level.isManual()) {
            Result<Ogre::MeshPtr> mesh = findManualLevel(level.meshName);
            if (!mesh) {
                Error error = mesh.error();
                error.message =
                    "the level at " + Ogre::StringConverter::toString(level.value) + " is left out: " + error.message;
                return leaveOut(std::move(error));
            }
            added.manualMeshName = mesh.value()->getName();
        }
        mDefined.config.levels.push_back(std::move(added));
    }

    Result<Ogre::MeshPtr> findManualLevel(const Ogre::String& name) const
    {
        Result<Ogre::MeshPtr> mesh = findManualMesh(name, mMesh);
        if (mesh || mesh.error().code != ErrorCode::NotFound)
            return mesh;
        const Ogre::String relative = besideDefinition(mDefinitionName, name);
        if (relative == name)
            return mesh;
        Result<Ogre::MeshPtr> beside = findManualMesh(relative, mMesh);
        if (beside || beside.error().code != ErrorCode::NotFound)
            return beside;
        Error error = mesh.error();
        error.message += ", nor \"" + relative + "\"";
        return error;
    }

    void addImportance(const SubMeshImportance& entry)
    {
        const std::size_t count = mMesh.getNumSubMeshes();
        if (entry.subMesh >= count)
            return leaveOut(Error{ErrorCode::NotFound, "there is no submesh " + std::to_string(entry.subMesh)
                                                           + ", the mesh has " + std::to_string(count)});
        std::vector<float>& importance = mDefined.config.subMeshImportance;
        importance.resize(count);
        importance[entry.subMesh] = entry.importance;
    }

    const LodDefinition& mDefinition;
    const Ogre::Mesh& mMesh;
    Ogre::String mDefinitionName;
    DefinedLodConfig mDefined;
};

Error about(Error error, const Ogre::String& file)
{
    error.file = file;
    return error;
}

} // namespace

Result<DefinedLodConfig> lodConfig(const LodDefinition& definition, const Ogre::MeshPtr& mesh,
                                   const Ogre::String& definitionName, const AutomaticLods& automatic)
{
    assertMainThread();
    LODSMITH_ASSERT(mesh, "lodConfig() needs a mesh");
    const Ogre::String name = definitionName.empty() ? loddefFileName(mesh->getName()) : definitionName;
    if (const std::vector<Error> errors = findErrors(definition); !errors.empty())
        return about(errors.front(), name);
    if (!definition.automatic)
        return DefinedLevels(definition, mesh, name).build();
    Result<LodConfig> config = checkedAutomaticConfig(mesh, automatic);
    if (!config)
        return config.error();
    return DefinedLodConfig{std::move(config).value(), {}};
}

} // namespace lodsmith
