#include "JudgedMesh.h"

#include "../Generation.h"
#include "../OgreSession.h"

#include <utility>

namespace lodsmith::cli {

namespace {

Result<std::size_t> levelsIn(const std::filesystem::path& file)
{
    OgreSession session;
    const Result<Ogre::MeshPtr> mesh = session.load(file);
    if (!mesh)
        return mesh.error();
    return mesh.value()->getNumLodLevels();
}

std::vector<std::optional<std::string>> stopsIn(const Json& levels)
{
    std::vector<std::optional<std::string>> stops;
    for (const Json& level : levels)
        if (!level["skipped"].get<bool>())
            stops.push_back(level["stop"].is_null() ? std::nullopt
                                                    : std::optional<std::string>(level["stop"].get<std::string>()));
    return stops;
}

} // namespace

Result<JudgedMesh> judgedMesh(const PlannedFile& mesh, Progress& progress)
{
    const Result<std::size_t> levels = levelsIn(mesh.input);
    if (!levels)
        return levels.error();
    JudgedMesh judged;
    judged.input = judged.file = mesh.input;
    judged.levelsFrom = "file";
    judged.stops.resize(levels.value());
    if (levels.value() > 1)
        return judged;
    Result<TemporaryDirectory> directory = TemporaryDirectory::create();
    if (!directory)
        return directory.error();
    judged.directory = std::move(directory).value();
    judged.file = judged.directory->path() / mesh.input.filename();
    const GenerateSettings settings;
    OgreSession session;
    const Result<GeneratedMesh> made =
        generateMesh(settings, {mesh.input, judged.file, std::nullopt, mesh.name}, session, progress);
    if (!made)
        return made.error();
    const auto written =
        writeMeshFiles(judged.file, made.value().bytes, made.value().companions, settings.write.overwriting);
    if (!written)
        return written.error();
    const Json& record = made.value().record;
    const Json& loddef = record["loddef"];
    judged.levelsFrom = loddef.is_null() ? "automatic" : "definition";
    if (!loddef.is_null())
        judged.definition = loddef.get<std::string>();
    judged.stops = stopsIn(record["levels"]);
    judged.notes = record["notes"].get<std::vector<std::string>>();
    return judged;
}

} // namespace lodsmith::cli
