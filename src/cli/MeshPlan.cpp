#include "MeshPlan.h"

#include <lodsmith/analysis/MeshStatistics.h>
#include <lodsmith/loddef/LoddefXml.h>
#include <lodsmith/ogre/DefinedLodConfig.h>
#include <lodsmith/ogre/MeshReader.h>

#include <optional>
#include <utility>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

Result<HandMadeLevel> loadHandMade(const fs::path& file, const std::string& name, OgreSession& session,
                                   const Ogre::Mesh& owner)
{
    const Result<Ogre::MeshPtr> mesh = session.loadLevelOf(owner, file, name);
    if (!mesh)
        return mesh.error();
    const Result<MeshData> data = MeshReader::read(*mesh.value());
    if (!data)
        return data.error();
    const Result<MeshStatistics> statistics = meshStatistics(data.value().view());
    if (!statistics)
        return statistics.error();
    return HandMadeLevel{file, statistics.value().vertices, statistics.value().triangles};
}

class MeshPlanner {
public:
    MeshPlanner(const GenerateSettings& settings, const PlannedFile& file, OgreSession& session,
                const Ogre::MeshPtr& mesh)
        : mSettings(settings), mFile(file), mSession(session), mMesh(mesh)
    {
    }

    Result<MeshPlan> plan()
    {
        const auto definition = chosenDefinition(mSettings.definition, mFile.input);
        if (mSettings.definition.waits)
            if (const auto beside = definitionBeside(mFile.input))
                mPlan.notes.push_back(beside->string() + " is not used: the command line says what levels there are");
        const Result<Done> planned = definition ? planDefinition(*definition) : planSettings();
        if (!planned)
            return planned.error();
        mPlan.config.shareIndexBuffers = mSettings.shareBuffers;
        mPlan.config.options.threads = mSettings.threads;
        return std::move(mPlan);
    }

private:
    Result<Done> planSettings()
    {
        LodConfig& config = mPlan.config;
        if (mSettings.levels.empty()) {
            if (!(mMesh->getBoundingSphereRadius() > 0.0f))
                return Error{ErrorCode::InvalidGeometry,
                             "has no bounding radius, which the automatic levels follow; use --levels"};
            AutomaticLods automatic = mSettings.automatic;
            automatic.metric = mSettings.metric;
            config = automaticLodConfig(mMesh, automatic);
        } else {
            config.mesh = mMesh;
            config.strategy = mSettings.strategy;
        }
        for (const LevelSpec& level : mSettings.levels) {
            config.levels.push_back({level.value, level.target, {}});
            if (!level.isManual())
                continue;
            Result<std::string> name = addHandMade(level.meshFile);
            if (!name)
                return name.error();
            config.levels.back().manualMeshName = std::move(name).value();
        }
        if (mSettings.metric)
            config.options.metric = *mSettings.metric;
        config.options.weights = mSettings.weights;
        config.options.lockBorders = mSettings.lockBorders;
        config.options.lockSeams = mSettings.lockSeams;
        return Done{};
    }

    Result<Done> planDefinition(const fs::path& path)
    {
        Result<LodDefinition> definition = readDefinition(path);
        if (!definition)
            return definition.error();
        if (auto found = nameHandMade(definition.value(), path); !found)
            return found;
        Result<DefinedLodConfig> defined = lodConfig(definition.value(), mMesh, path.string(), mSettings.automatic);
        if (!defined)
            return defined.error();
        if (!defined.value().leftOut.empty())
            return defined.value().leftOut.front();
        mPlan.config = std::move(defined).value().config;
        mPlan.loddef = path.string();
        if (mSettings.saysAutomatic && !definition.value().automatic)
            mPlan.notes.push_back(path.string() + " says what levels there are: --automatic and --pixels do not count");
        return Done{};
    }

    Result<LodDefinition> readDefinition(const fs::path& path)
    {
        LoddefReading reading = readLoddefFile(path);
        if (!reading.ok()) {
            Error error = reading.errors.front();
            if (const std::size_t more = reading.errors.size() - 1; more > 0)
                error.message += " (and " + std::to_string(more) + " more; lodsmith validate lists them)";
            return error;
        }
        for (const Error& warning : reading.warnings)
            mPlan.notes.push_back(describe(warning));
        return std::move(*reading.definition);
    }

    /// Loads the hand-made levels of a definition and gives them the names under which the mesh will know them.
    Result<Done> nameHandMade(LodDefinition& definition, const fs::path& path)
    {
        if (definition.automatic)
            return Done{};
        for (LodLevelDefinition& level : definition.levels) {
            if (!level.isManual())
                continue;
            const Result<fs::path> file = findHandMade(level.meshName, mFile.input, path);
            if (!file)
                return file.error();
            Result<std::string> name = addHandMade(file.value());
            if (!name)
                return name.error();
            level.meshName = std::move(name).value();
        }
        return Done{};
    }

    /// Hand-made meshes end up beside the output under their own names, which therefore have to differ.
    Result<std::string> addHandMade(const fs::path& file)
    {
        const std::string name = file.filename().string();
        const auto known = mPlan.handMade.find(name);
        if (known != mPlan.handMade.end() && known->second.file == file)
            return name;
        if (known != mPlan.handMade.end() || file.filename() == mFile.output.filename())
            return Error{ErrorCode::InvalidSetting,
                         "as a hand-made level it needs a file name of its own: both "
                             + (known == mPlan.handMade.end() ? mFile.output : known->second.file).string()
                             + " and it would be '" + name + "' beside the output",
                         file.string()};
        const Result<HandMadeLevel> level = loadHandMade(file, name, mSession, *mMesh);
        if (!level)
            return level.error();
        mPlan.handMade.emplace(name, level.value());
        return name;
    }

    const GenerateSettings& mSettings;
    const PlannedFile& mFile;
    OgreSession& mSession;
    const Ogre::MeshPtr& mMesh;
    MeshPlan mPlan;
};

} // namespace

Result<MeshPlan> planMesh(const GenerateSettings& settings, const PlannedFile& file, OgreSession& session,
                          const Ogre::MeshPtr& mesh)
{
    return MeshPlanner(settings, file, session, mesh).plan();
}

} // namespace lodsmith::cli
