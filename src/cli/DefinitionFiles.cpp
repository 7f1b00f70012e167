#include "DefinitionFiles.h"

#include "OgreSession.h"

#include <lodsmith/loddef/LoddefFileName.h>
#include <lodsmith/loddef/LoddefXml.h>

#include <algorithm>
#include <set>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

/// The hand-made levels of one mesh that are there; whatever is wrong is told when the mesh's turn comes.
std::set<fs::path> handMadeLevels(const fs::path& mesh, const fs::path& definition)
{
    std::set<fs::path> found;
    const LoddefReading reading = readLoddefFile(definition);
    if (!reading.ok() || reading.definition->automatic)
        return found;
    for (const LodLevelDefinition& level : reading.definition->levels)
        if (level.isManual())
            if (const auto file = findHandMade(level.meshName, mesh, definition))
                found.insert(identity(file.value()));
    found.erase(identity(mesh));
    return found;
}

} // namespace

std::optional<fs::path> definitionBeside(const fs::path& mesh)
{
    const std::string name = loddefFileName(mesh.string());
    std::error_code ignored;
    // A link that leads nowhere is there as well, and an error when it is read.
    if (name.empty() || !fs::exists(fs::symlink_status(name, ignored)))
        return std::nullopt;
    return fs::path(name);
}

std::optional<fs::path> chosenDefinition(const DefinitionChoice& choice, const fs::path& mesh)
{
    if (!choice.given.empty())
        return fs::path(choice.given);
    return choice.beside && !choice.waits ? definitionBeside(mesh) : std::nullopt;
}

Result<fs::path> findHandMade(const std::string& name, const fs::path& mesh, const fs::path& definition)
{
    Error error{ErrorCode::NotFound, "there is no mesh '" + name + "', neither beside the mesh nor beside this file"};
    error.file = definition.string();
    if (!OgreSession::staysInside(name)) {
        error.code = ErrorCode::InvalidSetting;
        error.message = "the mesh '" + name + "' is not below the directory of the mesh or of this file";
        return error;
    }
    for (const fs::path& neighbour : {mesh, definition}) {
        std::error_code ignored;
        if (const fs::path file = neighbour.parent_path() / name; fs::exists(file, ignored))
            return file;
    }
    return error;
}

std::vector<PlannedFile> withoutHandMade(std::vector<PlannedFile> plan, const DefinitionChoice& choice)
{
    std::set<fs::path> handMade;
    for (const PlannedFile& file : plan) {
        const auto definition = file.error ? std::nullopt : chosenDefinition(choice, file.input);
        if (definition && handMade.count(identity(file.input)) == 0)
            handMade.merge(handMadeLevels(file.input, *definition));
    }
    const auto goesAlong = [&](const PlannedFile& file) {
        return !file.error && handMade.count(identity(file.input)) > 0;
    };
    plan.erase(std::remove_if(plan.begin(), plan.end(), goesAlong), plan.end());
    return plan;
}

} // namespace lodsmith::cli
