#include "runtime/scene/round_up.h"

#include "tests/unit/runtime/rig.h"

#include <rapidcheck.h>

namespace fulcrum::runtime {
namespace {

TEST_CASE("rounding up: two digits, upwards, and what has two stays") {
    for (const double two_digits : {4.3e-5, 0.043, 0.3, 1.0, 9.9, 10.0, 430.0}) {
        CHECK(round_up(two_digits) == Approx(two_digits).epsilon(1.0e-12));
        CHECK(round_up(0.999 * two_digits) == Approx(two_digits).epsilon(1.0e-12));
        CHECK(round_up(1.001 * two_digits) > 1.005 * two_digits);
    }
    CHECK(round_up(0.0421) == Approx(0.043).epsilon(1.0e-12));
    CHECK(round_up(99.5) == Approx(100.0).epsilon(1.0e-12));
}

TEST_CASE("rounding up: never below, and by less than a tenth above") {
    CHECK(rc::check("of any size", [] {
        const double value = std::pow(10.0, *rc::gen::inRange(-12000, 12000) / 1000.0);
        const double rounded = round_up(value);
        RC_ASSERT(rounded >= value * (1.0 - 1.0e-10));
        RC_ASSERT(rounded <= value * (1.1 + 1.0e-10));
    }));
}

}  // namespace
}  // namespace fulcrum::runtime
