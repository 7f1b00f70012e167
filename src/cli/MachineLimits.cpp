#include "MachineLimits.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

#include <sched.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

std::optional<std::uint64_t> numberIn(const fs::path& path)
{
    std::ifstream file(path);
    std::uint64_t number = 0;
    return file >> number ? std::optional(number) : std::nullopt; // "max" is no number
}

/// The number that follows a word in a file.
std::optional<std::uint64_t> numberBehind(const fs::path& path, const std::string& wanted)
{
    std::ifstream file(path);
    std::uint64_t number = 0;
    for (std::string word; file >> word;)
        if (word == wanted && file >> number)
            return number;
    return std::nullopt;
}

std::optional<std::uint64_t> freeBytes(const fs::path& root)
{
    const auto kib = numberBehind(root / "proc/meminfo", "MemAvailable:");
    return kib ? std::optional(1024 * *kib) : std::nullopt;
}

/// The control group of version 2, as a path below its file system; empty when there is none.
std::string controlGroup(const fs::path& root)
{
    std::ifstream file(root / "proc/self/cgroup");
    for (std::string line; std::getline(file, line);)
        if (line.rfind("0::/", 0) == 0)
            return line.substr(4);
    return {};
}

/// What a group holds, without what was read from files and can be dropped.
std::uint64_t usedBytes(const fs::path& group)
{
    const std::uint64_t all = numberIn(group / "memory.current").value_or(0);
    const std::uint64_t files = numberBehind(group / "memory.stat", "inactive_file").value_or(0);
    return all - std::min(files, all);
}

/// What the group and those around it leave: a limit further up binds as well.
std::optional<std::uint64_t> groupBytes(const fs::path& root)
{
    std::optional<std::uint64_t> least;
    const fs::path top = root / "sys/fs/cgroup";
    fs::path group = (top / controlGroup(root)).lexically_normal();
    for (; group.string().size() > top.string().size(); group = group.parent_path())
        if (const auto limit = numberIn(group / "memory.max")) {
            const std::uint64_t used = usedBytes(group);
            least = std::min(least.value_or(*limit), *limit - std::min(used, *limit));
        }
    return least;
}

} // namespace

unsigned usableProcessors()
{
    cpu_set_t processors;
    CPU_ZERO(&processors);
    if (::sched_getaffinity(0, sizeof processors, &processors) != 0)
        return 1;
    return static_cast<unsigned>(std::max(1, CPU_COUNT(&processors)));
}

std::optional<std::uint64_t> availableMemory(const fs::path& root)
{
    const auto free = freeBytes(root), group = groupBytes(root);
    return free && group ? std::min(*free, *group) : free ? free : group;
}

} // namespace lodsmith::cli
