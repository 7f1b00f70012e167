#include "InsidePath.h"

#include <algorithm>
#include <string>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

Error refusal(ErrorCode code, std::string message, std::string_view name)
{
    Error error{code, std::move(message)};
    error.file = std::string(name);
    return error;
}

bool isForbidden(char c)
{
    return c == '\\' || c == ':' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

/// An absolute name begins with an empty part.
bool hasOrdinaryParts(std::string_view name)
{
    for (;;) {
        const std::size_t end = std::min(name.find('/'), name.size());
        const std::string_view part = name.substr(0, end);
        if (part.empty() || part == "." || part == "..")
            return false;
        if (end == name.size())
            return true;
        name.remove_prefix(end + 1);
    }
}

/// Absolute and without symbolic links, as far as it exists.
Result<fs::path> resolved(const fs::path& path)
{
    std::error_code code;
    fs::path result = fs::absolute(path, code);
    if (!code)
        result = fs::weakly_canonical(result, code);
    if (code)
        return Error{ErrorCode::Io, "its directory cannot be followed: " + code.message()};
    return result;
}

bool isBelow(const fs::path& path, const fs::path& directory)
{
    auto part = path.begin();
    for (const fs::path& wanted : directory) {
        // A slash at the end makes an empty part.
        if (wanted.empty())
            continue;
        if (part == path.end() || *part != wanted)
            return false;
        ++part;
    }
    return true;
}

} // namespace

Result<fs::path> pathInside(const fs::path& directory, std::string_view name)
{
    if (directory.empty())
        return refusal(ErrorCode::InvalidSetting, "there is no directory for it", name);
    if (std::any_of(name.begin(), name.end(), isForbidden))
        return refusal(ErrorCode::InvalidSetting,
                       "the name has a backslash, a colon or a control character, which file names may not have here",
                       name);
    if (!hasOrdinaryParts(name))
        return refusal(ErrorCode::InvalidSetting, "the name is no relative path without empty parts, \".\" and \"..\"",
                       name);
    const fs::path target = directory / fs::path(std::string(name));
    const Result<fs::path> root = resolved(directory), parent = resolved(target.parent_path());
    for (const Result<fs::path>& path : {root, parent})
        if (!path)
            return refusal(path.error().code, path.error().message, name);
    if (!isBelow(parent.value(), root.value()))
        return refusal(ErrorCode::InvalidSetting,
                       "the name leads out of the directory " + directory.string() + " over a symbolic link", name);
    return target;
}

} // namespace lodsmith
