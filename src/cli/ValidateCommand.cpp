#include "CommandOptions.h"
#include "Commands.h"
#include "JsonRecord.h"
#include "Table.h"

#include <lodsmith/loddef/LoddefXml.h>

#include <cstdio>
#include <memory>

namespace lodsmith::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  lodsmith validate tree.loddef cottage.loddef
  lodsmith validate models/*.loddef --json
)";

struct ValidateArguments {
    std::vector<std::string> files;
    bool json = false;
};

Json problems(const std::vector<Error>& errors)
{
    Json list = Json::array();
    for (const Error& error : errors)
        list.push_back({{"line", error.line < 0 ? Json(nullptr) : Json(error.line)},
                        {"message", error.message},
                        {"code", lodsmith::toString(error.code)}});
    return list;
}

Json record(const std::string& file, const LoddefReading& reading)
{
    Json record{
        {"input", file}, {"valid", reading.ok()}, {"automatic", nullptr}, {"strategy", nullptr}, {"levels", nullptr}};
    if (reading.ok()) {
        record["automatic"] = reading.definition->automatic;
        record["strategy"] = ogreName(reading.definition->strategy);
        record["levels"] = reading.definition->levels.size();
    }
    record["errors"] = problems(reading.errors);
    record["warnings"] = problems(reading.warnings);
    return record;
}

std::string summary(const LodDefinition& definition)
{
    if (definition.automatic)
        return "automatic levels";
    const std::size_t levels = definition.levels.size();
    return std::to_string(levels) + (levels == 1 ? " level by " : " levels by ") + ogreName(definition.strategy);
}

bool validateFile(const std::string& file, bool json)
{
    const LoddefReading reading = readLoddefFile(file);
    for (const Error& warning : reading.warnings)
        std::fprintf(stderr, "lodsmith: warning: %s\n", printable(describe(warning)).c_str());
    for (const Error& error : reading.errors)
        printError(error);
    if (json)
        std::printf("%s\n", toLine(record(file, reading)).c_str());
    else if (reading.ok())
        std::printf("%s: valid, %s\n", printable(file).c_str(), summary(*reading.definition).c_str());
    return reading.ok();
}

int runValidate(const ValidateArguments& arguments)
{
    bool allValid = true;
    for (const std::string& file : arguments.files)
        allValid = validateFile(file, arguments.json) && allValid;
    return finishOutput() && allValid ? kExitDone : kExitFailed;
}

} // namespace

void addValidateCommand(CLI::App& app, int& exitCode)
{
    const auto arguments = std::make_shared<ValidateArguments>();
    CLI::App* command =
        app.add_subcommand("validate", "Check .loddef files, which say what levels of detail a mesh gets");
    command->add_option("FILE", arguments->files, "Files in the grammar of docs/loddef.md")->required();
    command->add_flag("--json", arguments->json,
                      "Print one JSON object a file on standard output, and nothing else there");
    command->footer(kExamples);
    command->callback([arguments, &exitCode] { exitCode = runValidate(*arguments); });
}

} // namespace lodsmith::cli
