#include "PluginSettings.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

namespace lodsmith {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

PluginSettings settingsOf(const std::string& text)
{
    const Result<PluginSettings> settings = parsePluginSettings(text, "lodsmith.cfg");
    EXPECT_TRUE(settings.ok()) << describe(settings.error());
    return settings.ok() ? settings.value() : PluginSettings();
}

TEST(PluginSettings, OfAnEmptyFileAreTheDefaults)
{
    for (const char* text : {"", "\xEF\xBB\xBF", "\n\n", "# nothing\r\n \t \n#"}) {
        const PluginSettings settings = settingsOf(text);
        EXPECT_TRUE(settings.policy.enabled);
        EXPECT_EQ(settings.policy.minTriangles, LodPolicy().minTriangles);
        EXPECT_EQ(settings.queue.memoryLimit, QueueOptions().memoryLimit);
    }
}

TEST(PluginSettings, AreAllRead)
{
    const PluginSettings settings =
        settingsOf("enabled=no\nautomatic = no # by hand\r\n\treplace_levels=yes\nmin_triangles=1234\ngroup=General\n"
                   "metric=quadric\nlevels=6\nmethod=classic\npixels=0.5\nreinitialise_entities=yes\ngroup=My "
                   "props\nname=*tree*\nworkers=3\nmemory_mib=64\nframe_ms=0.5\n"
                   "cache_mib=8000\ncache_directory=../my cache");
    EXPECT_FALSE(settings.policy.enabled);
    EXPECT_FALSE(settings.policy.automatic);
    EXPECT_TRUE(settings.policy.replaceLevels);
    EXPECT_EQ(settings.policy.minTriangles, 1234u);
    EXPECT_EQ(settings.policy.automaticLods.metric, Metric::Quadric);
    EXPECT_EQ(settings.policy.automaticLods.levels, 6u);
    EXPECT_EQ(settings.policy.automaticLods.method, AutomaticLods::Method::Classic);
    EXPECT_EQ(settings.policy.automaticLods.pixels, 0.5);
    EXPECT_TRUE(settings.policy.reinitialiseEntities);
    EXPECT_THAT(settings.policy.groups, ElementsAre("General", "My props"));
    EXPECT_THAT(settings.policy.names, ElementsAre("*tree*"));
    EXPECT_EQ(settings.queue.workers, 3u);
    EXPECT_EQ(settings.queue.memoryLimit, std::size_t(64) << 20);
    EXPECT_EQ(settings.queue.frameBudget.count(), 0.5);
    EXPECT_EQ(settings.cacheLimit, std::uint64_t(8000) << 20);
    EXPECT_EQ(settings.cacheDirectory, "../my cache");
}

TEST(PluginSettings, TheSampleHasTheDefaults)
{
    std::ifstream file(LODSMITH_SAMPLE_SETTINGS);
    const PluginSettings settings = settingsOf({std::istreambuf_iterator<char>(file), {}}), none = settingsOf("");
    ASSERT_TRUE(file.is_open());
    EXPECT_EQ(settings.policy.enabled, none.policy.enabled);
    EXPECT_EQ(settings.policy.automatic, none.policy.automatic);
    EXPECT_EQ(settings.policy.replaceLevels, none.policy.replaceLevels);
    EXPECT_EQ(settings.policy.minTriangles, none.policy.minTriangles);
    EXPECT_EQ(settings.policy.automaticLods.metric, none.policy.automaticLods.metric);
    EXPECT_EQ(settings.policy.automaticLods.levels, none.policy.automaticLods.levels);
    EXPECT_EQ(settings.policy.automaticLods.method, none.policy.automaticLods.method);
    EXPECT_EQ(settings.policy.automaticLods.pixels, none.policy.automaticLods.pixels);
    EXPECT_EQ(settings.policy.reinitialiseEntities, none.policy.reinitialiseEntities);
    EXPECT_THAT(settings.policy.groups, IsEmpty());
    EXPECT_THAT(settings.policy.names, IsEmpty());
    EXPECT_EQ(settings.queue.workers, none.queue.workers);
    EXPECT_EQ(settings.queue.memoryLimit, none.queue.memoryLimit);
    EXPECT_EQ(settings.queue.frameBudget, none.queue.frameBudget);
    EXPECT_EQ(settings.cacheLimit, none.cacheLimit);
    EXPECT_EQ(settings.cacheDirectory, none.cacheDirectory);
}

TEST(PluginSettings, WhatIsWrongIsNamedWithItsLine)
{
    const auto errorOf = [](const std::string& line) {
        const Result<PluginSettings> settings =
            parsePluginSettings("group=a\nautomatic=yes\n" + line + "\n", "a/lodsmith.cfg");
        return settings.ok() ? "none" : describe(settings.error());
    };
    EXPECT_THAT(errorOf("enabeld=yes"), HasSubstr("a/lodsmith.cfg:3: 'enabeld' is no setting; there are enabled"));
    EXPECT_THAT(errorOf("enabled"), HasSubstr("'enabled' has to be key=value"));
    EXPECT_THAT(errorOf("enabled=true"), HasSubstr("'true' has to be yes or no"));
    EXPECT_THAT(errorOf("min_triangles=-1"), HasSubstr("a whole number from 0"));
    EXPECT_THAT(errorOf("min_triangles=12,5"), HasSubstr("'12,5' has to be"));
    EXPECT_THAT(errorOf("workers=257"), HasSubstr("from 0 to 256"));
    EXPECT_THAT(errorOf("memory_mib=99999999999999999999"), HasSubstr("a whole number"));
    EXPECT_THAT(errorOf("memory_mib=1048577"), HasSubstr("from 0 to 1048576"));
    EXPECT_THAT(errorOf("frame_ms=nan"), HasSubstr("a number from 0 to 1000"));
    EXPECT_THAT(errorOf("metric=Quadric"), HasSubstr("'Quadric' has to be quadric or curvature"));
    EXPECT_THAT(errorOf("levels=9"), HasSubstr("from 0 to 8"));
    EXPECT_THAT(errorOf("levels=0"), HasSubstr("at least 1"));
    EXPECT_THAT(errorOf("pixels=0.09"), HasSubstr("'0.09' has to be a number from 0.1 to 10"));
    EXPECT_THAT(errorOf("pixels=11"), HasSubstr("a number from 0.1 to 10"));
    EXPECT_THAT(errorOf("pixels=few"), HasSubstr("a number from 0.1 to 10"));
    EXPECT_THAT(errorOf("method=best"), HasSubstr("'best' has to be balanced or classic"));
    EXPECT_THAT(errorOf("group="), HasSubstr("a name is missing"));
    EXPECT_THAT(errorOf("cache_mib=1048577"), HasSubstr("from 0 to 1048576"));
    EXPECT_THAT(errorOf("cache_directory="), HasSubstr("a path is missing"));
    EXPECT_THAT(errorOf("automatic=yes"), HasSubstr("a/lodsmith.cfg:3: 'automatic' has been set above"));
}

TEST(PluginSettings, ACommentBeginsBehindABlank)
{
    const PluginSettings settings =
        settingsOf("cache_directory=/data/#1 # of two\nname=a#b*\t#c\n #group=General\n#name=d");
    EXPECT_EQ(settings.cacheDirectory, "/data/#1");
    EXPECT_THAT(settings.policy.names, ElementsAre("a#b*"));
    EXPECT_THAT(settings.policy.groups, IsEmpty());
}

} // namespace
} // namespace lodsmith
