#include "LuaFixture.h"

#include <filesystem>
#include <fstream>
#include <ostream>
#include <regex>
#include <vector>

namespace lodsmith::test {

namespace {

/// A function of one of the scripts.
struct ScriptedTest {
    std::string script;
    std::string function;
};

void PrintTo(const ScriptedTest& test, std::ostream* out)
{
    *out << test.script << ".lua: " << test.function;
}

std::vector<ScriptedTest> scriptedTests()
{
    const std::regex head("^function tests\\.(\\w+)");
    std::vector<ScriptedTest> tests;
    for (const char* script : {"definition", "meshes", "services"}) {
        std::ifstream file(std::string(LODSMITH_LUA_SCRIPTS) + "/" + script + ".lua");
        for (std::string line; std::getline(file, line);)
            if (std::smatch match; std::regex_search(line, match, head))
                tests.push_back({script, match[1]});
    }
    return tests;
}

std::string nameOf(const testing::TestParamInfo<ScriptedTest>& info)
{
    return info.param.script + "_" + info.param.function;
}

void collectGarbage(lua_State* state, lua_Debug*)
{
    lua_gc(state, LUA_GCCOLLECT, 0);
}

/// What came of it: an error, or what the test has noted.
std::string outcome(const ScriptedTest& test, lua_Hook hook)
{
    LuaProgram program;
    if (hook)
        lua_sethook(program.state(), hook, LUA_MASKLINE, 0);
    const std::string scripts = LODSMITH_LUA_SCRIPTS;
    const std::string error =
        runLua(program.state(), "package.path = '" + scripts + "/?.lua'\n" + "local tests = dofile('" + scripts + "/"
                                    + test.script + ".lua')\n" + "local ok, message = xpcall(tests." + test.function
                                    + ", debug.traceback)\n" + "if not ok then error(message, 0) end");
    return error.empty() ? "ok\n" + program.transcript() : error;
}

class LuaScript : public testing::TestWithParam<ScriptedTest> {};

} // namespace

/// Garbage that is collected after every line changes nothing.
TEST_P(LuaScript, passesAndDoesNotDependOnCollection)
{
    const std::string plain = outcome(GetParam(), nullptr);
    EXPECT_EQ("ok", plain.substr(0, 2)) << plain;
    EXPECT_EQ(plain, outcome(GetParam(), collectGarbage));
}

INSTANTIATE_TEST_SUITE_P(Scripts, LuaScript, testing::ValuesIn(scriptedTests()), nameOf);

} // namespace lodsmith::test
