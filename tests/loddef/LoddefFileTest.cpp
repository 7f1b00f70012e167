#include <lodsmith/loddef/LoddefXml.h>

#include "support/TestDirectory.h"

#include <gmock/gmock.h>

#include <clocale>
#include <filesystem>
#include <locale>

namespace lodsmith {

namespace {

using test::contentOf;
using test::TestDirectory;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// As numbers are written in Germany.
class CommaNumbers : public std::numpunct<char> {
protected:
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

/// A locale with decimal commas for C++ streams, and for C where the system has one.
class CommaLocale {
public:
    CommaLocale() : mBefore(std::locale::global(std::locale(std::locale(), new CommaNumbers)))
    {
        for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"})
            if (std::setlocale(LC_ALL, name))
                break;
    }
    ~CommaLocale()
    {
        std::locale::global(mBefore);
        std::setlocale(LC_ALL, "C");
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

private:
    std::locale mBefore;
};

LodDefinition sample()
{
    LodDefinition definition;
    definition.automatic = false;
    definition.weights.uv = 0.1f;
    definition.subMeshes = {{40000, 0.3f}};
    definition.levels = {{1234567.5f, {LevelTarget::Kind::Proportional, 0.1}, "", ""}};
    return definition;
}

} // namespace

TEST(LoddefFile, isWrittenWholeWithItsDirectoriesAndReadAgain)
{
    const TestDirectory directory;
    ASSERT_TRUE(writeLoddefFile(directory / "a/b.loddef", sample()));
    EXPECT_THAT(directory.files(), ElementsAre("a/b.loddef"));
    const LoddefReading reading = readLoddefFile(directory / "a/b.loddef");
    ASSERT_TRUE(reading.ok());
    EXPECT_EQ(*reading.definition, sample());
    EXPECT_EQ(reading.definition->original, contentOf(directory / "a/b.loddef"));
}

TEST(LoddefFile, isReplacedOrLeftAsItWas)
{
    const TestDirectory directory;
    directory.write("a.loddef", "<lod/>");
    LodDefinition broken = sample();
    broken.levels[0].target.amount = 2.0;
    const Result<Done> refused = writeLoddefFile(directory / "a.loddef", broken);
    ASSERT_FALSE(refused);
    EXPECT_THAT(describe(refused.error()), HasSubstr("a.loddef: level 1: "));
    EXPECT_EQ(contentOf(directory / "a.loddef"), "<lod/>");
    ASSERT_TRUE(writeLoddefFile(directory / "a.loddef", sample()));
    EXPECT_EQ(contentOf(directory / "a.loddef"), loddefText(sample()).value());
    EXPECT_THAT(directory.files(), ElementsAre("a.loddef"));
}

TEST(LoddefFile, isNotWrittenWhereItCannotBe)
{
    const TestDirectory directory;
    directory.write("file", "");
    const Result<Done> written = writeLoddefFile(directory / "file/a.loddef", sample());
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::Io);
}

TEST(LoddefFile, errorsNameTheFile)
{
    const TestDirectory directory;
    const std::string path = directory.write("a.loddef", "<lod>\n<automatic enabled='no'/></lod>");
    const LoddefReading wrong = readLoddefFile(path);
    ASSERT_EQ(wrong.errors.size(), 1u);
    EXPECT_THAT(describe(wrong.errors[0]), StartsWith(path + ":2: "));
    const LoddefReading missing = readLoddefFile(directory / "none.loddef");
    ASSERT_EQ(missing.errors.size(), 1u);
    EXPECT_EQ(missing.errors[0].code, ErrorCode::NotFound);
    EXPECT_EQ(missing.errors[0].file, (directory / "none.loddef").string());
    EXPECT_EQ(readLoddefFile(directory.path()).errors.at(0).code, ErrorCode::Io);
}

TEST(LoddefFile, tooLargeAFileIsNotRead)
{
    const TestDirectory directory;
    const std::string path = directory.write("a.loddef", "<lod/>");
    // A hole: of this size only where it is read.
    std::filesystem::resize_file(path, std::uintmax_t(1) << 40);
    const LoddefReading reading = readLoddefFile(path);
    ASSERT_EQ(reading.errors.size(), 1u);
    EXPECT_EQ(reading.errors[0].code, ErrorCode::Io);
    EXPECT_THAT(reading.errors[0].message, HasSubstr("larger than 1048576 bytes"));
}

TEST(LoddefFile, theLocaleDoesNotMatter)
{
    const std::string text = loddefText(sample()).value();
    const CommaLocale commas;
    EXPECT_EQ(loddefText(sample()).value(), text);
    EXPECT_THAT(text, HasSubstr("distance=\"1234567.5\""));
    EXPECT_THAT(text, HasSubstr("index=\"40000\" importance=\"0.3\""));
    const LoddefReading reading = parseLoddef(text, "");
    ASSERT_TRUE(reading.ok());
    EXPECT_EQ(*reading.definition, sample());
    EXPECT_FALSE(parseLoddef("<lod><manual><level distance='0,5'/></manual></lod>", "").ok());
}

} // namespace lodsmith
