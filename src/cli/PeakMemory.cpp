#include "PeakMemory.h"

#include <algorithm>
#include <fstream>
#include <string>

#include <malloc.h>

namespace lodsmith::cli {

namespace {

std::optional<std::int64_t> statusKb(const std::string& name)
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        std::int64_t value = 0;
        if (word == name + ":" && status >> value)
            return value;
    }
    return std::nullopt;
}

bool resetHighWaterMark()
{
    std::ofstream control("/proc/self/clear_refs");
    control << '5' << std::flush;
    return control.good();
}

} // namespace

PeakMemory::PeakMemory()
{
    ::malloc_trim(0);
    if (resetHighWaterMark())
        mBefore = statusKb("VmRSS");
}

std::optional<std::int64_t> PeakMemory::growthKb() const
{
    const std::optional<std::int64_t> peak = mBefore ? statusKb("VmHWM") : std::nullopt;
    if (!peak)
        return std::nullopt;
    return std::max<std::int64_t>(*peak - *mBefore, 0);
}

} // namespace lodsmith::cli
