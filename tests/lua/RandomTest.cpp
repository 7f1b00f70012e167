#include "LuaFixture.h"

#include <random>
#include <string>

namespace lodsmith::test {

namespace {

constexpr int kOperations = 1000000;

// Every operation gets two places of a table of handles. What they return does not matter: that nothing breaks does.
const char* const kOperationsInLua = R"(
    slots = {}
    local names = { "m1", "m2", "m3", "m4" }
    local function any() end
    worked = 0
    local function try(call, ...)
        local ok, result = pcall(call, ...)
        if ok and result ~= nil then worked = worked + 1 end
        return ok, result
    end
    local function method(object, name, ...)
        if object ~= nil and object[name] then try(object[name], object, ...) end
    end
    operations = {
        -- Making.
        function(i) slots[i] = lodsmith.newDefinition() end,
        function(i) slots[i] = lodsmith.meshes()[1] end,
        function(i, j) slots[i] = lodsmith.resource(names[j % 4 + 1], "General") end,
        function(i) slots[i] = lodsmith.queue:onInjected(any) end,
        function(i, j) local ok, level = try(slots[j].addLevel, slots[j], i) if ok then slots[i] = level end end,
        function(i, j) local ok, level = try(slots[j].level, slots[j], 1) if ok then slots[i] = level end end,
        function(i, j) local ok, copy = try(slots[j].copy, slots[j]) if ok then slots[i] = copy end end,
        function(i) slots[i] = { slots[i] } end,
        -- Casting, rightly and wrongly.
        function(i, j) local ok, mesh = try(lodsmith.toMesh, slots[j]) if ok then slots[i] = mesh end end,
        function(i, j) local ok, definition = try(lodsmith.toDefinition, slots[j]) if ok then slots[i] = definition end end,
        function(i, j) if type(slots[j]) == "userdata" then slots[i] = slots[j] end end,
        -- Using, of whatever kind it is.
        function(i) method(slots[i], "name") end,
        function(i) method(slots[i], "value") end,
        function(i, j) method(slots[i], "setValue", j) end,
        function(i) method(slots[i], "removeLevel", 1) end,
        function(i) method(slots[i], "isConnected") end,
        function(i) method(slots[i], "disconnect") end,
        function(i, j) method(slots[i], "equals", slots[j]) end,
        function(i, j) try(lodsmith.manager.apply, lodsmith.manager, slots[i], slots[j]) end,
        function(i, j) try(lodsmith.queue.cancel, lodsmith.queue, slots[i]) end,
        -- Dropping.
        function(i) slots[i] = nil end,
        function(i, j) slots[i], slots[j] = nil, nil end,
        function() collectgarbage("step", 10) end,
    }
    rareOperations = {
        function(i) slots = {} end,
        function() collectgarbage() end,
        function(i) removeMesh(names[i % 4 + 1]) end,
        function(i) removeMesh(names[i % 4 + 1]) makeSphere(names[i % 4 + 1], 0) end,
        function(i) endServices() end,
        function(i) endServices() startServices() end,
        function(i) startServices() end,
        function(i, j) finish() end,
        function(i, j) local ok, job = try(lodsmith.analysis.measure, lodsmith.analysis, slots[j], 0, any) if ok then slots[i] = job end end,
        function(i) if type(slots[i]) == "userdata" then getmetatable(slots[i]).__gc(slots[i]) end end,
        function(i) if type(slots[i]) == "userdata" then tolua.cast(slots[i], "lodsmith::Mesh") end end,
    }
    -- That a slot is empty, or has something else, is no failure.
    function operate(kind, which, i, j)
        local ok, message = pcall(kind[which], i, j)
        if not ok and not message:find("attempt to", 1, true) then error(message, 0) end
    end
)";

class Operator {
public:
    explicit Operator(lua_State* state) : mState(state)
    {
        lua_getglobal(state, "operate");
        lua_getglobal(state, "operations");
        lua_getglobal(state, "rareOperations");
        mCommon = static_cast<int>(lua_objlen(state, -2));
        mRare = static_cast<int>(lua_objlen(state, -1));
    }
    ~Operator() { lua_settop(mState, 0); }
    Operator(const Operator&) = delete;
    Operator& operator=(const Operator&) = delete;

    /// An error's message, else nothing.
    std::string operate()
    {
        const bool isRare = mRandom() % 400 == 0;
        lua_pushvalue(mState, 1);
        lua_pushvalue(mState, isRare ? 3 : 2);
        lua_pushinteger(mState, pick(isRare ? mRare : mCommon));
        lua_pushinteger(mState, pick(kSlots));
        lua_pushinteger(mState, pick(kSlots));
        if (lua_pcall(mState, 4, 0, 0) == 0)
            return {};
        std::string message = lua_tostring(mState, -1);
        lua_pop(mState, 1);
        return message;
    }

private:
    static constexpr int kSlots = 40;

    int pick(int count) { return static_cast<int>(mRandom() % static_cast<unsigned>(count)) + 1; }

    lua_State* mState;
    std::mt19937 mRandom{20260101};
    int mCommon = 0;
    int mRare = 0;
};

} // namespace

TEST(LuaRandom, aMillionOperationsHarmNothing)
{
    LuaProgram program;
    for (const char* name : {"m1", "m2", "m3", "m4"})
        program.makeSphere(name, 0);
    ASSERT_EQ("", runLua(program.state(), kOperationsInLua));
    Operator random(program.state());
    for (int i = 0; i < kOperations; ++i)
        ASSERT_EQ("", random.operate()) << "operation " << i;
    // Many met what they are for, and gave something.
    EXPECT_EQ("true", evaluate(program.state(), "worked > " + std::to_string(kOperations / 50)))
        << evaluate(program.state(), "worked") << " did";
}

} // namespace lodsmith::test
