#include "haptics/tool/contact_age.h"

#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;

// Steps from `from_s` to `to_s` after which nothing newer than `told_s` has come.
void wait(ContactAge& age, double from_s, double to_s, double told_s) {
    const int n = static_cast<int>(std::lround((to_s - from_s) / kDt_s));
    for (int i = 0; i < n; ++i) {
        age.step(from_s + i * kDt_s, told_s, kDt_s);
    }
}

}  // namespace

TEST_CASE("contact age: what is told in time is felt whole, for as long as it is held") {
    ContactAge age({.hold_s = 0.1, .fade_s = 0.05});
    for (int i = 0; i < 1000; ++i) {
        age.step(i * kDt_s, i * kDt_s - 0.004, kDt_s);
        REQUIRE(age.share() == 1.0);
        REQUIRE_FALSE(age.is_late());
    }
    CHECK(age.age_s() == Approx(0.004));
    // Silent from 0.995 s on: nothing changes for a tenth of a second.
    wait(age, 1.0, 1.095, 0.995);
    CHECK(age.share() == 1.0);
    CHECK(age.age_s() == Approx(0.099));
}

TEST_CASE(
    "contact age: then it fades evenly, is nothing at hold and fade, and comes back as evenly") {
    ContactAge age({.hold_s = 0.1, .fade_s = 0.05});
    age.step(0.0, 0.0, kDt_s);
    double before = 1.0;
    for (int i = 1; i <= 400; ++i) {
        const double t_s = i * kDt_s;
        const double told_s = t_s < 0.2 ? 0.0 : t_s - 0.001;
        age.step(t_s, told_s, kDt_s);
        // In closed form, but for the step in which it was noticed.
        const double expected = t_s < 0.2 ? std::clamp(1.0 - (t_s - 0.1) / 0.05, 0.0, 1.0)
                                          : std::clamp((t_s - 0.199) / 0.05, 0.0, 1.0);
        REQUIRE(std::abs(age.share() - expected) < 1.001 * kDt_s / 0.05);
        REQUIRE(std::abs(age.share() - before) < 1.001 * kDt_s / 0.05);
        REQUIRE(age.is_late() == (t_s > 0.1 + 1e-12 && t_s < 0.2));
        if (t_s > 0.151 && t_s < 0.2) {
            REQUIRE(age.is_lost());
        }
        before = age.share();
    }
    CHECK(age.share() == 1.0);
}

TEST_CASE(
    "contact age: without any answer the first question's age counts, and anew when restarted") {
    ContactAge age({.hold_s = 0.1, .fade_s = 0.1});
    wait(age, 7.0, 7.05, -1.0);
    CHECK(age.age_s() == Approx(0.049));
    CHECK(age.share() == 1.0);
    wait(age, 7.05, 7.25, -1.0);
    CHECK(age.is_lost());
    age.restart();
    CHECK(age.share() == 1.0);
    CHECK(age.age_s() == 0.0);
    age.step(9.0, -1.0, kDt_s);
    CHECK(age.age_s() == 0.0);
}

TEST_CASE("contact age: an answer from the future is new, one that is no number is late") {
    ContactAge age({});
    age.step(1.0, 2.0, kDt_s);
    CHECK(age.age_s() == 0.0);
    age.step(1.0, std::numeric_limits<double>::quiet_NaN(), kDt_s);
    CHECK(age.is_late());
    CHECK(age.share() < 1.0);
}

TEST_CASE("contact age: settings outside their ranges are refused") {
    test::check_ranges(ContactAgeSettings{},
                       {{"hold_s", [](auto& s) -> double& { return s.hold_s; }, 0.001, 10.0},
                        {"fade_s", [](auto& s) -> double& { return s.fade_s; }, 0.001, 10.0}});
}
