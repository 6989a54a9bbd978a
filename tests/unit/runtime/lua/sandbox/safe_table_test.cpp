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
}

}  // namespace
}  // namespace fulcrum::runtime
