#include "runtime/lua/sandbox/pattern.h"
#include "runtime/lua/sandbox/plain_words.h"
#include "runtime/lua/sandbox/script_state.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/rig.h"

#include <lua5.4/lua.hpp>

#include <rapidcheck.h>

using namespace fulcrum::runtime::test;

namespace {

constexpr std::uint64_t kPlenty = 1'000'000'000;

/// Runs `expression` with globals s, p and r set; its results as one text, or "error".
std::string results_of(lua_State* lua, const std::string& expression, const std::string& s,
                       const std::string& p, const std::string& r) {
    lua_settop(lua, 0);
    for (const auto& [name, value] : {std::pair{"s", s}, {"p", p}, {"r", r}}) {
        lua_pushlstring(lua, value.data(), value.size());
        lua_setglobal(lua, name);
    }
    const std::string text = "local out = {} for _, v in ipairs { " + expression +
                             " } do out[#out + 1] = tostring(v) end return table.concat(out, '|')";
    if (luaL_loadstring(lua, text.c_str()) != LUA_OK || lua_pcall(lua, 0, 1, 0) != LUA_OK) {
        return "error";
    }
    std::size_t n = 0;
    const char* result = lua_tolstring(lua, -1, &n);
    return {result, n};
}

/// A pattern of the characters that matter, short enough for the original not to hang.
std::string any_pattern() {
    const auto piece = rc::gen::element<std::string>(
        "a", "b", "c", ".", "%a", "%d", "%W", "%%", "[ab]", "[^a]", "[a-c]", "[%d.]", "[]]", "*",
        "+", "-", "?", "(", ")", "()", "%1", "%2", "%bxy", "%bab", "%f[b]", "%f[^a]", "$", "^", "x",
        "y", "[", "%", "]");
    const auto pieces = *rc::gen::resize(8, rc::gen::container<std::vector<std::string>>(piece));
    std::string pattern;
    for (const std::string& each : pieces) {
        pattern += each;
    }
    return pattern;
}

std::string any_text() {
    return *rc::gen::resize(14, rc::gen::container<std::string>(rc::gen::element(
                                    'a', 'b', 'c', 'x', 'y', '1', '.', ']', '\0')));
}

constexpr auto run = [](auto&&... arguments) { return run_script(arguments...); };

}  // namespace

TEST_CASE("pattern: find, match, gmatch and gsub do as Lua's own on random patterns") {
    lua_State* original = luaL_newstate();
    luaL_openlibs(original);
    ScriptState ours({});
    ours.begin_budget(kPlenty);
    const bool all_alike = rc::check([&] {
        const std::string p = any_pattern();
        const std::string s = any_text();
        const std::string r = *rc::gen::element<std::string>("", "z", "<%0>", "%1%1", "%%");
        const std::string i = std::to_string(*rc::gen::inRange(-4, 6));
        for (const std::string& expression :
             {"string.find(s, p, " + i + ")", std::string("string.match(s, p)"),
              std::string("string.gsub(s, p, r)"), std::string("string.find(s, p, 1, true)"),
              std::string("string.gsub(s, p, { a = 'A', b = false })"),
              std::string("(function() local t = {} for a, b in string.gmatch(s, p) do t[#t + 1] = "
                          "tostring(a) .. tostring(b) end return "
                          "table.concat(t, ';') end)()")}) {
            RC_LOG() << expression << "  s=" << s << "  p=" << p << "  r=" << r << '\n';
            RC_ASSERT(results_of(ours.lua(), expression, s, p, r) ==
                      results_of(original, expression, s, p, r));
        }
    });
    CHECK(all_alike);
    lua_close(original);
}

TEST_CASE("pattern: work is counted, so that backtracking can be ended") {
    struct Enough {};
    std::size_t steps = 0;
    const std::string text(30, 'a');
    std::string pattern;
    for (int i = 0; i < 30; ++i) {
        pattern += "a?";
    }
    pattern += 'b';
    PatternMatcher matcher(text, pattern, [&](std::size_t n) {
        steps += n;
        if (steps > 100000) {
            throw Enough{};
        }
    });
    CHECK_THROWS_AS(static_cast<void>(matcher.match_at(0)), Enough);
}

