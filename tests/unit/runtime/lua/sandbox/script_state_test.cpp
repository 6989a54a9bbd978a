#include "runtime/lua/sandbox/script_state.h"

#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

constexpr auto run = [](auto&&... arguments) { return test::run_script(arguments...); };

TEST_CASE("script: a spent budget is not swallowed by pcall, coroutine or wrap") {
    const std::string sentence = std::string("test.lua:1: ") + kTooLong + ".";
    for (const char* text :
         {"while true do end", "while true do pcall(function() while true do end end) end",
          "return pcall(function() while true do end end)",
          "return coroutine.resume(coroutine.create(function() while true do end end))",
          "while true do coroutine.wrap(function() while true do end end)() end",
          "local co = coroutine.create(function() pcall(function() while true do end end) end) "
          "coroutine.resume(co) return 'out'",
          "pcall(string.rep, 'x', 1000000) pcall(string.find, ('a'):rep(40), ('a?'):rep(40) .. "
          "'b') return 'out'",
          "table.sort({ 1, 2, 3 }, function() while true do end end)"}) {
        ScriptState state({});
        CHECK(run(state, text, 100'000) == sentence);
    }
}

TEST_CASE("script: a charge counts like instructions") {
    ScriptState state({});
    state.begin_budget(1000);
    CHECK_FALSE(state.protect([&](lua_State* lua) { state.charge(lua, 1000); }));
    CHECK(state.used_instructions() == 1000);
    const auto error = state.protect([&](lua_State* lua) { state.charge(lua, 1); });
    REQUIRE(error);
    CHECK(error->message == kTooLong);
}

TEST_CASE("script: memory is capped, and the state works on after a refusal that was caught") {
    ScriptSettings settings;
    settings.memory_bytes = 4U << 20U;
    ScriptState state(settings);
    CHECK(run(state, "local t = {} for i = 1, 1e9 do t[i] = { i } end", 0) ==
          "test.lua:1: this needs more memory than the 4 MB that a lesson may have.");
    CHECK(run(state,
              "local ok, e = pcall(function() local t = {} for i = 1, 1e9 do t[i] = { i } end end) "
              "return tostring(ok) .. e",
              0) == "falsenot enough memory");
    CHECK(run(state, "return 'fine'") == "fine");
}

TEST_CASE("script: a message with wild bytes becomes a clean one") {
    CHECK(run("error('a\\27[31mb\\0c', 0)") == "test.lua:1: a?[31mb?c.");
    CHECK(clean_text("h\xC3\xA9llo", 2) == "h");
    CHECK(clean_text("h\xC3\xA9llo", 3) == "h\xC3\xA9");
    CHECK(clean_text("\xFF", 9) == "?");
}

TEST_CASE("script: bytecode is refused") {
    ScriptState state({});
    CHECK_THAT(run(state, std::string("\x1BLua", 4)),
               Catch::Contains("attempt to load a binary chunk"));
}

}  // namespace
}  // namespace fulcrum::runtime
