#include <lodsmith/loddef/LoddefXml.h>

#include "support/TestDirectory.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace lodsmith {

namespace {

using test::contentOf;
using test::TestDirectory;

/// What the schema says of a text, with xmllint.
class LoddefSchema : public testing::Test {
protected:
    void SetUp() override
    {
        if (std::string(LODSMITH_XMLLINT).empty())
            GTEST_SKIP() << "xmllint is not installed";
    }

    bool takes(const std::string& text) const
    {
        const std::string file = mDirectory.write("a.loddef", text);
        const std::string command =
            std::string("'") + LODSMITH_XMLLINT + "' --noout --schema '" LODSMITH_SCHEMA "' '" + file + "' 2>/dev/null";
        return std::system(command.c_str()) == 0;
    }

private:
    TestDirectory mDirectory;
};

} // namespace

TEST_F(LoddefSchema, agreesOnWhatIsRight)
{
    for (const auto& sample : std::filesystem::directory_iterator(LODSMITH_SAMPLES)) {
        const LoddefReading reading = readLoddefFile(sample.path());
        ASSERT_TRUE(reading.ok()) << sample.path();
        EXPECT_TRUE(reading.warnings.empty());
        EXPECT_TRUE(takes(contentOf(sample.path()))) << sample.path();
        EXPECT_TRUE(takes(loddefText(*reading.definition).value())) << sample.path();
    }
    for (const std::string text :
         {"<lod/>", "<lod version='1'><automatic enabled='0'/></lod>",
          "<lod><manual><strategy> pixelcount </strategy></manual></lod>",
          "<lod><manual><level distance='8e+06'><value>+.5</value></level></manual></lod>",
          "<lod><manual><level distance='1'/><type>automatic</type></manual></lod>",
          "<lod><manual><level distance='1'><meshName> a b.mesh </meshName></level></manual></lod>"}) {
        EXPECT_TRUE(parseLoddef(text, "").ok()) << text;
        EXPECT_TRUE(takes(text)) << text;
    }
}

TEST_F(LoddefSchema, agreesOnWhatIsWrong)
{
    for (const std::string text :
         {"<mesh/>",
          "<lod version='2'/>",
          "<lod version='0'/>",
          "<lod><automatic enabled='yes'/></lod>",
          "<lod><automatic/><automatic/></lod>",
          "<lod><manual>text</manual></lod>",
          "<lod><manual><type>manual</type></manual></lod>",
          "<lod><manual><strategy>far</strategy></manual></lod>",
          "<lod><manual><metric/></manual></lod>",
          "<lod><manual><borders>true</borders></manual></lod>",
          "<lod><manual><weights uv='-1'/></manual></lod>",
          "<lod><manual><weights uv='INF'/></manual></lod>",
          "<lod><manual><subMesh index='1'/></manual></lod>",
          "<lod><manual><subMesh index='65536' importance='1'/></manual></lod>",
          "<lod><manual><subMesh index='1' importance='1.5'/></manual></lod>",
          "<lod><manual><level/></manual></lod>",
          "<lod><manual><level distance='0'/></manual></lod>",
          "<lod><manual><level distance='NaN'/></manual></lod>",
          "<lod><manual><level distance='1e19'/></manual></lod>",
          "<lod><manual><level distance='1'><method>halve</method></level></manual></lod>",
          "<lod><manual><level distance='1'><value>-1</value></level></manual></lod>",
          "<lod><manual><level distance='1'><value>0,5</value></level></manual></lod>",
          "<lod><manual><level distance='1'><value>1</value><value>1</value></level></manual></lod>",
          "<lod><manual><level distance='1'><meshName/></level></manual></lod>"}) {
        EXPECT_FALSE(parseLoddef(text, "").ok()) << text;
        EXPECT_FALSE(takes(text)) << text;
    }
}

} // namespace lodsmith
