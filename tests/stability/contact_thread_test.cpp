// Otaduy and Lin's claim, on two jaws: with a model of contact the tool is stable however slow the contact thread, without one it is not.
#include "tests/support/jaws.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

struct Worst {
    double penetration_m = 0.0;
    double felt_N = 0.0;
    double step_N = 0.0;
    int n_clusters = 0;
};

Worst find_worst(const JawsSettings& settings) {
    Worst worst;
    double last_N = 0.0;
    for (const JawsSample& sample : run_jaws(settings)) {
        worst.penetration_m = std::max(worst.penetration_m, sample.penetration_m);
        worst.felt_N = std::max(worst.felt_N, sample.felt_N);
        worst.step_N = std::max(worst.step_N, std::abs(sample.felt_N - last_N));
        worst.n_clusters = std::max(worst.n_clusters, sample.n_clusters);
        last_N = sample.felt_N;
    }
    return worst;
}

}  // namespace

TEST_CASE(
    "contact thread: two jaws of 10 g bite at 5 kN/m, and a thread at 100 Hz shakes nothing") {
    for (const PenaltyModel model : {PenaltyModel::planes, PenaltyModel::linearised}) {
        for (const double round_s : {0.0, 0.005, 0.01}) {
            const Worst worst = find_worst({.model = model, .round_s = round_s});
            CAPTURE(static_cast<int>(model), round_s);
            CHECK(worst.felt_N > 2.0);
            CHECK(worst.felt_N < 4.0);
            CHECK(worst.step_N < 2.0);
            // What a hand of up to 0.15 m/s goes between two rounds, twice, and what the spring gives way.
            CHECK(worst.penetration_m < 0.3e-3 + 0.3 * round_s);
            CHECK(worst.n_clusters >= 8);
        }
    }
}

TEST_CASE("contact thread: without a model of contact the same jaws are flung about at 500 Hz") {
    const Worst worst = find_worst({.model = PenaltyModel::held, .round_s = 0.002});
    CHECK(worst.felt_N > 30.0);
    CHECK(worst.step_N > 20.0);
}
