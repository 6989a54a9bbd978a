#include "runtime/lua/sandbox/script_state.h"

#include "runtime/lua/sandbox/script_error.h"
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

TEST_CASE(
    "script: an error's text stays within our sentence, behind the place where it was raised") {
    struct Case {
        const char* text;
        const char* said;
    };
    const Case cases[] = {
        // Lines, blanks, nothing, no text.
        {"error('one\\n\\ttwo\\n\\n')", "test.lua:1: one two."},
        {"error('')", "test.lua:1: the script raised an error without a text."},
        {"error(' \\n ', 0)", "test.lua:1: the script raised an error without a text."},
        {"error({})", "test.lua:1: the script raised an error that is a table, not a text."},
        // A place that is not where it runs is a part of the text.
        {"\nerror('other.lua:7: well', 0)", "test.lua:2: other.lua:7: well."},
        {"\nerror('test.lua:7: well', 0)", "test.lua:2: test.lua:7: well."},
        {"\nerror('fine\\ntest.lua:7: well')", "test.lua:2: fine test.lua:7: well."},
        {"local function f() error('of the caller', 2) end\n\nf()", "test.lua:3: of the caller."},
        // Raised elsewhere and handed on: in a coroutine; caught, and raised again as it is.
        {"local f = coroutine.wrap(function()\nlocal x = nil + 1\nend)\nf()",
         "test.lua:2: attempt to perform arithmetic on a nil value."},
        {"local f = coroutine.wrap(function()\nerror('here')\nend)\nf()", "test.lua:2: here."},
        {"local ok, e = pcall(function() error('first') end)\nerror(e, 0)",
         "test.lua:2: test.lua:1: first."},
        {"x = = 1", "test.lua:1: unexpected symbol near '='."},
    };
    for (const Case& c : cases) {
        INFO(c.text);
        CHECK(run(c.text) == c.said);
    }
}

TEST_CASE("script: bytecode is refused") {
    ScriptState state({});
    CHECK_THAT(run(state, std::string("\x1BLua", 4)),
               Catch::Contains("attempt to load a binary chunk"));
}

}  // namespace
}  // namespace fulcrum::runtime
