#include "runtime/lua/sandbox/lua_seed.h"

#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

#include <array>

namespace fulcrum::runtime {
namespace {

constexpr auto run = [](auto&&... arguments) { return test::run_script(arguments...); };

TEST_CASE("script: the order of pairs is repeatable here") {
    ScriptState state({});
    CHECK(state.is_repeatable());
}

TEST_CASE(
    "lua seed: the order of names is the same in two states, made at different depths of the "
    "stack") {
    const std::string text =
        "local t, out = {}, '' for i = 1, 50 do t['n' .. i * 7919] = i end for k in pairs(t) do "
        "out = out .. k end return out";
    const std::string first = run(text);
    const auto deeper = [&](auto self, int depth) -> std::string {
        volatile char space[512] = {static_cast<char>(depth)};
        return depth == 0
                   ? run(text)
                   : self(self, depth - 1) + std::string(static_cast<std::size_t>(space[1]), ' ');
    };
    CHECK(deeper(deeper, 50) == first);
}

TEST_CASE("lua seed: a block that is no Lua state is left alone") {
    std::array<std::byte, 512> block{};
    int argument = 0;
    CHECK_FALSE(fix_string_seed(
        block.data(), block.size(), [](void*, void*, size_t, size_t) -> void* { return nullptr; },
        &argument));
    CHECK(block == std::array<std::byte, 512>{});
}

}  // namespace
}  // namespace fulcrum::runtime
