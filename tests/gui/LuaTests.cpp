// Each function of the tables that state/*.lua, panel/*.lua and program/*.lua return is a test.

#include "GuiSession.h"
#include "OgreProgram.h"

#include <gtest/gtest.h>
#include <lua.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace lodsmith::test {
namespace {

using LuaState = std::unique_ptr<lua_State, void (*)(lua_State*)>;

LuaState newState()
{
    LuaState lua(luaL_newstate(), &lua_close);
    luaL_openlibs(lua.get());
    addModulePaths(lua.get());
    return lua;
}

/// Leaves the table that a test file returns on the stack; an error text, or nothing.
std::string loadTests(lua_State* lua, const std::filesystem::path& file)
{
    if (luaL_loadfile(lua, file.c_str()) != 0 || lua_pcall(lua, 0, 1, 0) != 0) {
        return lua_tostring(lua, -1);
    }
    return lua_istable(lua, -1) ? "" : file.string() + " returns no table";
}

/// The error that a test function ends with, and where; empty when it passes.
std::string runTest(lua_State* lua, const std::filesystem::path& file, const std::string& name)
{
    lua_getglobal(lua, "debug");
    lua_getfield(lua, -1, "traceback");
    const int traceback = lua_gettop(lua);
    if (std::string error = loadTests(lua, file); !error.empty()) {
        return error;
    }
    lua_getfield(lua, -1, name.c_str());
    return lua_pcall(lua, 0, 0, traceback) == 0 ? "" : lua_tostring(lua, -1);
}

std::vector<std::string> testNames(const std::filesystem::path& file)
{
    const LuaState lua = newState();
    if (const std::string error = loadTests(lua.get(), file); !error.empty()) {
        throw std::runtime_error(error);
    }
    std::vector<std::string> names;
    for (lua_pushnil(lua.get()); lua_next(lua.get(), -2) != 0; lua_pop(lua.get(), 1)) {
        names.emplace_back(lua_tostring(lua.get(), -2));
    }
    std::sort(names.begin(), names.end());
    return names;
}

void expectSuccess(const std::string& error)
{
    if (!error.empty()) {
        ADD_FAILURE() << error;
    }
}

class LuaTest : public testing::Test {
public:
    explicit LuaTest(std::function<void()> body) : mBody(std::move(body)) {}
    void TestBody() override { mBody(); }

private:
    std::function<void()> mBody;
};

void registerTest(const std::string& suite, const std::string& name, const std::filesystem::path& file,
                  const std::function<void()>& body)
{
    testing::RegisterTest(suite.c_str(), name.c_str(), nullptr, nullptr, file.c_str(), 1,
                          [body]() -> testing::Test* { return new LuaTest(body); });
}

using Register = std::function<void(const std::filesystem::path& file, const std::string& name)>;

void registerStateTest(const std::filesystem::path& file, const std::string& name)
{
    registerTest(file.stem().string(), name, file, [=] { expectSuccess(runTest(newState().get(), file, name)); });
}

void registerPanelTest(const std::filesystem::path& file, const std::string& name)
{
    for (const std::string& skin : skins()) {
        registerTest(file.stem().string() + "In" + skin, name, file, [=] {
            const GuiSession session(skin);
            expectSuccess(runTest(session.lua(), file, name));
        });
    }
}

void registerProgramTest(const std::filesystem::path& file, const std::string& name)
{
    registerTest(file.stem().string(), name, file, [=] {
        const GuiSession session(skins().front());
        const OgreProgram program(session.lua());
        expectSuccess(runTest(session.lua(), file, name));
    });
}

void registerFiles(const std::string& directory, const Register& enter)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(LODSMITH_GUI_TESTS "/" + directory)) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
        for (const std::string& name : testNames(file)) {
            enter(file, name);
        }
    }
}

void registerAllTests()
{
    registerFiles("state", registerStateTest);
    registerFiles("panel", registerPanelTest);
    registerFiles("program", registerProgramTest);
}

} // namespace
} // namespace lodsmith::test

int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    try {
        lodsmith::test::registerAllTests();
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return RUN_ALL_TESTS();
}
