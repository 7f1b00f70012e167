#include <lodsmith/loddef/LoddefFileName.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace lodsmith {

namespace {

/// Few characters, so that everything that can meet does.
rc::Gen<std::string> names()
{
    return rc::gen::container<std::string>(rc::gen::element('a', 'b', '.', '/', '\\'));
}

std::string withoutExtension(const std::string& definition)
{
    return definition.substr(0, definition.size() - std::string(".loddef").size());
}

} // namespace

TEST(LoddefFileName, replacesTheLastExtensionAlone)
{
    EXPECT_EQ(loddefFileName("tree.mesh"), "tree.loddef");
    EXPECT_EQ(loddefFileName("dir/a.b.mesh"), "dir/a.b.loddef");
    EXPECT_EQ(loddefFileName("a."), "a.loddef");
}

TEST(LoddefFileName, appendsWhereThereIsNoExtension)
{
    EXPECT_EQ(loddefFileName("tree"), "tree.loddef");
    EXPECT_EQ(loddefFileName("a.b/c"), "a.b/c.loddef");
    EXPECT_EQ(loddefFileName("a.b\\c"), "a.b\\c.loddef");
    EXPECT_EQ(loddefFileName(".mesh"), ".mesh.loddef");
    EXPECT_EQ(loddefFileName("dir/.mesh"), "dir/.mesh.loddef");
    EXPECT_EQ(loddefFileName("..mesh"), "..mesh.loddef");
    EXPECT_EQ(loddefFileName(".hidden.mesh"), ".hidden.loddef");
}

TEST(LoddefFileName, keepsDirectoriesAsTheyAreWritten)
{
    EXPECT_EQ(loddefFileName("/a/b.mesh"), "/a/b.loddef");
    EXPECT_EQ(loddefFileName("../a//b.mesh"), "../a//b.loddef");
    EXPECT_EQ(loddefFileName("C:\\a\\b.mesh"), "C:\\a\\b.loddef");
    EXPECT_NE(loddefFileName("one/b.mesh"), loddefFileName("two/b.mesh"));
    EXPECT_NE(loddefFileName("a/b.mesh"), loddefFileName("a\\b.mesh"));
}

TEST(LoddefFileName, isEmptyWithoutABaseName)
{
    EXPECT_EQ(loddefFileName(""), "");
    EXPECT_EQ(loddefFileName("dir/"), "");
    EXPECT_EQ(loddefFileName("dir\\"), "");
}

TEST(LoddefFileName, namesThatDifferInTheExtensionAloneShareOne)
{
    EXPECT_EQ(loddefFileName("a.MESH"), loddefFileName("a.mesh"));
    EXPECT_EQ(loddefFileName("a.xml"), loddefFileName("a.mesh"));
    EXPECT_EQ(loddefFileName("a"), loddefFileName("a.mesh"));
    EXPECT_NE(loddefFileName("A.mesh"), loddefFileName("a.mesh"));
    EXPECT_NE(loddefFileName("a.b.mesh"), loddefFileName("a.mesh"));
}

RC_GTEST_PROP(LoddefFileNameProperty, IsTheNameUpToItsLastExtensionAndNoLess, ())
{
    const std::string name = *names();
    const std::string definition = loddefFileName(name);
    const bool hasBase = !name.empty() && name.back() != '/' && name.back() != '\\';
    RC_ASSERT(definition.empty() == !hasBase);
    if (!hasBase)
        return;
    const std::string kept = withoutExtension(definition);
    RC_ASSERT(definition == kept + ".loddef");
    RC_ASSERT(name.compare(0, kept.size(), kept) == 0);
    // What is gone is at most one extension: a dot and what follows, in the base name and not at its front.
    const std::string gone = name.substr(kept.size());
    RC_ASSERT(gone.empty() || (gone[0] == '.' && gone.find_first_of("./\\", 1) == std::string::npos));
    RC_ASSERT(kept.back() != '/' && kept.back() != '\\');
}

RC_GTEST_PROP(LoddefFileNameProperty, IsSharedByNamesThatDifferInTheExtensionAlone, ())
{
    const std::string a = *names(), b = *names();
    if (loddefFileName(a).empty() || loddefFileName(a) != loddefFileName(b))
        return;
    const std::string common = withoutExtension(loddefFileName(a));
    for (const std::string& name : {a, b})
        RC_ASSERT(name.substr(common.size()).find_first_of("/\\") == std::string::npos);
}

} // namespace lodsmith
