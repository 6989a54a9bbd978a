#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

constexpr auto run = [](auto&&... arguments) { return test::run_script(arguments...); };

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

}  // namespace
}  // namespace fulcrum::runtime
