#include "haptics/flight/catenary.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

TEST_CASE("catenary: a level chain sags as the hyperbolic cosine") {
    // 2 H/w sinh(w l / 2 H) = L; sag H/w (cosh(w l / 2 H) - 1).
    const double H = 3.0;
    const double w = 0.5;
    const double l = 8.0;
    const CatenarySettings chain{2.0 * H / w * std::sinh(w * l / (2.0 * H)), w, 1.0e12};
    const auto pull = compute_catenary(chain, l, 0.0);
    REQUIRE(pull);
    CHECK(pull->level_N == Approx(H).epsilon(1.0e-8));
    CHECK(pull->up_top_N == Approx(0.5 * w * chain.length_m));
    CHECK(pull->up_bottom_N == Approx(-0.5 * w * chain.length_m));
}

TEST_CASE("catenary: a taut light line pulls as a spring along its chord") {
    const CatenarySettings line{10.0, 1.0e-6, 500.0};
    const auto pull = compute_catenary(line, 6.06, 8.08);  // 1 % longer than it is
    REQUIRE(pull);
    CHECK(pull->level_N == Approx(5.0 * 0.6).epsilon(1.0e-4));
    CHECK(pull->up_top_N == Approx(5.0 * 0.8).epsilon(1.0e-4));
}

TEST_CASE("catenary: both ends carry its weight, slack or taut, steep or level") {
    const CatenarySettings line{20.0, 0.05, 300.0};
    for (const double level_m : {2.0, 10.0, 18.0}) {
        for (const double up_m : {0.0, 5.0, 15.0, 20.0}) {
            const auto pull = compute_catenary(line, level_m, up_m);
            REQUIRE(pull);
            CHECK(pull->up_top_N - pull->up_bottom_N == Approx(1.0));
            CHECK(pull->level_N > 0.0);
        }
    }
}
