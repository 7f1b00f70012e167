#include <lodsmith/core/Result.h>

namespace lodsmith {

const char* toString(ErrorCode code)
{
    switch (code) {
    case ErrorCode::InvalidGeometry: return "invalid_geometry";
    case ErrorCode::IndexOutOfRange: return "index_out_of_range";
    case ErrorCode::InvalidSetting: return "invalid_setting";
    case ErrorCode::Unsupported: return "unsupported";
    case ErrorCode::NotFound: return "not_found";
    case ErrorCode::Io: return "io";
    case ErrorCode::BadFile: return "bad_file";
    case ErrorCode::Cancelled: return "cancelled";
    case ErrorCode::OutOfMemory: return "out_of_memory";
    }
    return "unknown";
}

std::string describe(const Error& error)
{
    std::string text = error.file;
    if (error.line >= 0)
        text += (text.empty() ? "line " : ":") + std::to_string(error.line);
    if (!text.empty())
        text += ": ";
    if (error.subMesh >= 0)
        text += "submesh " + std::to_string(error.subMesh) + (error.item >= 0 ? ", " : ": ");
    if (error.item >= 0)
        text += "item " + std::to_string(error.item) + ": ";
    return text + error.message;
}

} // namespace lodsmith
