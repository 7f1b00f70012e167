#include "LuaFixture.h"

#include <fstream>
#include <ostream>
#include <vector>

namespace lodsmith::test {

namespace {

struct Example {
    int line = 0;
    std::string code;
};

void PrintTo(const Example& example, std::ostream* out)
{
    *out << "docs/lua.md:" << example.line;
}

/// The blocks of docs/lua.md that are Lua.
std::vector<Example> examples()
{
    std::vector<Example> found;
    std::ifstream file(LODSMITH_LUA_PAGE);
    bool isInside = false;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (line == "```lua") {
            found.push_back({number, ""});
            isInside = true;
        } else if (line == "```")
            isInside = false;
        else if (isInside)
            found.back().code += line + "\n";
    }
    return found;
}

class LuaPage : public testing::TestWithParam<Example> {};

} // namespace

TEST(LuaExamples, thereAreSome)
{
    EXPECT_GE(examples().size(), 8u);
}

TEST_P(LuaPage, exampleRuns)
{
    LuaProgram program;
    program.writeSphere("ball.mesh");
    const std::string path = (program.session().directory() / "ball.mesh").string();
    // What goes wrong in a callback counts too.
    const std::string head =
        "path = '" + path + "' printed = {} print = function(...) printed[#printed + 1] = ... end ";
    EXPECT_LUA(program.state(), head);
    EXPECT_EQ("", runLua(program.state(), GetParam().code, "=docs/lua.md"));
    EXPECT_LUA(program.state(), "lodsmith.onError = function(message) failed = message end");
    program.finish();
    program.finishAnalysis();
    EXPECT_EQ("nil", evaluate(program.state(), "failed"));
}

INSTANTIATE_TEST_SUITE_P(Examples, LuaPage, testing::ValuesIn(examples()),
                         [](const auto& info) { return "line" + std::to_string(info.param.line); });

} // namespace lodsmith::test
