#include "Provenance.h"

#include <Revision.h>

#include <cmath>
#include <fstream>
#include <thread>

#include <sys/utsname.h>
#include <unistd.h>

namespace lodsmith::benchmarks {

namespace {

/// The value of the first line of a file that begins with `key`, as "model name : value".
std::string valueOf(const std::string& path, const std::string& key)
{
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
        if (line.rfind(key, 0) == 0)
            if (const std::size_t colon = line.find(": "); colon != std::string::npos)
                return line.substr(colon + 2);
    return "unknown";
}

std::string kernel()
{
    utsname names{};
    return uname(&names) == 0 ? std::string(names.sysname) + ' ' + names.release : "unknown";
}

} // namespace

Machine thisMachine()
{
    const double bytes = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
    constexpr double kGib = 1024.0 * 1024.0 * 1024.0;
    return {valueOf("/proc/cpuinfo", "model name"), std::thread::hardware_concurrency(),
            std::round(10.0 * bytes / kGib) / 10.0, kernel()};
}

Build thisBuild(const std::string& label)
{
    const std::string version = LODSMITH_VERSION, revision = LODSMITH_REVISION;
    const std::string name = revision.empty() ? version : version + '-' + revision;
    return {label.empty() ? name : label, version, revision, LODSMITH_COMPILER, LODSMITH_BUILD_TYPE};
}

} // namespace lodsmith::benchmarks
