#include "haptics/base/range.h"

#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("range: both bounds are inside, the first number that is not is named with its bounds") {
    const auto check = [](double first, double second) {
        const Range ranges[] = {{"length", first, -1.0, 2.0},
                                {"width in metres", second, 0.5, 0.5}};
        return check_ranges("the box's", ranges);
    };
    CHECK(check(-1.0, 0.5));
    CHECK(check(2.0, 0.5));
    CHECK(check_ranges("nobody's", {}));
    const auto refused = check(2.5, 0.6);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message == "the box's length is 2.5, outside the range -1 to 2");
    CHECK(refused.error().what_to_do == "set it within that range");
    CHECK(check(0.0, 0.4).error().message ==
          "the box's width in metres is 0.4, outside the range 0.5 to 0.5");
    CHECK_FALSE(check(kNan, 0.5));
    CHECK_FALSE(check(-kInfinity, 0.5));
}
