#include "BatchRunner.h"

#include "../../src/files/AtomicFile.h"

#include "support/TestDirectory.h"

#include <gmock/gmock.h>

#include <csignal>
#include <fstream>
#include <set>

#include <unistd.h>

namespace lodsmith::cli {

namespace {

using testing::AnyOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

BatchJob job(const std::string& file, ChildWork work)
{
    return {file, 0, {}, std::move(work), {}};
}

/// Outcomes as text, in the order in which they came.
std::vector<std::string> run(const std::vector<BatchJob>& jobs, const BatchOptions& options = {})
{
    std::FILE* nowhere = std::fopen("/dev/null", "w");
    ProgressBar progress(nowhere, jobs.size());
    std::vector<std::string> outcomes;
    BatchRunner(options, progress).run(jobs, [&](std::size_t number, const Result<Json>& outcome) {
        EXPECT_EQ(number, outcomes.size());
        outcomes.push_back(outcome ? outcome.value().dump() : describe(outcome.error()));
    });
    std::fclose(nowhere);
    return outcomes;
}

Result<Json> sleepAndSay(unsigned milliseconds, const char* word)
{
    ::usleep(1000 * milliseconds);
    return Json(word);
}

} // namespace

TEST(BatchRunner, outcomesComeInTheOrderOfTheJobs)
{
    const std::vector<BatchJob> jobs{job("a", [](Progress&) { return sleepAndSay(300, "slow"); }),
                                     job("b", [](Progress&) { return sleepAndSay(0, "fast"); }),
                                     job("c", [](Progress&) { return sleepAndSay(100, "middling"); })};
    for (const unsigned workers : {1u, 2u, 8u})
        EXPECT_THAT(run(jobs, {workers, 60.0}), ElementsAre("\"slow\"", "\"fast\"", "\"middling\"")) << workers;
}

TEST(BatchRunner, aCrashIsAnErrorThatNamesFileAndSignalAndQuotesTheLastWords)
{
    const auto outcomes = run({job("bad.mesh",
                                   [](Progress&) -> Result<Json> {
                                       ::write(STDERR_FILENO, "Assertion `x' failed.\n", 22);
                                       std::abort();
                                   }),
                               job("good.mesh", [](Progress&) { return sleepAndSay(0, "done"); })});
    ASSERT_EQ(outcomes.size(), 2u);
    EXPECT_THAT(outcomes[0],
                testing::AllOf(HasSubstr("bad.mesh: "), HasSubstr("signal 6"), HasSubstr("Assertion `x' failed.")));
    EXPECT_EQ(outcomes[1], "\"done\"");
}

TEST(BatchRunner, aChildThatLeavesWithoutAWordIsAnError)
{
    EXPECT_THAT(run({job("x", [](Progress&) -> Result<Json> { ::_exit(0); })})[0], HasSubstr("no answer"));
    EXPECT_THAT(run({job("x", [](Progress&) -> Result<Json> { ::_exit(3); })})[0], HasSubstr("status 3"));
}

TEST(BatchRunner, aHangEndsAtTheTimeLimit)
{
    const auto hang = [](Progress&) -> Result<Json> {
        for (;;)
            ::pause();
    };
    EXPECT_THAT(run({job("x", hang)}, {1, 0.3})[0], testing::AllOf(HasSubstr("x: "), HasSubstr("0.3 s")));
}

TEST(BatchRunner, memoryIsBounded)
{
#if defined(LODSMITH_SANITIZED)
    GTEST_SKIP() << "sanitizers need more address space than any limit allows";
#else
    const auto greedy = [](Progress&) -> Result<Json> {
        std::vector<std::string> hoard;
        for (;;)
            hoard.emplace_back(std::size_t(1) << 30, 'x');
    };
    EXPECT_THAT(run({job("x", greedy)})[0], HasSubstr("memory"));
#endif
}

TEST(BatchRunner, errorsArriveWhole)
{
    const auto outcomes = run({job("a.mesh", [](Progress&) -> Result<Json> {
        return Error{ErrorCode::IndexOutOfRange, "too high", "b.mesh", -1, 3, 17};
    })});
    EXPECT_EQ(outcomes[0], "b.mesh: submesh 3, item 17: too high");
}

TEST(BatchRunner, exceptionsAreErrors)
{
    EXPECT_EQ(run({job("a.mesh", [](Progress&) -> Result<Json> { throw std::runtime_error("odd"); })})[0],
              "a.mesh: odd");
}

TEST(BatchRunner, longAnswersPassThroughThePipe)
{
    const std::string text(1 << 20, 'x');
    EXPECT_EQ(run({job("a", [&](Progress&) -> Result<Json> { return Json(text); })})[0].size(), text.size() + 2);
}

TEST(BatchRunner, standardOutputOfAChildLeadsNowhere)
{
    testing::internal::CaptureStdout();
    run({job("a", [](Progress&) -> Result<Json> {
        ::write(STDOUT_FILENO, "noise", 5);
        return Json();
    })});
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(BatchRunner, whatIsKnownTakesNoChildAndItsPlaceInTheOrder)
{
    const auto fails = [](Progress&) -> Result<Json> { ::_exit(1); };
    BatchJob known = job("b", fails);
    known.known = [] { return std::optional<Json>("known"); };
    BatchJob unknown = job("c", [](Progress&) { return sleepAndSay(0, "made"); });
    unknown.known = [] { return std::optional<Json>(); };
    EXPECT_THAT(run({job("a", [](Progress&) { return sleepAndSay(100, "slow"); }), known, unknown}, {3, 60.0}),
                ElementsAre("\"slow\"", "\"known\"", "\"made\""));
}

TEST(BatchRunner, whatIsKnownIsAskedWhenItsTurnComes)
{
    const lodsmith::test::TestDirectory directory;
    const BatchJob first = job("a", [&](Progress&) -> Result<Json> {
        directory.write("made", "");
        return Json();
    });
    BatchJob second = job("b", [](Progress&) { return sleepAndSay(0, "made"); });
    second.known = [&] { return directory.files().empty() ? std::nullopt : std::optional<Json>("made by the first"); };
    EXPECT_EQ(run({first, second}).back(), "\"made by the first\"");
}

namespace {

std::set<std::size_t> numbersIn(const lodsmith::test::TestDirectory& directory)
{
    std::set<std::size_t> numbers;
    for (const std::string& file : directory.files())
        numbers.insert(std::stoul(file));
    return numbers;
}

/// Which of the jobs ran beside each, as lists of their numbers, with some memory for all. A job waits until all have begun, but
/// no longer than `patience` milliseconds.
std::vector<std::string> neighboursOf(const std::vector<std::uint64_t>& inputs, std::uint64_t memory, int patience)
{
    const lodsmith::test::TestDirectory running, begun;
    std::vector<BatchJob> jobs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        jobs.push_back(job("x", [&, i](Progress&) -> Result<Json> {
            const std::string name = std::to_string(i);
            // In this order nobody is missed: who is not among the first is among the second, or begins later.
            std::set<std::size_t> before = numbersIn(begun);
            std::set<std::size_t> neighbours = numbersIn(running);
            before.insert(i);
            running.write(name, "");
            begun.write(name, "");
            for (int waited = 0; waited < patience && begun.files().size() < inputs.size(); waited += 10)
                ::usleep(10000);
            for (const std::size_t other : numbersIn(begun))
                if (before.count(other) == 0)
                    neighbours.insert(other);
            std::filesystem::remove(running / name);
            return Json(neighbours);
        }));
        jobs.back().inputBytes = inputs[i];
    }
    return run(jobs, {static_cast<unsigned>(inputs.size()), 60.0, memory});
}

} // namespace

TEST(BatchRunner, whatDoesNotFitBesideTheOthersWaits)
{
    constexpr std::uint64_t kSmall = 1000, kLarge = 1000000000;
    const std::uint64_t small = BatchRunner::memoryNeed(kSmall), large = BatchRunner::memoryNeed(kLarge);
    EXPECT_THAT(neighboursOf({kLarge, kLarge}, large + small, 400), ElementsAre("[]", "[]"));
    EXPECT_THAT(neighboursOf({kLarge, kSmall, kLarge}, large + small, 400),
                ElementsAre(AnyOf("[]", "[1]"), testing::_, AnyOf("[]", "[1]")));
    EXPECT_THAT(neighboursOf({kLarge, kLarge, kSmall}, large + small, 400),
                ElementsAre("[]", AnyOf("[]", "[2]"), AnyOf("[]", "[1]")))
        << "nor does what comes behind overtake it";
    EXPECT_THAT(neighboursOf({kLarge, kLarge}, 1, 400), ElementsAre("[]", "[]")) << "what fits nowhere runs alone";
}

TEST(BatchRunner, whatFitsRunsAtATime)
{
    const std::uint64_t need = BatchRunner::memoryNeed(1000);
    const auto neighbours = neighboursOf({1000, 1000, 1000}, 3 * need, 10000);
    EXPECT_THAT(neighbours, Contains(HasSubstr(","))) << "two beside a third";
    EXPECT_THAT(neighboursOf({1000, 1000, 1000}, 0, 10000), Contains(HasSubstr(","))) << "no bound";
}

TEST(BatchRunner, whatADeadChildLeftIsSwept)
{
    const lodsmith::test::TestDirectory directory;
    BatchJob dying = job("a", [&](Progress&) -> Result<Json> {
        directory.write(AtomicFile::temporaryPrefix(::getpid()) + "0.tmp", "half");
        ::raise(SIGKILL);
        return Json();
    });
    dying.outputDirectories = {directory.path()};
    EXPECT_THAT(run({dying})[0], HasSubstr("signal 9"));
    EXPECT_THAT(directory.files(), IsEmpty());
}

} // namespace lodsmith::cli
