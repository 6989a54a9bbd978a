// Hard cases: what holds, and that one which throws is shown and does not end the others.
#include "tests/stability/cases/stability_case.h"

#include <catch2/catch.hpp>

#include <stdexcept>

namespace fulcrum::stability {
namespace {

TEST_CASE("hard cases: a worst above its limit, or none at all, does not hold") {
    CHECK(Finding{1.0, 1.0, ""}.holds());
    CHECK_FALSE(Finding{1.1, 1.0, ""}.holds());
    CHECK_FALSE(Finding{std::nan(""), 1.0, ""}.holds());
    CHECK_FALSE(Finding{1.0, std::nan(""), ""}.holds());
    CHECK(std::isnan(worse(std::nan(""), 1.0)));
    CHECK(worse(1.0, 2.0) == 2.0);
}

TEST_CASE("hard cases: one that throws does not hold, and says why") {
    const CaseDescription thrower{"thrower", "it throws", "nothing", "m", []() -> Finding {
                                      throw std::runtime_error("stiffness_N_per_m is too large");
                                  }};
    const Finding finding = run_case(thrower);
    CHECK_FALSE(finding.holds());
    CHECK(finding.note == "could not be run: stiffness_N_per_m is too large");
    const CaseDescription good{"good", "it runs", "nothing", "m", [] {
                                   return Finding{1.0, 2.0, "here"};
                               }};
    CHECK(run_case(good).holds());
    CHECK(run_case(good).note == "here");
}

}  // namespace
}  // namespace fulcrum::stability
