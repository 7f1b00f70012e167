#include "AtomicFile.h"

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith {

namespace {

constexpr int kNameAttempts = 1000;
constexpr std::chrono::hours kAbandonedAge{1};
constexpr const char* kIsThere = "is there already";
constexpr std::string_view kPrefix = ".lodsmith-";
constexpr std::string_view kSuffix = ".tmp";

/// Tells the processes of this machine, or container, from those of others that see the same directories, where the same
/// process numbers mean somebody else. FNV-1a of the host's name and the namespace of process numbers.
std::string machineMark()
{
    char host[256] = {};
    ::gethostname(host, sizeof host - 1);
    struct stat processes = {};
    ::stat("/proc/self/ns/pid", &processes);
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : host + ('/' + std::to_string(processes.st_ino)))
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    std::ostringstream digits;
    digits << std::hex << hash;
    return digits.str();
}

/// New files get what the umask leaves, replaced ones keep their permissions.
mode_t permissionsFor(const fs::path& target)
{
    struct stat status = {};
    return ::stat(target.c_str(), &status) == 0 ? status.st_mode & 07777 : 0666;
}

void syncDirectory(const fs::path& directory)
{
    const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    ::fsync(descriptor);
    ::close(descriptor);
}

Error pathError(ErrorCode code, std::string message, const fs::path& path)
{
    Error error{code, std::move(message)};
    error.file = path.string();
    return error;
}

Error tooLarge(const fs::path& path, std::uintmax_t largest)
{
    return pathError(ErrorCode::Io, "is larger than " + std::to_string(largest) + " bytes", path);
}

Result<std::string> readAll(int descriptor, const fs::path& path, std::size_t expected, std::uintmax_t largest)
{
    std::string bytes;
    bytes.reserve(expected);
    char block[1 << 16];
    for (;;) {
        const ssize_t count = ::read(descriptor, block, sizeof block);
        if (count == 0)
            return bytes;
        if (count > 0)
            bytes.append(block, static_cast<std::size_t>(count));
        else if (errno != EINTR)
            return pathError(ErrorCode::Io, std::string("cannot be read: ") + std::strerror(errno), path);
        // The file may have grown since its size was asked for.
        if (bytes.size() > largest)
            return tooLarge(path, largest);
    }
}

} // namespace

AtomicFile::AtomicFile(fs::path target, Existing existing, Durability durability)
    : mTarget(std::move(target)), mExisting(existing), mDurability(durability)
{
    mDirectory = mTarget.has_parent_path() ? mTarget.parent_path() : fs::path(".");
}

AtomicFile::~AtomicFile()
{
    if (mDescriptor >= 0)
        ::close(mDescriptor);
    if (!mTemporary.empty())
        ::unlink(mTemporary.c_str());
}

Result<Done> AtomicFile::prepare(std::string_view bytes)
{
    if (auto allowed = checkTarget(mTarget, mExisting); !allowed)
        return allowed.error();
    std::error_code code;
    fs::create_directories(mDirectory, code);
    if (code)
        return pathError(ErrorCode::Io, "the directory cannot be made: " + code.message(), mDirectory);
    if (auto opened = openTemporary(); !opened)
        return opened.error();
    return writeAll(bytes);
}

Result<Done> AtomicFile::commit()
{
    LODSMITH_ASSERT(!mTemporary.empty() && mDescriptor < 0, "commit() follows a prepare() that succeeded");
    auto moved = mExisting == Existing::Replace ? renameIntoPlace() : linkIntoPlace();
    if (moved && mDurability == Durability::Synced)
        syncDirectory(mDirectory);
    return moved;
}

Result<Done> AtomicFile::checkTarget(const fs::path& target, Existing existing)
{
    struct stat status = {};
    if (::lstat(target.c_str(), &status) != 0)
        return Done{};
    // A link is replaced itself; but one to a device or a directory stands for that.
    if (S_ISLNK(status.st_mode) && ::stat(target.c_str(), &status) != 0)
        status.st_mode = S_IFREG;
    if (!S_ISREG(status.st_mode))
        return pathError(ErrorCode::Io, "is there already and is no regular file", target);
    if (existing == Existing::Keep)
        return pathError(ErrorCode::Io, kIsThere, target);
    return Done{};
}

std::string AtomicFile::temporaryPrefix(pid_t writer)
{
    static const std::string here = std::string(kPrefix) + machineMark() + '-';
    return here + std::to_string(writer) + '-';
}

