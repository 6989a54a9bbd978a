#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

constexpr auto run = [](auto&&... arguments) { return test::run_script(arguments...); };

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

TEST_CASE("safe base: setmetatable refuses __gc and protected metatables, and does the rest") {
    CHECK(run("setmetatable({}, { __gc = function() end })") ==
          "test.lua:1: __gc is not available in lessons.");
    CHECK(run("return setmetatable({}, { __index = { x = 'found' } }).x") == "found");
    CHECK(run("local t = setmetatable({}, { __metatable = 'mine' }) assert(getmetatable(t) == "
              "'mine') setmetatable(t, {})") == "test.lua:1: this table's metatable is protected.");
    CHECK_THAT(run("setmetatable(3, {})"), Catch::Contains("table expected, got number"));
}

TEST_CASE("safe base: pcall gives results and errors, across a yield too") {
    CHECK(run("local ok, a, b = pcall(function(...) return ... end, 1, 2) return tostring(ok) .. a "
              ".. b") == "true12");
    CHECK(run("local ok, e = pcall(error, 'no', 0) return tostring(ok) .. e") == "falseno");
    CHECK(run("local co = coroutine.wrap(function() local ok, e = pcall(function() local x = "
              "coroutine.yield(1) error(x, 0) end) return tostring(ok) .. e end) "
              "return co() .. co('late')") == "1falselate");
    CHECK(run("return tostring(pcall())") ==
          "test.lua:1: bad argument #1 to 'pcall' (value expected).");
}

TEST_CASE("safe base: texts of things show no addresses") {
    CHECK(run("return tostring({}) .. tostring(print) .. tostring(nil) .. tostring(1.5) .. "
              "tostring(coroutine.create(print))") == "tablefunctionnil1.5thread");
    CHECK(run("return tostring(setmetatable({}, { __name = 'Fruit' }))") == "Fruit");
    CHECK(
        run("return tostring(setmetatable({}, { __tostring = function() return 'apple' end }))") ==
        "apple");
}

TEST_CASE("safe base: require asks once, gives what the module returned, and sees a circle") {
    ScriptSettings settings;
    int n_asked = 0;
    settings.find_module = [&](const std::string& name) {
        ++n_asked;
        return name == "circle" ? ModuleAnswer{true, {"circle.lua", "return require 'circle'"}, ""}
               : name == "five" ? ModuleAnswer{true, {"five.lua", "return { n = 5 }"}, ""}
               : name == "nothing" ? ModuleAnswer{true, {"nothing.lua", ""}, ""}
                                   : ModuleAnswer{false, {}, "it is not there"};
    };
    ScriptState state(settings);
    CHECK(run(state, "return require('five').n + require('five').n") == "10");
    CHECK(n_asked == 1);
    CHECK(run(state, "return tostring(require 'nothing')") == "true");
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

}  // namespace
}  // namespace fulcrum::runtime