TEST_CASE("pattern: nesting is bounded") {
    std::string pattern;
    for (int i = 0; i < 300; ++i) {
        pattern += "a?";
    }
    PatternMatcher matcher(std::string_view("b"), pattern, [](std::size_t) {});
    CHECK(matcher.match_at(0) == 0U);
    const std::string text(300, 'a');
    PatternMatcher deep(text, pattern, [](std::size_t) {});
    CHECK_THROWS_AS(static_cast<void>(deep.match_at(0)), PatternError);
}

TEST_CASE("plain words: a { that is missing is told where it is missing") {
    CHECK(find_missing_brace("local w = world:body\n  name = 'x',\n", 2)->call ==
          "local w = world:body");
    // Not where all have it, nor where what follows is no field.
    CHECK_FALSE(find_missing_brace("L:question \"a\" {\n  prompt = \"x\"\n  answers = 1 }", 3));
    CHECK_FALSE(find_missing_brace("world:caption \"a\"\nscore = = 3", 2));
    CHECK_FALSE(find_missing_brace("game.ask \"a\"\nscore = = 3", 2));
    CHECK_FALSE(find_missing_brace("L:test\nprint(1)\nx = = 3", 3));
    CHECK_FALSE(find_missing_brace("", 1));
    CHECK_FALSE(find_missing_brace("\"\n'\n:", 3));
}

TEST_CASE("safe base: require asks once, gives what the module returned, and sees a circle") {
    ScriptSettings settings;
    int n_asked = 0;
    settings.find_module = [&](const std::string& name) {
        ++n_asked;
        return name == "circle" ? ModuleAnswer{true, {"circle.lua", "return require 'circle'"}, ""}
               : name == "five" ? ModuleAnswer{true, {"five.lua", "return { n = 5 }"}, ""}
               : name == "no"   ? ModuleAnswer{true, {"no.lua", "return false"}, ""}
               : name == "nothing" ? ModuleAnswer{true, {"nothing.lua", ""}, ""}
                                   : ModuleAnswer{false, {}, "it is not there"};
    };
    ScriptState state(settings);
    CHECK(run(state, "return require('five').n + require('five').n") == "10");
    CHECK(n_asked == 1);
    CHECK(run(state, "return tostring(require 'nothing')") == "true");
    CHECK(run(state, "return tostring(require 'no') .. tostring(require 'no')") == "falsefalse");
    CHECK(run(state, "require 'circle'") == "circle.lua:1: the module \"circle\" requires itself.");
    CHECK(run(state, "require 'other'") ==
          "test.lua:1: require \"other\" failed: it is not there.");
    CHECK(run(state, "require '../five'") ==
          "test.lua:1: require takes a plain name such as \"story\", not \"../five\".");
}

TEST_CASE("safe base: print is cleaned and cut") {
    std::string printed;
    ScriptSettings settings;
    settings.print = [&](std::string text) { printed = std::move(text); };
    ScriptState state(settings);
    run(state, "print(1, 'a', nil, {})");
    CHECK(printed == "1\ta\tnil\ttable");
    run(state, "print('\\27[2J')");
    CHECK(printed == "?[2J");
    run(state, "print(('x'):rep(100000))");
    CHECK(printed == std::string(500, 'x'));
}

TEST_CASE("safe string: long plain searches are charged for") {
    ScriptState state({});
    CHECK_THAT(run(state, "(('a'):rep(1000000)):find(('a'):rep(500000) .. 'b', 1, true)", 200'000),
               Catch::Contains("too long"));
}

TEST_CASE("script: random numbers are in their range, all occur, and repeat with the seed") {
    const auto draw = [](std::uint64_t seed) {
        ScriptSettings settings;
        settings.seed = seed;
        ScriptState state(settings);
        return run(state, "return math.random(1000000) .. ' ' .. math.random(1000000)");
    };
    CHECK(draw(1) == draw(1));
    CHECK(draw(1) != draw(2));
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
}