void AtomicFile::removeLeftovers(const fs::path& directory, pid_t writer)
{
    std::error_code code, ignored;
    const std::string prefix = temporaryPrefix(writer);
    for (fs::directory_iterator entry(directory, code), end; !code && entry != end; entry.increment(code))
        if (entry->path().filename().string().compare(0, prefix.size(), prefix) == 0)
            fs::remove_all(entry->path(), ignored);
}

void AtomicFile::removeAbandoned(const fs::path& directory)
{
    std::error_code code;
    for (fs::directory_iterator entry(directory, code), end; !code && entry != end; entry.increment(code)) {
        std::error_code trouble;
        if (!isTemporary(entry->path().filename().string()))
            continue;
        const fs::file_time_type written = fs::last_write_time(entry->path(), trouble);
        if (!trouble && fs::file_time_type::clock::now() - written > kAbandonedAge)
            ::unlink(entry->path().c_str());
    }
}

bool AtomicFile::isTemporary(std::string_view fileName)
{
    return fileName.size() > kPrefix.size() + kSuffix.size() && fileName.substr(0, kPrefix.size()) == kPrefix
           && fileName.substr(fileName.size() - kSuffix.size()) == kSuffix;
}

Result<Done> AtomicFile::openTemporary()
{
    const mode_t permissions = permissionsFor(mTarget);
    for (int attempt = 0; attempt < kNameAttempts; ++attempt) {
        const fs::path name = mDirectory / temporaryPrefix(::getpid()).append(std::to_string(attempt)).append(kSuffix);
        mDescriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, permissions);
        if (mDescriptor >= 0) {
            mTemporary = name;
            return Done{};
        }
        if (errno != EEXIST)
            break;
    }
    return failure("cannot be written");
}

Result<Done> AtomicFile::writeAll(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = ::write(mDescriptor, bytes.data(), bytes.size());
        if (count >= 0)
            bytes.remove_prefix(static_cast<std::size_t>(count));
        else if (errno != EINTR)
            return failure("cannot be written");
    }
    if (mDurability == Durability::Synced && ::fsync(mDescriptor) != 0)
        return failure("cannot be written");
    // Some file systems report a full disk only here.
    if (::close(std::exchange(mDescriptor, -1)) != 0)
        return failure("cannot be written");
    return Done{};
}

Result<Done> AtomicFile::linkIntoPlace()
{
    // link() never replaces anything, so that of two writers one loses and learns of it.
    if (::link(mTemporary.c_str(), mTarget.c_str()) == 0)
        return Done{};
    if (errno == EEXIST)
        return pathError(ErrorCode::Io, kIsThere, mTarget);
    if (errno != EPERM && errno != EOPNOTSUPP && errno != ENOSYS)
        return failure("cannot be written");
    // A file system without hard links: look once more, then rename.
    if (auto allowed = checkTarget(mTarget, mExisting); !allowed)
        return allowed.error();
    return renameIntoPlace();
}

Result<Done> AtomicFile::renameIntoPlace()
{
    if (::rename(mTemporary.c_str(), mTarget.c_str()) != 0)
        return failure("cannot be written");
    mTemporary.clear();
    return Done{};
}

Error AtomicFile::failure(const std::string& what) const
{
    return pathError(ErrorCode::Io, what + ": " + std::strerror(errno), mTarget);
}

Result<std::string> readFile(const fs::path& path, std::uintmax_t largest)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        return pathError(errno == ENOENT ? ErrorCode::NotFound : ErrorCode::Io,
                         errno == ENOENT ? "no such file" : std::string("cannot be opened: ") + std::strerror(errno),
                         path);
    struct stat status = {};
    Result<std::string> content = pathError(ErrorCode::Io, "is no regular file", path);
    if (::fstat(descriptor, &status) != 0)
        content = pathError(ErrorCode::Io, std::string("cannot be read: ") + std::strerror(errno), path);
    else if (S_ISDIR(status.st_mode))
        content = pathError(ErrorCode::Io, "is a directory, not a file", path);
    else if (static_cast<std::uintmax_t>(status.st_size) > largest)
        content = tooLarge(path, largest);
    else if (S_ISREG(status.st_mode))
        content = readAll(descriptor, path, static_cast<std::size_t>(status.st_size), largest);
    ::close(descriptor);
    return content;
}

} // namespace lodsmith
