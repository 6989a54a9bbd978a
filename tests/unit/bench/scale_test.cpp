#include "tests/bench/harness/scale.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum::bench {
namespace {

Extent extent_of(std::initializer_list<double> values, bool logarithmic) {
    Extent extent;
    for (const double v : values) {
        extent.add(v, logarithmic);
    }
    return extent;
}

TEST_CASE("scale: a decade is as long as the next, and y may run upwards") {
    const Scale scale(extent_of({1e-6, 1e3}, true), true, 400.0, 40.0);
    const double decade = scale.place(1.0) - scale.place(10.0);
    CHECK(decade > 0.0);
    CHECK(scale.place(1e-5) - scale.place(1e-4) == Approx(decade));
    CHECK(scale.place(1e-6) <= 400.0);
    CHECK(scale.place(1e3) >= 40.0);
}

TEST_CASE("scale: what lies outside or has no logarithm lies on the nearer end") {
    const Scale scale(extent_of({1.0, 100.0}, true), true, 0.0, 10.0);
    CHECK(scale.place(0.0) == 0.0);
    CHECK(scale.place(-5.0) == 0.0);
    CHECK(scale.place(1e9) == 10.0);
}

TEST_CASE("scale: ticks are round, inside, and few") {
    const Scale linear(extent_of({0.0, 0.73}, false), false, 0.0, 100.0);
    const auto ticks = linear.ticks();
    REQUIRE(ticks.size() >= 3);
    CHECK(ticks.size() <= 9);
    CHECK(ticks.front() == 0.0);
    CHECK(ticks[1] == Approx(0.2));
    const Scale decades(extent_of({1e-12, 1e3}, true), true, 0.0, 100.0);
    CHECK(decades.ticks().size() <= 10);
    const Scale narrow(extent_of({1.0, 9.0}, true), true, 0.0, 100.0);
    CHECK(narrow.ticks().size() >= 3);
}

TEST_CASE("scale: one value, or none, still makes an axis") {
    for (const bool logarithmic : {false, true}) {
        const Scale one(extent_of({5.0}, logarithmic), logarithmic, 0.0, 100.0);
        CHECK(one.place(5.0) > 10.0);
        CHECK(one.place(5.0) < 99.9);
        const Scale none(Extent{}, logarithmic, 0.0, 100.0);
        CHECK_FALSE(none.ticks().empty());
    }
}

TEST_CASE("scale: an extent takes in numbers only") {
    Extent extent;
    extent.add(std::numeric_limits<double>::quiet_NaN(), false);
    extent.add(std::numeric_limits<double>::infinity(), false);
    extent.add(-1.0, true);
    CHECK(extent.empty());
    extent.add(-1.0, false);
    CHECK(extent.low() == -1.0);
}

}  // namespace
}  // namespace fulcrum::bench
