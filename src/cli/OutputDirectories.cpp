#include "OutputDirectories.h"

#include "BuildRecord.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

Error syncError(const fs::path& directory)
{
    return Error{ErrorCode::Io, std::string("not everything could be brought to the disk: ") + std::strerror(errno),
                 directory.string()};
}

} // namespace

fs::path directoryOf(const fs::path& file)
{
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

std::set<fs::path> outputDirectories(const std::vector<PlannedFile>& plan)
{
    std::set<fs::path> directories;
    for (const PlannedFile& file : plan)
        if (!file.error)
            directories.insert({directoryOf(file.output), directoryOf(recordFile(file.output))});
    return directories;
}

Result<Done> syncFileSystems(const std::set<fs::path>& directories)
{
    std::set<dev_t> done;
    for (const fs::path& directory : directories) {
        const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (descriptor < 0)
            continue; // nothing has been written there
        struct stat status = {};
        const bool isNew = ::fstat(descriptor, &status) == 0 && done.insert(status.st_dev).second;
        const bool synced = !isNew || ::syncfs(descriptor) == 0;
        const Error error = synced ? Error{} : syncError(directory);
        ::close(descriptor);
        if (!synced)
            return error;
    }
    return Done{};
}

} // namespace lodsmith::cli
