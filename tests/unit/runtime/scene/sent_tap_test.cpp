// What reaches a hand that taps, with the plan and the gate that a lesson gets.
#include "tests/support/tap_trial.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum;
using test::find_share_sent;

namespace {

struct Told {
    int right = 0;
    int all = 0;
};

}  // namespace

TEST_CASE(
    "sent tap: nine tenths of its energy arrive, and what was tapped is told by what arrives") {
    const test::TapJudge judge = test::make_taught_judge();
    Told whole;
    Told clipped;
    int n_broken = 0;
    double least_share = 1.0;
    for (const char* name : test::kTapped) {
        for (const test::TapTrial& trial : test::unknown_taps(name)) {
            const test::TapForces forces = tap(trial);
            n_broken += forces.broken == FeltLimit::none ? 0 : 1;
            Told& told = forces.clips ? clipped : whole;
            ++told.all;
            told.right += judge.tell(forces) == name ? 1 : 0;
            least_share =
                forces.clips ? least_share : std::min(least_share, find_share_sent(forces));
        }
    }
    INFO("of " << whole.all << " taps " << whole.right << " told, of " << clipped.all
               << " that clip " << clipped.right << "; least share " << least_share);
    CHECK(n_broken == 0);
    CHECK(whole.all >= 500);
    CHECK(whole.right >= 0.95 * whole.all);
    CHECK(least_share >= 0.9);
}

TEST_CASE("sent tap: without transients the slew takes most of some") {
    double least_share = 1.0;
    for (const char* name : {"metal", "glass"}) {
        test::TapTrial trial{*find_material(name), kFingertip, 0.2, 0.1};
        const test::TapForces slewed =
            tap(trial, [](SafetySettings& safety) { safety.max_transient_N = 0.0; });
        REQUIRE_FALSE(slewed.clips);
        least_share = std::min(least_share, find_share_sent(slewed));
    }
    CHECK(least_share < 0.5);
}
