#include <support/Child.h>
#include <support/MeshBuilders.h>
#include <support/TestDirectory.h>

#include <lodsmith/loddef/LoddefXml.h>
#include <lodsmith/ogre/LodDefinitionManager.h>

#include <gmock/gmock.h>

#include <csignal>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith::test {
namespace {

constexpr int kKills = 60;

/// As many levels as make a file of several blocks.
LodDefinition longDefinition(float first)
{
    LodDefinition definition;
    definition.automatic = false;
    for (int i = 0; i < 200; ++i)
        definition.levels.push_back({first + static_cast<float>(i), {LevelTarget::Kind::Triangles, 400}, "", ""});
    return definition;
}

/// Exports one definition after the other until it is killed, and says when it has begun.
bool exportForEver(const fs::path& directory, const LodDefinition& one, const LodDefinition& other, int begun)
{
    for (;;)
        for (const LodDefinition* definition : {&one, &other}) {
            if (!LodDefinitionManager::exportScript("dir/a.mesh", *definition, directory))
                return false;
            ::write(begun, "x", 1);
        }
}

/// A process that exports for ever, has begun to, and is killed some time later.
void killExport(const fs::path& directory, const LodDefinition& one, const LodDefinition& other, useconds_t delay)
{
    int begun[2];
    ASSERT_EQ(::pipe2(begun, O_NONBLOCK), 0); // A pipe that is full holds up nobody.
    const pid_t child = startChild([&] { return exportForEver(directory, one, other, begun[1]); });
    pollfd news = {begun[0], POLLIN, 0};
    EXPECT_EQ(::poll(&news, 1, 60000), 1);
    ::usleep(delay);
    EXPECT_EQ(::kill(child, SIGKILL), 0);
    EXPECT_TRUE(WIFSIGNALED(waitFor(child)));
    ::close(begun[0]);
    ::close(begun[1]);
}

TEST(ExportScriptKillTest, AKillAtAnyMomentLeavesTheOldDefinitionOrTheNewOne)
{
    const TestDirectory directory;
    const LodDefinition one = longDefinition(10.0f), other = longDefinition(1000.0f);
    const std::string oneText = loddefText(one).value(), otherText = loddefText(other).value();
    ASSERT_GT(oneText.size(), 8192u);
    ASSERT_TRUE(LodDefinitionManager::exportScript("dir/a.mesh", one, directory.path()));
    TestRandom random(7);
    std::size_t ones = 0;
    for (int kill = 0; kill < kKills; ++kill) {
        killExport(directory.path(), one, other, random.bits() % 10000);
        const std::string text = contentOf(directory / "dir/a.loddef");
        ASSERT_TRUE(text == oneText || text == otherText) << "kill " << kill << ": " << text.size() << " bytes";
        ones += text == oneText ? 1 : 0;
    }
    EXPECT_GT(ones, 0u);
    EXPECT_LT(ones, std::size_t(kKills));
    // What a child was writing just then is beside it under a temporary name, at most one of each.
    const std::size_t leftovers = directory.files().size() - 1;
    RecordProperty("leftovers", static_cast<int>(leftovers));
    EXPECT_GT(leftovers, 0u) << "no kill came in mid-write";
    EXPECT_LE(leftovers, std::size_t(kKills));
    for (const std::string& name : directory.files())
        EXPECT_TRUE(name == "dir/a.loddef" || name.find("/.lodsmith-") != std::string::npos) << name;
}

} // namespace
} // namespace lodsmith::test
