#include <lodsmith/core/Result.h>

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>

namespace lodsmith {

namespace {

TEST(Result, HoldsAValue)
{
    Result<std::string> result(std::string("seven"));
    EXPECT_TRUE(result.ok());
    EXPECT_TRUE(static_cast<bool>(result));
    EXPECT_EQ(result.value(), "seven");
}

TEST(Result, HoldsAnError)
{
    const Result<int> result(Error{ErrorCode::BadFile, "no mesh in it"});
    EXPECT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::BadFile);
    EXPECT_EQ(result.error().message, "no mesh in it");
}

TEST(Result, TellsAValueFromAnErrorWhenTheValueIsAnError)
{
    const Result<Done> done{Done{}};
    EXPECT_TRUE(done.ok());
}

TEST(Result, GivesAwayWhatCannotBeCopied)
{
    Result<std::unique_ptr<int>> result(std::make_unique<int>(7));
    const std::unique_ptr<int> taken = std::move(result).value();
    ASSERT_NE(taken, nullptr);
    EXPECT_EQ(*taken, 7);
}

TEST(ResultDeathTest, AskingForTheWrongOneAsserts)
{
    const Result<int> bad(Error{ErrorCode::Io, "disk is full"});
    const Result<int> good(7);
    EXPECT_DEATH(static_cast<void>(bad.value()), "Result holds an error");
    EXPECT_DEATH(static_cast<void>(good.error()), "Result holds a value");
}

TEST(Error, IsDescribedWithWhatIsKnown)
{
    Error error{ErrorCode::IndexOutOfRange, "index 9 in a buffer of 4 vertices"};
    EXPECT_EQ(describe(error), "index 9 in a buffer of 4 vertices");
    error.subMesh = 2;
    EXPECT_EQ(describe(error), "submesh 2: index 9 in a buffer of 4 vertices");
    error.item = 0;
    EXPECT_EQ(describe(error), "submesh 2, item 0: index 9 in a buffer of 4 vertices");
    error.file = "tree.mesh";
    EXPECT_EQ(describe(error), "tree.mesh: submesh 2, item 0: index 9 in a buffer of 4 vertices");
    error.line = 12;
    EXPECT_EQ(describe(error), "tree.mesh:12: submesh 2, item 0: index 9 in a buffer of 4 vertices");
}

TEST(Error, EveryCodeHasAWordOfItsOwn)
{
    std::set<std::string> words;
    constexpr int kCodes = static_cast<int>(ErrorCode::OutOfMemory) + 1;
    for (int code = 0; code < kCodes; ++code) {
        const std::string word = toString(static_cast<ErrorCode>(code));
        EXPECT_EQ(word.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos) << word;
        EXPECT_NE(word, "unknown") << code;
        words.insert(word);
    }
    EXPECT_EQ(words.size(), static_cast<std::size_t>(kCodes));
}

} // namespace

} // namespace lodsmith
