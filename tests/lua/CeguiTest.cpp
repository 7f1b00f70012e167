#include "LuaFixture.h"

#include <CEGUI/CEGUI.h>
#include <CEGUI/RendererModules/Null/Renderer.h>
#include <CEGUI/ScriptModules/Lua/ScriptModule.h>

namespace lodsmith::test {

namespace {

/// CEGUI without a screen, whose script module brings tolua++ with it, in a state of its own or in a given one.
class CeguiProgram {
public:
    explicit CeguiProgram(lua_State* state = nullptr)
        : mRenderer(CEGUI::NullRenderer::create()),
          mScripts(state ? CEGUI::LuaScriptModule::create(state) : CEGUI::LuaScriptModule::create())
    {
        mLog.setLogFilename((mDirectory / "cegui.log").string());
        mRenderer.setDisplaySize(CEGUI::Sizef(800, 600));
        CEGUI::System::create(mRenderer, nullptr, nullptr, nullptr, &mScripts);
    }
    ~CeguiProgram()
    {
        CEGUI::System::destroy();
        CEGUI::LuaScriptModule::destroy(mScripts);
        CEGUI::NullRenderer::destroy(mRenderer);
    }
    CeguiProgram(const CeguiProgram&) = delete;
    CeguiProgram& operator=(const CeguiProgram&) = delete;

    lua_State* state() { return mScripts.getLuaState(); }

private:
    TestDirectory mDirectory;
    CEGUI::DefaultLogger mLog;
    CEGUI::NullRenderer& mRenderer;
    CEGUI::LuaScriptModule& mScripts;
};

const char* const kBothAtWork = R"(
    local windows = CEGUI.WindowManager:getSingleton()
    local handles = {}
    for round = 1, 50 do
        local window = windows:createWindow("DefaultWindow", "window" .. round)
        handles[round % 5] = { lodsmith.newDefinition(), lodsmith.meshes()[1], window }
        assert(window:getName() == "window" .. round)
        local definition, mesh = handles[round % 5][1], handles[round % 5][2]
        assert(definition:setAutomatic(false) and definition:addLevel(round):value() == round)
        assert(mesh:name() == "a" and mesh:triangles(0) == 80)
        -- The one's objects are none of the other's.
        assert(not pcall(function() definition:equals(window) end))
        assert(not pcall(function() window:addChild(mesh) end))
        assert(not pcall(function() lodsmith.queue:generate(window, definition) end))
        windows:destroyWindow(window)
        collectgarbage()
    end
    local heard
    local connection = lodsmith.queue:onInjected(function(mesh) heard = mesh:name() end)
    assert(lodsmith.queue:generate(lodsmith.meshes()[1], lodsmith.newDefinition()))
    finishQueue()
    assert(heard == "a")
)";

class LuaWithCegui : public testing::Test {
protected:
    void shareAndRun(lua_State* state)
    {
        const LuaServices services(state, mProgram.definitions(), mProgram.manager(), mProgram.queue());
        mProgram.makeSphere("a", 1);
        lua_pushlightuserdata(state, &mProgram);
        lua_pushcclosure(
            state,
            [](lua_State* caller) {
                static_cast<LuaProgram*>(lua_touserdata(caller, lua_upvalueindex(1)))->finish();
                return 0;
            },
            1);
        lua_setglobal(state, "finishQueue");
        EXPECT_LUA(state, kBothAtWork);
    }

    LuaProgram mProgram;
};

} // namespace

TEST_F(LuaWithCegui, theBindingsComeIntoTheScriptModulesState)
{
    CeguiProgram cegui;
    shareAndRun(cegui.state());
}

TEST_F(LuaWithCegui, theScriptModuleComesIntoAStateWithBindings)
{
    const StateHolder state = newState();
    openLuaBindings(state.get());
    CeguiProgram cegui(state.get());
    shareAndRun(state.get());
}

} // namespace lodsmith::test
