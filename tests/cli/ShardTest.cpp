#include "Shard.h"

#include "CommandLine.h"
#include "SampleFiles.h"

#include <gmock/gmock.h>

#include <set>

namespace lodsmith::cli {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::TestDirectory;
using test::Outcome;
using test::runLodsmith;
using testing::HasSubstr;
using testing::IsEmpty;

// Of nothing at all, as the specification of XXH3 states it.
constexpr std::uint64_t kHashOfNothing = 0x2d06800538d394c2;

/// The report without what differs from run to run.
std::vector<nlohmann::json> withoutTimes(const Outcome& outcome)
{
    std::vector<nlohmann::json> records = outcome.records();
    for (nlohmann::json& record : records)
        for (const char* member : {"up_to_date", "cached", "read_ms", "generate_ms", "generate_min_ms", "order_ms",
                                   "foliage_ms", "write_ms", "peak_kb", "output"})
            record.erase(member);
    return records;
}

} // namespace

TEST(Shard, everyNameIsInExactlyOne)
{
    for (const unsigned count : {1u, 2u, 3u, 7u, 64u}) {
        std::vector<unsigned> sizes(count);
        for (unsigned i = 0; i < 2000; ++i) {
            const std::string name = "models/" + std::to_string(i) + ".mesh";
            unsigned owners = 0;
            for (unsigned index = 1; index <= count; ++index)
                if (Shard{index, count}.contains(name)) {
                    ++owners;
                    ++sizes[index - 1];
                }
            EXPECT_EQ(owners, 1u) << name << ", " << count;
        }
        for (const unsigned size : sizes)
            EXPECT_NEAR(size, 2000.0 / count, 5.0 * std::sqrt(2000.0 / count)) << count;
    }
}

TEST(Shard, isTheSameOnEveryMachine)
{
    for (unsigned count = 1; count < 100; ++count)
        EXPECT_TRUE((Shard{static_cast<unsigned>(kHashOfNothing % count) + 1, count}.contains(""))) << count;
}

TEST(Shard, isParsedStrictly)
{
    ASSERT_TRUE(parseShard("2/8"));
    EXPECT_EQ(parseShard("2/8").value().index, 2u);
    EXPECT_EQ(parseShard("2/8").value().count, 8u);
    EXPECT_TRUE(parseShard("100000/100000"));
    for (const char* text : {"", "/", "1", "1/", "/1", "0/1", "2/1", "1/0", "-1/2", "1/2/3", "1 / 2", "+1/2", "1/2x",
                             "1.0/2", "1/100001", "4294967297/4294967298"})
        EXPECT_FALSE(parseShard(text)) << text;
}

TEST(Shard, theShardsOfADirectoryMakeWhatOneRunMakes)
{
    const TestDirectory directory;
    for (unsigned i = 0; i < 11; ++i)
        directory.write("in/" + std::to_string(i % 3) + "/" + std::to_string(i) + ".mesh", test::torusMesh(6 + i));
    const auto generate = [&](const std::string& output, std::vector<std::string> more) {
        more.insert(more.begin(), {"generate", (directory / "in").string(), (directory / "gone.mesh").string(), "-o",
                                   (directory / output).string(), "--json"});
        return runLodsmith(more);
    };
    const Outcome whole = generate("whole", {});
    std::set<std::string> inputs;
    std::size_t sum = 0;
    for (const char* shard : {"1/4", "2/4", "3/4", "4/4"})
        for (const nlohmann::json& record : generate("shards", {"--shard", shard}).records()) {
            inputs.insert(record["input"]);
            ++sum;
        }
    EXPECT_EQ(sum, 12u) << "also what is not there is told by one of them";
    EXPECT_EQ(inputs.size(), sum);

    for (const std::string& name : directory.files()) {
        const std::string counterpart = name.rfind("whole/", 0) == 0 ? "shards" + name.substr(5) : name;
        EXPECT_TRUE(contentOf(directory / name) == contentOf(directory / counterpart)) << name;
    }
    const Outcome merged = generate("shards", {});
    EXPECT_THAT(merged.err, HasSubstr("0 made, 11 up to date, 1 failed"));
    EXPECT_EQ(withoutTimes(merged), withoutTimes(whole));
}

TEST(Shard, oneWithoutFilesIsDone)
{
    const TestDirectory directory;
    directory.write("in/a.mesh", test::torusMesh(6));
    unsigned reports = 0;
    for (const char* shard : {"1/3", "2/3", "3/3"}) {
        const Outcome outcome = runLodsmith(
            {"generate", (directory / "in").string(), "-o", (directory / "out").string(), "--json", "--shard", shard});
        EXPECT_EQ(outcome.exitCode, 0);
        reports += static_cast<unsigned>(outcome.records().size());
    }
    EXPECT_EQ(reports, 1u);
}

TEST(Shard, aWrongOneIsAnErrorOfTheCommandLine)
{
    const Outcome outcome = runLodsmith({"generate", "in", "-o", "out", "--shard", "3/2"});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--shard: '3/2' is no I/N"));
}

} // namespace lodsmith::cli
