#include "PluginSettings.h"

#include "../src/loddef/LoddefWords.h"
#include "../src/loddef/NumberText.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

namespace lodsmith {

namespace {

constexpr std::string_view kBlank = " \t\r";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; // some editors put it before UTF-8

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(kBlank);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// The line without its comment, which a # begins at the front or behind a blank: names and paths may hold one.
std::string_view withoutComment(std::string_view line)
{
    for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
        if (at == 0 || kBlank.find(line[at - 1]) != std::string_view::npos)
            return line.substr(0, at);
    return line;
}

/// One setting after another. What went wrong is what would have been right.
class Reader {
public:
    /// Empty when the line is in order.
    std::string read(std::string_view key, std::string_view value)
    {
        if (const bool isNew = mRead.emplace(key).second; !isNew && key != "group" && key != "name")
            return "'" + std::string(key) + "' has been set above; only group and name may stand more than once";
        if (key == "enabled")
            return readFlag(value, mSettings.policy.enabled);
        if (key == "automatic")
            return readFlag(value, mSettings.policy.automatic);
        if (key == "replace_levels")
            return readFlag(value, mSettings.policy.replaceLevels);
        if (key == "metric")
            return readMetric(value);
        if (key == "levels")
            return readLevels(value);
        if (key == "method")
            return readMethod(value);
        if (key == "pixels")
            return readNumber(value, mSettings.policy.automaticLods.pixels, AutomaticLods::kMinPixels,
                              AutomaticLods::kMaxPixels);
        if (key == "reinitialise_entities")
            return readFlag(value, mSettings.policy.reinitialiseEntities);
        if (key == "min_triangles")
            return readWhole(value, mSettings.policy.minTriangles, std::numeric_limits<std::uint32_t>::max());
        if (key == "group")
            return readName(value, mSettings.policy.groups);
        if (key == "name")
            return readName(value, mSettings.policy.names);
        if (key == "workers")
            return readWhole(value, mSettings.queue.workers, 256u);
        if (key == "memory_mib")
            return readMebibytes(value, mSettings.queue.memoryLimit);
        if (key == "frame_ms")
            return readBudget(value);
        if (key == "cache_mib")
            return readMebibytes(value, mSettings.cacheLimit);
        if (key == "cache_directory")
            return readPath(value, mSettings.cacheDirectory);
        return "'" + std::string(key)
               + "' is no setting; there are enabled, automatic, method, pixels, levels, metric, replace_levels, "
                 "reinitialise_entities, min_triangles, group, name, workers, memory_mib, frame_ms, cache_mib and "
                 "cache_directory";
    }

    PluginSettings settings() const { return mSettings; }

private:
    static std::string refuse(std::string_view value, const std::string& allowed)
    {
        return "'" + std::string(value) + "' has to be " + allowed;
    }

    static std::string readFlag(std::string_view value, bool& flag)
    {
        flag = value == "yes";
        return flag || value == "no" ? "" : refuse(value, "yes or no");
    }

    template <class T>
    static std::string readWhole(std::string_view value, T& number, T most)
    {
        const auto read = plainNumberFromText<T>(value);
        number = read.value_or(T(0));
        return read && *read <= most ? "" : refuse(value, "a whole number from 0 to " + std::to_string(most));
    }

    static std::string readName(std::string_view value, std::vector<Ogre::String>& names)
    {
        names.emplace_back(value);
        return value.empty() ? "a name is missing" : "";
    }

    static std::string readNumber(std::string_view value, double& number, double least, double most)
    {
        const auto read = plainNumberFromText<double>(value);
        number = read.value_or(least);
        std::ostringstream allowed;
        allowed << "a number from " << least << " to " << most;
        return read && *read >= least && *read <= most ? "" : refuse(value, allowed.str());
    }

    std::string readMetric(std::string_view value)
    {
        const Metric* metric = meaningOf(kMetrics, value);
        if (!metric)
            return refuse(value, "quadric or curvature");
        mSettings.policy.automaticLods.metric = *metric;
        return "";
    }

    std::string readMethod(std::string_view value)
    {
        const bool isClassic = value == "classic";
        if (isClassic)
            mSettings.policy.automaticLods.method = AutomaticLods::Method::Classic;
        return isClassic || value == "balanced" ? "" : refuse(value, "balanced or classic");
    }

    std::string readLevels(std::string_view value)
    {
        unsigned levels = 0;
        const std::string trouble = readWhole(value, levels, AutomaticLods::kMaxLevels);
        mSettings.policy.automaticLods.levels = levels;
        return trouble.empty() && levels == 0 ? refuse(value, "at least 1; automatic=no switches automatic levels off")
                                              : trouble;
    }

    static std::string readPath(std::string_view value, std::string& path)
    {
        path = value;
        return value.empty() ? "a path is missing" : "";
    }

    template <class T>
    static std::string readMebibytes(std::string_view value, T& bytes)
    {
        std::string trouble = readWhole<T>(value, bytes, T(1) << 20);
        bytes <<= 20;
        return trouble;
    }

    std::string readBudget(std::string_view value)
    {
        double milliseconds = 0.0;
        std::string trouble = readNumber(value, milliseconds, 0.0, 1000.0);
        mSettings.queue.frameBudget = PMInjector::Milliseconds(milliseconds);
        return trouble;
    }

    PluginSettings mSettings;
    std::set<std::string> mRead;
};

} // namespace

Result<PluginSettings> parsePluginSettings(std::string_view text, const std::string& fileName)
{
    Reader reader;
    if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark)
        text.remove_prefix(kByteOrderMark.size());
    for (int line = 1; !text.empty(); ++line) {
        const std::size_t end = text.find('\n');
        const std::string_view content = trimmed(withoutComment(text.substr(0, end)));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (content.empty())
            continue;
        const std::size_t equals = content.find('=');
        const std::string trouble =
            equals == std::string_view::npos
                ? "'" + std::string(content) + "' has to be key=value"
                : reader.read(trimmed(content.substr(0, equals)), trimmed(content.substr(equals + 1)));
        if (!trouble.empty())
            return Error{ErrorCode::BadFile, trouble, fileName, line};
    }
    return reader.settings();
}

} // namespace lodsmith
