#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

constexpr auto run = [](auto&&... arguments) { return test::run_script(arguments...); };

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

}  // namespace
}  // namespace fulcrum::runtime
