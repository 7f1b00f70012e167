#include <lodsmith/loddef/LoddefXml.h>

#include <gmock/gmock.h>

#include <string>

namespace lodsmith {

namespace {

using testing::HasSubstr;

std::string repeated(const std::string& text, std::size_t count)
{
    std::string all;
    all.reserve(text.size() * count);
    for (std::size_t i = 0; i < count; ++i)
        all += text;
    return all;
}

std::string lod(const std::string& content)
{
    return "<lod>\n" + content + "</lod>";
}

/// The first error of a text that has one, "" otherwise.
std::string firstError(const std::string& text)
{
    const LoddefReading reading = parseLoddef(text, "a.loddef");
    return reading.errors.empty() ? "" : describe(reading.errors.front());
}

} // namespace

TEST(LoddefHostile, documentTypesAndEntitiesAreRefused)
{
    EXPECT_THAT(firstError("<!DOCTYPE lod [<!ENTITY a \"b\">]>\n<lod/>"), HasSubstr("a.loddef:1: '<!'"));
    EXPECT_THAT(firstError("\n<!DOCTYPE lod SYSTEM \"file:///etc/passwd\"><lod/>"), HasSubstr("a.loddef:2: '<!'"));
    EXPECT_THAT(firstError(lod("<!ELEMENT a>")), HasSubstr("a.loddef:2: '<!'"));
    EXPECT_THAT(firstError(lod("<note>&a;</note>")), HasSubstr("a.loddef:2: '&' begins no reference"));
    EXPECT_THAT(firstError(lod("<note a='x&a;'/>")), HasSubstr("a.loddef:2: '&' begins no reference"));
    EXPECT_THAT(firstError(lod("<note>a & b</note>")), HasSubstr("&amp;"));
    for (const std::string text : {"<note>&amp;&lt;&gt;&quot;&apos;&#233;&#x1f332;</note>", "<!-- &a; <!DOCTYPE> -->",
                                   "<note><![CDATA[&a;<!DOCTYPE>]]></note>", "<note a='-->' b=\"it's &lt;\"/>"})
        EXPECT_EQ(firstError(lod(text)), "");
}

TEST(LoddefHostile, charactersThatXmlHasNotAreRefused)
{
    const auto level = [](const std::string& name) {
        return lod("<manual><level distance='1'><meshName>a" + name + "b</meshName></level></manual>");
    };
    for (const std::string& bytes :
         {std::string(1, '\0'), std::string("\x01"), std::string("\x1b[2J"), std::string("\xff"),
          std::string("\xc0\x80"), std::string("\xed\xa0\x80"), std::string("\xf4\x90\x80\x80"),
          std::string("\xe2\x82"), std::string("\xef\xbf\xbf")})
        EXPECT_THAT(firstError(level(bytes)), HasSubstr("a.loddef:2: the byte "));
    for (const std::string reference : {"&#0;", "&#x0;", "&#1;", "&#13;", "&#xd800;", "&#x110000;", "&#99999999999;",
                                        "&#xffff;", "&#;", "&#x;", "&#-5;", "&#xg;"})
        EXPECT_THAT(firstError(level(reference)), HasSubstr("a.loddef:2: '&")) << reference;
    EXPECT_EQ(firstError(level("\xf0\x9f\x8c\xb2")), "");
    EXPECT_THAT(firstError(std::string("\xff\xfe<\0l\0o\0d\0/\0>\0", 14)), HasSubstr("UTF-8"));
}

TEST(LoddefHostile, depthIsLimited)
{
    EXPECT_EQ(firstError(lod(repeated("<a>", 90) + repeated("</a>", 90))), "");
    EXPECT_THAT(firstError(lod(repeated("<a>", 110) + repeated("</a>", 110))), HasSubstr("nest deeper"));
    EXPECT_THAT(firstError(repeated("<lod>", 200000)), HasSubstr("nest deeper"));
}

TEST(LoddefHostile, sizeIsLimited)
{
    EXPECT_EQ(firstError(lod("<!--" + std::string(kMaxLoddefBytes - 30, ' ') + "-->")), "");
    EXPECT_THAT(firstError(lod("<!--" + std::string(kMaxLoddefBytes, ' ') + "-->")), HasSubstr("larger than 1048576"));
}

TEST(LoddefHostile, levelsAreLimited)
{
    std::string levels;
    for (std::size_t i = 1; i <= kMaxLoddefLevels; ++i)
        levels += "<level distance='" + std::to_string(i) + "'/>\n";
    EXPECT_EQ(firstError(lod("<manual>\n" + levels + "</manual>")), "");
    const LoddefReading reading =
        parseLoddef(lod("<manual>\n" + levels + repeated("<level distance='x'/>\n", 1000) + "</manual>"), "a.loddef");
    ASSERT_EQ(reading.errors.size(), 1u);
    EXPECT_EQ(reading.errors[0].line, 3 + static_cast<int>(kMaxLoddefLevels));
    EXPECT_THAT(reading.errors[0].message, HasSubstr("256"));
}

TEST(LoddefHostile, attributesAreLimited)
{
    const auto element = [](int attributes) {
        std::string text = "<a";
        for (int i = 0; i < attributes; ++i)
            text += "\nb" + std::to_string(i) + "=''";
        return lod("<a c=''/>" + text + "/>");
    };
    EXPECT_EQ(firstError(element(100)), "");
    EXPECT_THAT(firstError(element(60000)),
                HasSubstr("a.loddef:103: an element has more attributes than are allowed: 100"));
}

TEST(LoddefHostile, errorsAndWarningsAreLimited)
{
    const LoddefReading errors = parseLoddef(lod(repeated("text<a/>\n", 50000)), "a.loddef");
    ASSERT_EQ(errors.errors.size(), kMaxLoddefErrors);
    ASSERT_EQ(errors.warnings.size(), kMaxLoddefErrors);
    EXPECT_EQ(errors.errors[0].line, 2);
    EXPECT_THAT(errors.errors.back().message, HasSubstr("more errors"));
    EXPECT_THAT(errors.warnings.back().message, HasSubstr("more warnings"));
    EXPECT_EQ(parseLoddef(lod(repeated("text<a/>\n", kMaxLoddefErrors)), "").errors.back().message.substr(0, 8),
              "the text");
}

TEST(LoddefHostile, whatIsManyCostsNoMoreThanItsSize)
{
    EXPECT_EQ(firstError(lod(repeated("<a/>", 200000))), "");
    EXPECT_NE(firstError(lod(repeated("<![CDATA[", 100000))), "");
    EXPECT_NE(firstError(lod(repeated("<!--", 200000))), "");
    EXPECT_NE(firstError(lod(repeated("&amp", 200000))), "");
    std::string subMeshes;
    for (int i = 0; i < 20000; ++i)
        subMeshes += "<subMesh index='" + std::to_string(i) + "' importance='1'/>";
    const LoddefReading many = parseLoddef(lod("<manual>" + subMeshes + "</manual>"), "");
    ASSERT_TRUE(many.ok());
    EXPECT_TRUE(loddefText(*many.definition).ok());
}

} // namespace lodsmith
