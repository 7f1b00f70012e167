#include <MeshProbe.h>

#include <support/TestDirectory.h>

#include <gmock/gmock.h>

#include <fstream>

namespace fs = std::filesystem;

namespace lodsmith::editor {
namespace {

using testing::HasSubstr;

class MeshProbeTest : public testing::Test {
protected:
    fs::path file(const std::string& name, const std::string& content)
    {
        std::ofstream(mDirectory / name, std::ios::binary) << content;
        return mDirectory / name;
    }

    test::TestDirectory mDirectory;
    std::unique_ptr<MeshProbe> mProbe = MeshProbe::start().value();
    std::string mGood = test::contentOf(LODSMITH_MEDIA_DIR "/drake/drake.mesh");
};

TEST_F(MeshProbeTest, FindsNothingWrongWithAGoodMesh)
{
    EXPECT_TRUE(mProbe->check(LODSMITH_MEDIA_DIR "/drake/drake.mesh"));
    EXPECT_TRUE(mProbe->check(LODSMITH_MEDIA_DIR "/tree/tree.mesh"));
}

TEST_F(MeshProbeTest, SaysWhatIsWrongAndLivesOn)
{
    for (const std::string& content : {std::string(), std::string("text, no mesh"), mGood.substr(0, 40),
                                       mGood.substr(0, mGood.size() / 2), mGood.substr(0, mGood.size() - 3)}) {
        const auto checked = mProbe->check(file("broken.mesh", content));
        ASSERT_FALSE(checked) << content.size() << " bytes";
        EXPECT_THAT(describe(checked.error()), HasSubstr("broken.mesh")) << content.size() << " bytes";
    }
    const auto missing = mProbe->check(mDirectory / "missing.mesh");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
    EXPECT_FALSE(mProbe->check(mDirectory.path()));
    EXPECT_TRUE(mProbe->check(file("good.mesh", mGood)));
}

TEST_F(MeshProbeTest, RefusesBonesThatTheSkeletonDoesNotHave)
{
    fs::copy(LODSMITH_MEDIA_DIR "/drake/drake.skeleton", mDirectory.path());
    ASSERT_TRUE(mProbe->check(file("drake.mesh", mGood)));
    // A chunk of a bone assignment: M_MESH_BONE_ASSIGNMENT, 16 bytes, a vertex, a bone and a weight.
    std::string other = mGood;
    const std::string chunk("\0\x70\x10\0\0\0", 6);
    const std::size_t at = other.find(chunk);
    ASSERT_NE(at, std::string::npos);
    other[at + chunk.size() + 5] = '\x7f';
    const auto checked = mProbe->check(file("drake.mesh", other));
    ASSERT_FALSE(checked);
    EXPECT_THAT(describe(checked.error()), HasSubstr("the skeleton has 24"));
}

TEST_F(MeshProbeTest, SurvivesWhateverABrokenByteDoesToOgre)
{
    // Chunk sizes, counts and types, each in turn.
    for (std::size_t at = 30; at < 400; at += 7) {
        std::string spoilt = mGood;
        spoilt[at] = char(spoilt[at] ^ 0xff);
        (void)mProbe->check(file("spoilt.mesh", spoilt));
    }
    EXPECT_TRUE(mProbe->check(file("good.mesh", mGood)));
}

} // namespace
} // namespace lodsmith::editor
