#include "runtime/lua/sandbox/pattern.h"

#include "runtime/lua/sandbox/script_state.h"

#include <catch2/catch.hpp>
#include <lua5.4/lua.hpp>

#include <rapidcheck.h>

namespace fulcrum::runtime {
namespace {

constexpr std::uint64_t kPlenty = 1'000'000'000;

/// Runs `expression` with globals s, p and r set; its results as one text, or "error".
std::string run(lua_State* lua, const std::string& expression, const std::string& s,
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
            RC_ASSERT(run(ours.lua(), expression, s, p, r) == run(original, expression, s, p, r));
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

}  // namespace
}  // namespace fulcrum::runtime
