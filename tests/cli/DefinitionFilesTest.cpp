#include "DefinitionFiles.h"

#include "support/TestDirectory.h"

#include <gmock/gmock.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

using lodsmith::test::TestDirectory;
using testing::ElementsAre;
using testing::HasSubstr;

std::string handMade(const std::string& name)
{
    return "<lod><automatic enabled='false'/><manual><level distance='50'><meshName>" + name
           + "</meshName></level></manual></lod>";
}

class DefinitionFilesTest : public testing::Test {
protected:
    std::string in(const std::string& name) const { return (mDirectory / name).string(); }

    /// The inputs that are left, relative to the test's directory.
    std::vector<std::string> left(const std::vector<std::string>& inputs, const DefinitionChoice& choice = {}) const
    {
        std::vector<PlannedFile> plan;
        for (const std::string& input : inputs) {
            mDirectory.write(input, "");
            plan.push_back({mDirectory / input, mDirectory / "out" / input, std::nullopt});
        }
        std::vector<std::string> names;
        for (const PlannedFile& file : withoutHandMade(plan, choice))
            names.push_back(file.input.lexically_relative(mDirectory.path()).string());
        return names;
    }

    TestDirectory mDirectory;
};

} // namespace

TEST_F(DefinitionFilesTest, theDefinitionLiesBesideTheMesh)
{
    mDirectory.write("a.b/tree.x.loddef", "");
    EXPECT_EQ(definitionBeside(in("a.b/tree.x.mesh")), fs::path(in("a.b/tree.x.loddef")));
    EXPECT_FALSE(definitionBeside(in("a.b/tree.mesh")));
    EXPECT_FALSE(definitionBeside(in("a.b/")));
    fs::create_symlink("nowhere", mDirectory / "link.loddef");
    EXPECT_TRUE(definitionBeside(in("link.mesh"))) << "never passed over without a word";
}

TEST_F(DefinitionFilesTest, oneThatIsGivenGoesFirst)
{
    mDirectory.write("tree.loddef", "");
    EXPECT_EQ(chosenDefinition({}, in("tree.mesh")), fs::path(in("tree.loddef")));
    EXPECT_EQ(chosenDefinition({"far.loddef", true, false}, in("tree.mesh")), fs::path("far.loddef"));
    EXPECT_FALSE(chosenDefinition({"", false, false}, in("tree.mesh")));
    EXPECT_FALSE(chosenDefinition({"", true, true}, in("tree.mesh")));
}

TEST_F(DefinitionFilesTest, handMadeLevelsAreBesideTheMeshThenTheDefinition)
{
    const fs::path mesh = in("meshes/tree.mesh"), definition = in("definitions/far.loddef");
    mDirectory.write("meshes/box.mesh", "");
    mDirectory.write("definitions/box.mesh", "");
    mDirectory.write("definitions/lods/flat.mesh", "");
    EXPECT_EQ(findHandMade("box.mesh", mesh, definition).value(), in("meshes/box.mesh"));
    EXPECT_EQ(findHandMade("lods/flat.mesh", mesh, definition).value(), in("definitions/lods/flat.mesh"));
    const auto missing = findHandMade("gone.mesh", mesh, definition);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
    EXPECT_EQ(missing.error().file, definition.string());
    EXPECT_THAT(missing.error().message, HasSubstr("'gone.mesh'"));
    for (const std::string& outside : {std::string("../meshes/box.mesh"), in("meshes/box.mesh")}) {
        const auto refused = findHandMade(outside, mesh, definition);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::InvalidSetting);
    }
}

TEST_F(DefinitionFilesTest, handMadeLevelsAmongTheInputsGoAlong)
{
    mDirectory.write("tree.loddef", handMade("tree-far.mesh"));
    EXPECT_THAT(left({"tree-far.mesh", "tree.mesh", "other.mesh"}), ElementsAre("tree.mesh", "other.mesh"));
    EXPECT_THAT(left({"tree-far.mesh", "tree.mesh"}, {"", false, false}), ElementsAre("tree-far.mesh", "tree.mesh"));
    EXPECT_THAT(left({"tree-far.mesh", "tree.mesh"}, {"", true, true}), ElementsAre("tree-far.mesh", "tree.mesh"));
}

TEST_F(DefinitionFilesTest, noInputIsLostToDefinitionsThatAreWrong)
{
    mDirectory.write("a.loddef", handMade("a.mesh"));
    mDirectory.write("b.loddef", handMade("c.mesh"));
    mDirectory.write("c.loddef", handMade("b.mesh"));
    mDirectory.write("d.loddef", "<lod><manual><level distance='5'><meshName>e.mesh</meshName></level></manual></lod>");
    mDirectory.write("f.loddef", "<lod");
    EXPECT_THAT(left({"a.mesh", "b.mesh", "c.mesh", "d.mesh", "e.mesh", "f.mesh"}),
                ElementsAre("a.mesh", "b.mesh", "d.mesh", "e.mesh", "f.mesh"));
}

} // namespace lodsmith::cli
