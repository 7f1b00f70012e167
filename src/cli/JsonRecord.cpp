#include "JsonRecord.h"

namespace lodsmith::cli {

std::string toLine(const Json& record)
{
    return record.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json toJson(const Error& error)
{
    return Json{{"code", static_cast<int>(error.code)},
                {"message", error.message},
                {"file", error.file},
                {"line", error.line},
                {"submesh", error.subMesh},
                {"item", error.item}};
}

Error errorFromJson(const Json& json)
{
    Error error;
    error.code = static_cast<ErrorCode>(json.at("code").get<int>());
    error.message = json.at("message").get<std::string>();
    error.file = json.at("file").get<std::string>();
    error.line = json.at("line").get<int>();
    error.subMesh = json.at("submesh").get<int>();
    error.item = json.at("item").get<std::int64_t>();
    return error;
}

void setError(Json& record, const Error& error)
{
    record["error"] = describe(error);
    record["error_code"] = lodsmith::toString(error.code);
}

const char* toString(StopReason reason)
{
    switch (reason) {
    case StopReason::TargetReached: return "target_reached";
    case StopReason::Locked: return "locked";
    case StopReason::Seam: return "seam";
    case StopReason::Topology: return "topology";
    }
    return "unknown";
}

std::string stopSentence(const std::string& word)
{
    if (word == "locked")
        return "what is left is locked";
    if (word == "seam")
        return "what is left would need a seam vertex that its neighbour does not have";
    if (word == "topology")
        return "what is left would open a hole, double a face or flip one";
    return "";
}

} // namespace lodsmith::cli
