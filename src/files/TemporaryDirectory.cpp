#include "TemporaryDirectory.h"

#include "AtomicFile.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith {

fs::path TemporaryDirectory::parent()
{
    std::error_code code;
    const fs::path directory = fs::temp_directory_path(code);
    return code ? fs::path("/tmp") : directory;
}

Result<TemporaryDirectory> TemporaryDirectory::create()
{
    std::string name = (parent() / (AtomicFile::temporaryPrefix(::getpid()) + "XXXXXX")).string();
    if (::mkdtemp(name.data()))
        return TemporaryDirectory(name);
    Error error{ErrorCode::Io, std::string("a temporary directory cannot be made: ") + std::strerror(errno)};
    error.file = parent().string();
    return error;
}

TemporaryDirectory::TemporaryDirectory(fs::path path) : mPath(std::move(path)) {}

TemporaryDirectory::TemporaryDirectory(TemporaryDirectory&& other) noexcept : mPath(std::move(other.mPath))
{
    other.mPath.clear();
}

TemporaryDirectory& TemporaryDirectory::operator=(TemporaryDirectory&& other) noexcept
{
    std::swap(mPath, other.mPath);
    return *this;
}

TemporaryDirectory::~TemporaryDirectory()
{
    std::error_code ignored;
    if (!mPath.empty())
        fs::remove_all(mPath, ignored);
}

} // namespace lodsmith
