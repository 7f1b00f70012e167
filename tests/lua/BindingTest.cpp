#include "LuaFixture.h"

#include <lodsmith/lua/Binding.h>

#include <OgreException.h>

#include <gmock/gmock.h>

#include <cstdlib>
#include <functional>
#include <limits>
#include <new>
#include <stdexcept>

namespace lodsmith::test {

namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Bound : lua::Handle {
    Bound() : Handle("test::Bound") {}
};
struct AlsoBound : lua::Handle {
    AlsoBound() : Handle("test::AlsoBound") {}
};
struct DerivedFromBound : Bound {};
struct Foreign {
    virtual ~Foreign() = default;
    int value = 0;
};
/// The bound base lies behind another.
struct FromTwo : Foreign, Bound {};
struct NoHandle {};

static_assert(lua::detail::BoundClasses<Bound, AlsoBound>::areUnrelated);
static_assert(!lua::detail::BoundClasses<Bound, AlsoBound, DerivedFromBound>::areUnrelated);
static_assert(!lua::detail::BoundClasses<DerivedFromBound, Bound>::areUnrelated);
static_assert(!lua::detail::BoundClasses<FromTwo, AlsoBound, Bound>::areUnrelated);
static_assert(!lua::detail::BoundClasses<Bound, NoHandle>::areUnrelated);

/// What the function that is called from Lua does.
std::function<lua::Returned()> work;

int callWork(lua_State* state)
{
    return lua::call(state, [] { return work(); });
}

std::string resultOf(lua_State* state, std::function<lua::Returned()> function)
{
    work = std::move(function);
    lua_pushcfunction(state, callWork);
    lua_setglobal(state, "callWork");
    return evaluate(state, "callWork()");
}

/// Counts objects that are alive.
struct Counted {
    Counted() { ++alive; }
    ~Counted() { --alive; }
    static int alive;
};
int Counted::alive = 0;

/// Lua's memory, of which there is an end when the test wants one.
struct Memory {
    std::size_t left = static_cast<std::size_t>(-1);

    static void* allocate(void* self, void* block, std::size_t oldSize, std::size_t newSize)
    {
        auto& memory = *static_cast<Memory*>(self);
        if (newSize == 0) {
            std::free(block);
            return nullptr;
        }
        if (newSize > oldSize && memory.left-- == 0) {
            memory.left = 0;
            return nullptr;
        }
        return std::realloc(block, newSize);
    }
};

} // namespace

TEST(LuaBinding, resultsArriveAsTheyAre)
{
    const StateHolder state = newState();
    EXPECT_EQ("", resultOf(state.get(), [] { return lua::Returned::nothing(); }));
    EXPECT_EQ("nil", resultOf(state.get(), [] { return lua::Returned(nullptr); }));
    EXPECT_EQ("true, 3, text, 0.1",
              resultOf(state.get(), [] { return lua::Returned(true).with(3).with("text").with(0.1f); }));
    EXPECT_EQ("nil, level 1 is wrong",
              resultOf(state.get(), [] { return lua::Returned::failure("level 1 is wrong"); }));
    EXPECT_EQ("nil, a.mesh: is gone", resultOf(state.get(), [] {
                  return lua::Returned(Error{ErrorCode::NotFound, "is gone", "a.mesh"});
              }));
    EXPECT_EQ("nil, a\nb", resultOf(state.get(), [] {
                  return lua::Returned::failures({{ErrorCode::BadFile, "a"}, {ErrorCode::BadFile, "b"}});
              }));
    work = [] {
        lua::Table inner;
        inner.add("one").add(2).set("three", false);
        lua::Table table;
        table.set("inner", std::move(inner)).set("bytes", std::string("a\0b", 3));
        return lua::Returned(std::move(table));
    };
    EXPECT_EQ("one, 2, false, 3", evaluate(state.get(), "callWork().inner[1], callWork().inner[2], "
                                                        "callWork().inner.three, #callWork().bytes"));
}

TEST(LuaBinding, floatsAreTheNumbersTheyWereWrittenAs)
{
    const StateHolder state = newState();
    EXPECT_EQ("20.1", resultOf(state.get(), [] { return lua::Returned(20.1f); }));
    EXPECT_EQ("true", evaluate(state.get(), "callWork() == 20.1"));
    EXPECT_EQ("1e+18", resultOf(state.get(), [] { return lua::Returned(1e18f); }));
    EXPECT_EQ("1e-45", resultOf(state.get(), [] { return lua::Returned(std::numeric_limits<float>::denorm_min()); }));
    EXPECT_EQ("inf", resultOf(state.get(), [] { return lua::Returned(std::numeric_limits<float>::infinity()); }));
}

