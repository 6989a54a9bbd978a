// An arm of seven joints, which turns the hand as well, over the link in closed loop.
#include "tests/support/link_trial.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using test_link::LinkCourse;
using test_link::LinkTrial;
using test_link::run_link_trial;

namespace {

constexpr double kTorque_Nm = 0.2;
constexpr double kStill_rad = 2.0e-3;

LinkTrial make_trial(double stiffness_N_per_m, const LinkFaults& faults) {
    LinkTrial trial{.stiffness_N_per_m = stiffness_N_per_m, .faults = faults};
    trial.wam.emplace();
    trial.torque_Nm = kTorque_Nm;
    return trial;
}

}  // namespace

TEST_CASE("link: a wall and a torque on an arm of seven joints stay calm, whatever the line does") {
    const LinkFaults lines[] = {
        {},
        {.delay_s = 0.01},
        {.delay_s = 0.02, .jitter_s = 0.003, .reorder = 0.1},
        {.loss = 0.05, .burst = 10, .delay_s = 0.002, .duplicate = 0.1, .corrupt = 0.01}};
    for (const LinkFaults& line : lines) {
        for (const double stiffness : {200.0, 800.0}) {
            const LinkCourse course = run_link_trial(make_trial(stiffness, line));
            INFO("delay " << line.delay_s << " s, " << stiffness << " N/m: " << course.swing_m
                          << " m, " << course.turn_swing_rad << " rad, " << course.given_J << " J, "
                          << course.peak_N << " N, " << course.peak_Nm << " Nm");
            REQUIRE(course.linked);
            CHECK(course.is_calm());
            CHECK(course.turn_swing_rad < kStill_rad);
            CHECK(course.given_J < 0.1);
            CHECK(course.trips == 0);
            CHECK(course.peak_N <= 10.0);
            // It is turned, and no more than is asked for.
            CHECK(course.peak_Nm > 0.9 * kTorque_Nm);
            CHECK(course.peak_Nm < 0.3);
        }
    }
}

TEST_CASE("link: without dry friction in its joints hand and wall meet where two springs do") {
    LinkTrial trial = make_trial(300.0, {});
    for (ArmLink& link : trial.wam->model.links) {
        link.dry_friction_Nm = 0.0;
    }
    const LinkCourse course = run_link_trial(trial);
    const double hand = trial.wam->grip.push.stiffness_N_per_m;
    const double meet_N =
        trial.press_m * hand * trial.stiffness_N_per_m / (hand + trial.stiffness_N_per_m);
    // Its elbow comes home slowly against viscous friction, and has not quite in two seconds.
    constexpr double kOnItsWay = 0.1;
    REQUIRE(course.linked);
    CHECK(-course.force_N == Approx(meet_N).epsilon(kOnItsWay));
}
