#include "CommandOptions.h"
#include "Commands.h"
#include "Inspection.h"
#include "Numbers.h"
#include "Table.h"

#include <cstdio>
#include <memory>

namespace lodsmith::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  lodsmith inspect tree.mesh
  lodsmith inspect tree.mesh --json
)";

struct InspectArguments {
    std::string mesh;
    BatchOptions batch;
    bool json = false;
};

std::string text(const Json& value)
{
    if (value.is_null())
        return "-";
    if (value.is_string())
        return printable(value.get<std::string>());
    if (value.is_boolean())
        return value.get<bool>() ? "yes" : "no";
    return formatNumber(value.get<double>(), 9);
}

std::string subMeshTable(const Json& record)
{
    Table table({"submesh", "material", "drawn as", "vertices", "buffer", "indices", "bits", "bones"});
    std::size_t number = 0;
    for (const Json& subMesh : record["submeshes"])
        table.add({std::to_string(number++), text(subMesh["material"]), text(subMesh["operation"]),
                   text(subMesh["buffer_vertices"]), subMesh["shared_vertices"].get<bool>() ? "shared" : "own",
                   text(subMesh["indices"]), text(subMesh["index_bits"]), text(subMesh["bone_assignments"])});
    return table.text();
}

std::string levelTable(const Json& record)
{
    Table table({"level", "value", "triangles", "bytes", "hand-made"});
    std::size_t number = 0;
    for (const Json& level : record["levels"])
        table.add({std::to_string(number++), text(level["value"]), text(level["triangles"]), text(level["bytes"]),
                   text(level["manual"])});
    return "levels by " + text(record["strategy"]) + "\n" + table.text();
}

std::string statisticsText(const Json& record)
{
    if (record["statistics"].is_null())
        return "";
    std::string result;
    for (const auto& [name, value] : record["statistics"].items()) {
        std::string words = name;
        for (char& c : words)
            c = c == '_' ? ' ' : c;
        result += words + ": " + text(value) + "\n";
    }
    return result;
}

std::string report(const Json& record)
{
    std::string result = text(record["input"]) + ": format " + text(record["format"])
                         + (record["big_endian"].get<bool>() ? ", big endian" : "") + ", " + text(record["bytes"])
                         + " bytes\n";
    result += statisticsText(record);
    result += "skeleton: " + text(record["skeleton"])
              + (record["skeleton"].is_null() ? "" : ", bones: " + text(record["bones"])) + "\n";
    result += "poses: " + text(record["poses"]) + ", animations: " + text(record["animations"])
              + ", edge lists: " + text(record["edge_lists"]) + "\n";
    result += subMeshTable(record) + levelTable(record);
    for (const Json& note : record["notes"])
        result += "note: " + text(note) + "\n";
    return result;
}

int runInspect(const InspectArguments& arguments)
{
    BatchJob job;
    job.file = arguments.mesh;
    job.inputBytes = fileBytes(arguments.mesh);
    job.work = [&arguments](Progress&) { return inspectFile(arguments.mesh); };
    return runBatch({job}, arguments.batch, [&](std::size_t, const Result<Json>& outcome) {
        Json record{{"input", arguments.mesh}};
        if (outcome) {
            record.update(outcome.value());
            record["error"] = nullptr;
        } else {
            setError(record, outcome.error());
        }
        if (arguments.json)
            std::printf("%s\n", toLine(record).c_str());
        else if (outcome)
            std::printf("%s", report(record).c_str());
    });
}

} // namespace

void addInspectCommand(CLI::App& app, int& exitCode)
{
    const auto arguments = std::make_shared<InspectArguments>();
    CLI::App* command = app.add_subcommand("inspect", "Say what a mesh is made of");
    command->add_option("MESH", arguments->mesh, "A mesh")->required();
    addTimeLimitOption(*command, arguments->batch);
    command->add_flag("--json", arguments->json, "Print one JSON object on standard output, and nothing else there");
    command->footer(kExamples);
    command->callback([arguments, &exitCode] { exitCode = runInspect(*arguments); });
}

} // namespace lodsmith::cli
