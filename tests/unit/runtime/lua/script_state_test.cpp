#include "runtime/lua/script_state.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include <rapidcheck.h>
#include <set>

namespace fulcrum::runtime {
namespace {

/// Runs a text; its error's sentence, or what it returned as text.
std::string run(ScriptState& state, const std::string& text, std::uint64_t budget = 10'000'000) {
    state.begin_budget(budget);
    std::string result;
    const auto error = state.protect([&](lua_State* L) {
        state.load_text(L, {"test.lua", text});
        state.call(L, 0, 1);
        if (lua_isstring(L, -1) != 0) {
            result = lua_tostring(L, -1);
        }
    });
    return error ? to_sentence(to_error(*error)) : result;
}

std::string run(const std::string& text) {
    ScriptState state({});
    return run(state, text);
}

TEST_CASE("script: the globals are exactly the allowed ones") {
    CHECK(run("local names = {} for name in pairs(_G) do names[#names + 1] = name end "
              "table.sort(names) return table.concat(names, ' ')") ==
          "_G _VERSION assert coroutine error getmetatable ipairs math next pairs pcall print "
          "rawequal rawget rawlen rawset require "
          "select setmetatable string table tonumber tostring type utf8");
    CHECK(run("local names = {} for name in pairs(string) do names[#names + 1] = name end "
              "table.sort(names) return table.concat(names, ' ')") ==
          "byte char find format gmatch gsub len lower match rep reverse sub upper");
    CHECK(run("return tostring(getmetatable(''))") == "false");
    CHECK(run("return tostring(('x').dump)") == "nil");
}

TEST_CASE("script: the order of pairs is repeatable here") {
    ScriptState state({});
    CHECK(state.is_repeatable());
}

TEST_CASE("script: a spent budget is not swallowed by pcall, coroutine or wrap") {
    const std::string sentence = std::string("test.lua:1: ") + kTooLong + ".";
    for (const char* text :
         {"while true do end", "while true do pcall(function() while true do end end) end",
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
    CHECK_FALSE(state.protect([&](lua_State* L) { state.charge(L, 1000); }));
    CHECK(state.used_instructions() == 1000);
    const auto error = state.protect([&](lua_State* L) { state.charge(L, 1); });
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

TEST_CASE("script: sort orders like the standard library, stable, with any order") {
    const bool sorted = rc::check([] {
        const auto numbers = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-20, 20));
        std::string list;
        for (const int n : numbers) {
            list += std::to_string(n) + ", ";
        }
        std::vector<std::pair<int, int>> expected;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            expected.emplace_back(-(numbers[i] / 4), static_cast<int>(i));
        }
        std::stable_sort(expected.begin(), expected.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        std::string wanted;
        for (const auto& [key, i] : expected) {
            wanted += std::to_string(i) + ' ';
        }
        const std::string text = "local t, out = {}, '' for i, n in ipairs { " + list +
                                 " } do t[i] = { n < 0 and -(-n // 4) or n // 4, i - 1 } end "
                                 "table.sort(t, function(a, b) return a[1] > b[1] end) "
                                 "for _, p in ipairs(t) do out = out .. p[2] .. ' ' end return out";
        RC_ASSERT(run(text) == wanted);
    });
    CHECK(sorted);
    CHECK(run("local t = { 'pear', 'apple', 'fig' } table.sort(t) return table.concat(t, ' ')") ==
          "apple fig pear");
    CHECK_THAT(run("table.sort({ 1, 'x' })"), Catch::StartsWith("test.lua:1: attempt to compare"));
}

TEST_CASE("script: the table functions do as the manual says") {
    CHECK(run("local t = { 1, 2, 3 } table.insert(t, 2, 9) table.insert(t, 4) return "
              "table.concat(t, ',')") == "1,9,2,3,4");
    CHECK(run("local t = { 1, 2, 3 } local r = table.remove(t, 1) return r .. ':' .. "
              "table.concat(t, ',') .. ':' .. table.remove(t)") == "1:2,3:3");
    CHECK(run("return tostring(table.remove({}))") == "nil");
    CHECK(run("local t = { 1, 2, 3, 4 } table.move(t, 1, 3, 2) return table.concat(t, ',')") ==
          "1,1,2,3");
    CHECK(run("local t = { 1, 2, 3, 4 } table.move(t, 2, 4, 1) return table.concat(t, ',')") ==
          "2,3,4,4");
    CHECK(run("local t = table.move({ 1, 2 }, 1, 2, 3, { 7, 8 }) return table.concat(t, ',')") ==
          "7,8,1,2");
    CHECK(run("local a, b, c = table.unpack({ 1, 2, 3 }, 2) return a .. b .. tostring(c)") ==
          "23nil");
    CHECK(run("local t = table.pack(1, nil, 3) return t.n .. t[1] .. t[3]") == "313");
    CHECK(run("return table.concat({ 1, 'a', 2.5 }, '-', 2, 3)") == "a-2.5");
}

TEST_CASE("script: random numbers are in their range, all occur, and repeat with the seed") {
    CHECK(run("local seen = {} for i = 1, 1000 do local r = math.random(6) assert(r >= 1 and r <= "
              "6 and math.type(r) == 'integer') seen[r] = true end "
              "assert(#seen == 6) for i = 1, 1000 do local u = math.random() assert(u >= 0 and u < "
              "1) end return 'ok'") == "ok");
    const auto draw = [](std::uint64_t seed) {
        ScriptSettings settings;
        settings.seed = seed;
        ScriptState state(settings);
        return run(state, "return math.random(1000000) .. ' ' .. math.random(1000000)");
    };
    CHECK(draw(1) == draw(1));
    CHECK(draw(1) != draw(2));
    CHECK(run("math.randomseed(5) local a = math.random(1e9 // 1 | 0) math.randomseed(5) return "
              "tostring(a == math.random(1e9 // 1 | 0))") == "true");
    CHECK_THAT(run("math.random(0)"), Catch::Contains("empty"));
}

TEST_CASE("script: closing coroutines is bounded, and works when it is not abused") {
    CHECK(run("local log = '' local co = coroutine.create(function() local x <close> = "
              "setmetatable({}, { __close = function() log = log .. 'closed' end }) "
              "coroutine.yield() end) coroutine.resume(co) assert(coroutine.close(co)) return log "
              ".. coroutine.status(co)") == "closeddead");
    CHECK(run("local deepest = 0 local function f(n) deepest = math.max(deepest, n) local co = "
              "coroutine.create(function() local x <close> = setmetatable({}, "
              "{ __close = function() f(n + 1) end }) coroutine.yield() end) coroutine.resume(co) "
              "assert(coroutine.close(co)) end "
              "pcall(f, 1) return deepest") == "17");
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