TEST(LuaBinding, exceptionsBecomeMessages)
{
    const StateHolder state = newState();
    EXPECT_EQ("nil, out of memory", resultOf(state.get(), []() -> lua::Returned { throw std::bad_alloc(); }));
    EXPECT_EQ("nil, wrong", resultOf(state.get(), []() -> lua::Returned { throw std::runtime_error("wrong"); }));
    EXPECT_EQ("nil, unknown exception", resultOf(state.get(), []() -> lua::Returned { throw 42; }));
    EXPECT_THAT(
        resultOf(state.get(),
                 []() -> lua::Returned { OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS, "no such thing", "test"); }),
        testing::AllOf(StartsWith("nil, "), HasSubstr("no such thing")));
    // In a coroutine too, whose pcall would not hold C++ either.
    work = []() -> lua::Returned { throw std::runtime_error("wrong"); };
    EXPECT_EQ("true, nil, wrong",
              evaluate(state.get(), "coroutine.resume(coroutine.create(function() return callWork() end))"));
}

TEST(LuaBinding, objectsAreDestroyedWhereverMemoryRunsOut)
{
    int succeeded = 0;
    for (std::size_t allowed = 0; succeeded < 3; ++allowed) {
        Memory memory;
        StateHolder state(lua_newstate(Memory::allocate, &memory));
        ASSERT_TRUE(state);
        work = [] {
            const auto counted = std::make_shared<Counted>();
            lua::Table table;
            for (int i = 0; i < 20; ++i)
                table.add(std::string(100, static_cast<char>('a' + i)));
            return lua::Returned(std::move(table)).with("and " + std::to_string(Counted::alive));
        };
        lua_pushcfunction(state.get(), callWork);
        memory.left = allowed;
        const int status = lua_pcall(state.get(), 0, 2, 0);
        memory.left = static_cast<std::size_t>(-1);
        EXPECT_EQ(0, Counted::alive);
        if (status == 0) {
            EXPECT_STREQ("and 1", lua_tostring(state.get(), -1));
            ++succeeded;
        } else
            EXPECT_STREQ("not enough memory", lua_tostring(state.get(), -1));
    }
}

TEST(LuaBinding, openingMayRunOutOfMemory)
{
    bool opened = false;
    for (std::size_t allowed = 0; !opened; allowed += 7) {
        Memory memory;
        StateHolder state(lua_newstate(Memory::allocate, &memory));
        memory.left = allowed;
        try {
            openLuaBindings(state.get());
            opened = true;
        } catch (const std::bad_alloc&) {
            memory.left = static_cast<std::size_t>(-1);
        }
        memory.left = static_cast<std::size_t>(-1);
    }
}

TEST(LuaBinding, handlesAreMadeWhereverMemoryRunsOut)
{
    LuaProgram program;
    Memory memory;
    StateHolder state(lua_newstate(Memory::allocate, &memory));
    luaL_openlibs(state.get());
    openLuaBindings(state.get());
    const std::string code = "function work() local d = lodsmith.newDefinition() assert(d:addLevel(10)) "
                             "return d:copy():level(1):value() end";
    ASSERT_EQ("", runLua(state.get(), code));
    int succeeded = 0;
    for (std::size_t allowed = 0; succeeded < 3; ++allowed) {
        lua_getglobal(state.get(), "work");
        memory.left = allowed;
        const int status = lua_pcall(state.get(), 0, 1, 0);
        memory.left = static_cast<std::size_t>(-1);
        if (status == 0) {
            EXPECT_EQ(10, lua_tonumber(state.get(), -1));
            ++succeeded;
        }
        lua_pop(state.get(), 1);
        lua_gc(state.get(), LUA_GCCOLLECT, 0);
    }
}

TEST(LuaBinding, openingTwiceChangesNothing)
{
    const StateHolder state = newState();
    openLuaBindings(state.get());
    EXPECT_LUA(state.get(), "before = lodsmith; kept = lodsmith.newDefinition(); kept:addLevel(5)");
    openLuaBindings(state.get());
    EXPECT_EQ("true, 1", evaluate(state.get(), "before == lodsmith, kept:levelCount()"));
}

TEST(LuaBinding, withoutServicesTheRestWorks)
{
    const StateHolder state = newState();
    openLuaBindings(state.get());
    EXPECT_EQ("nil, nil, nil, nil, nil",
              evaluate(state.get(), "lodsmith.definitions, lodsmith.manager, lodsmith.queue, lodsmith.generator, "
                                    "lodsmith.analysis"));
    // No OGRE either.
    EXPECT_EQ("nil, OGRE is gone", evaluate(state.get(), "lodsmith.meshes()"));
    EXPECT_EQ("nil, OGRE is gone", evaluate(state.get(), "lodsmith.openMesh('a.mesh')"));
    EXPECT_EQ("nil, OGRE is gone", evaluate(state.get(), "lodsmith.resource('a', 'b')"));
    EXPECT_EQ("0", evaluate(state.get(), "lodsmith.newDefinition():levelCount()"));
}

} // namespace lodsmith::test
