#include "haptics/surface/stroke_filter.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace fulcrum;

namespace {

// What is left of a wave of `nu` a round, averaged with m samples a round.
double response(int m, double nu) {
    const auto weights = stroke_weights(m);
    double sum = 0.0;
    for (std::size_t j = 0; j < weights.size(); ++j) {
        const double rounds = static_cast<double>(j) / m - kStrokeReach;
        sum += weights[j] * std::cos(2.0 * std::numbers::pi * nu * rounds);
    }
    return sum;
}

}  // namespace

TEST_CASE("stroke filter: waves below the pass edge are felt in full, above the stop edge none") {
    for (int m = 1; m <= kMostPerRound; ++m) {
        for (double nu = 0.0; nu <= m - kStrokeStop; nu += 0.001) {
            const double left = response(m, nu);
            if (nu <= kStrokePass) {
                CHECK(std::abs(left - 1.0) <= kStrokeRipple);
            } else if (nu >= kStrokeStop) {
                CHECK(std::abs(left) <= kStrokeRemoved);
            } else {
                CHECK(left > -kStrokeRemoved);
                CHECK(left < 1.0 + kStrokeRipple);
            }
        }
    }
}

TEST_CASE("stroke filter: weights are even, add up to one, and stand in the middle of the stroke") {
    for (int m = 1; m <= kMostPerRound; ++m) {
        const auto weights = stroke_weights(m);
        REQUIRE(weights.size() == static_cast<std::size_t>(2 * kStrokeReach * m + 1));
        double sum = 0.0;
        for (std::size_t j = 0; j < weights.size(); ++j) {
            CHECK(weights[j] == Approx(weights[weights.size() - 1 - j]).margin(1.0e-15));
            CHECK(weights[j] <= weights[weights.size() / 2]);
            sum += weights[j];
        }
        CHECK(sum == Approx(1.0).epsilon(1.0e-14));
    }
    CHECK(stroke_weights(0).size() == stroke_weights(1).size());
    CHECK(stroke_weights(99).size() == stroke_weights(kMostPerRound).size());
}

TEST_CASE("stroke filter: as many samples as the content needs, none where nothing is removed") {
    CHECK(choose_samples_per_round(0.0) == 0);
    CHECK(choose_samples_per_round(kStrokePass) == 0);
    CHECK(choose_samples_per_round(0.31) == 1);
    CHECK(choose_samples_per_round(0.5) == 1);
    CHECK(choose_samples_per_round(0.51) == 2);
    CHECK(choose_samples_per_round(3.5) == 4);
    CHECK(choose_samples_per_round(1.0e9) == kMostPerRound);
    CHECK(choose_samples_per_round(std::nan("")) == 0);
}
