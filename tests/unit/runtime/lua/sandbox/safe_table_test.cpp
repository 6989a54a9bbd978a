#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <rapidcheck.h>

namespace fulcrum::runtime {
namespace {

constexpr auto run = [](auto&&... arguments) { return test::run_script(arguments...); };

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

}  // namespace
}  // namespace fulcrum::runtime
