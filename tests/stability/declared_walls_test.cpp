// Every wall that a lesson may declare settles, as it is shipped: declared_wall.h has the trial, runtime/effect/surface/stable_wall.h what the plan makes of a wall.
#include "tests/support/declared_wall.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <vector>

namespace fulcrum::test {
namespace {

// From the softest and least damped that a lesson may declare to the stiffest and most damped that is not refused.
struct Declared {
    double stiffness_N_per_m, damping_Ns_per_m;
};
std::vector<Declared> make_walls() {
    const bool all = std::getenv("FULCRUM_ALL_WALLS") != nullptr;
    const std::vector<double> stiffnesses =
        all ? std::vector{10.0,   30.0,   100.0,  200.0,  300.0,  400.0,  500.0,  600.0, 800.0,
                          1000.0, 1200.0, 1500.0, 2000.0, 2500.0, 3000.0, 4000.0, 5000.0}
            : std::vector{10.0, 300.0, 1000.0, 2000.0, 5000.0};
    const std::vector<double> dampings =
        all ? std::vector{0.0,  1.0,  2.0,  3.0,  4.0,  5.0,  6.5,  8.0,  9.5, 11.0,
                          12.5, 14.0, 16.0, 18.0, 20.0, 24.0, 28.0, 32.0, 36.0}
            : std::vector{0.0, 5.0, 9.5, 18.0, 36.0};
    std::vector<Declared> walls;
    for (const double stiffness : stiffnesses) {
        for (const double damping : dampings) {
            walls.push_back({stiffness, damping});
        }
    }
    return walls;
}

struct Worst {
    double swing_m = 0.0;
    double excess_J = 0.0;
    double least_N = HUGE_VAL;  // pressed with
    int n = 0;
    int n_softer = 0;
};

// All of them in each hand; those that the plan refuses are not declared.
Worst press_all(const DeclaredWall& as) {
    Worst worst;
    for (const Declared& declared : make_walls()) {
        for (const HumanImpedance& human : kHoldingHands) {
            DeclaredWall wall = as;
            wall.stiffness_N_per_m = declared.stiffness_N_per_m;
            wall.damping_Ns_per_m = declared.damping_Ns_per_m;
            wall.human = human;
            if (!may_be_declared(wall)) {
                continue;
            }
            const DeclaredWallCourse course = press_declared_wall(wall);
            CAPTURE(wall.stiffness_N_per_m, wall.damping_Ns_per_m, wall.rate_Hz,
                    wall.link_delay_s.value_or(0.0), human.mass_kg, course.wall.last.swing_m,
                    course.wall.last.ripple_N, course.felt.stiffness_N_per_m,
                    course.felt.damping_Ns_per_m);
            if (!course.wall.is_stable()) {
                FAIL_CHECK("it does not settle");
            }
            worst.swing_m = std::max(worst.swing_m, course.wall.last.swing_m);
            worst.excess_J = std::max(worst.excess_J, course.excess_J);
            worst.least_N = std::min(worst.least_N, course.wall.last.force_N);
            worst.n_softer += course.felt.stiffness_N_per_m < wall.stiffness_N_per_m ||
                              course.felt.damping_Ns_per_m < wall.damping_Ns_per_m;
            ++worst.n;
        }
    }
    return worst;
}

constexpr double kPressed_N = 0.02;  // the softest wall, 4 mm deep, under dry friction
// Beyond what the scene gives, most of it the encoder's steps: docs/safety.md, Walls.
constexpr double kMostExcess_J = 5.0e-4;
constexpr double kMostExcessSlow_J = 7.0e-4;   // below 1 kHz
constexpr double kMostExcessOther_J = 1.2e-3;  // velocity by another method than the usual one
constexpr double kMostExcessFast_J = 3.0e-3;   // at 2 kHz and more
constexpr int kLeastWalls = 3 * 15;

void check_all(const DeclaredWall& as) {
    const Worst worst = press_all(as);
    CAPTURE(as.rate_Hz, as.link_delay_s.value_or(0.0), as.is_dry, worst.excess_J, worst.swing_m,
            worst.n, worst.n_softer);
    CHECK(worst.n >= kLeastWalls);
    CHECK(worst.excess_J < (as.rate_Hz > 1000.0                              ? kMostExcessFast_J
                            : as.velocity != VelocityMethod::adaptive_window ? kMostExcessOther_J
                            : as.rate_Hz < 1000.0                            ? kMostExcessSlow_J
                                                                             : kMostExcess_J));
    CHECK(worst.least_N > kPressed_N);
}

}  // namespace

TEST_CASE(
    "declared walls: each settles in every hand on a desktop arm, with and without its dry "
    "friction, at each rate") {
    for (const double rate_Hz : {kLeastRate_Hz, 1000.0, kMostRate_Hz}) {
        check_all({.rate_Hz = rate_Hz});
    }
    check_all({.is_dry = true});
}

TEST_CASE("declared walls: each settles by whatever method the hand's speed is found") {
    for (const VelocityMethod velocity :
         {VelocityMethod::finite_difference, VelocityMethod::filtered_difference,
          VelocityMethod::kalman}) {
        check_all({.velocity = velocity});
    }
    check_all({.rate_Hz = kLeastRate_Hz, .velocity = VelocityMethod::kalman});
}

TEST_CASE("declared walls: each settles in every hand over a link, however long") {
    for (const double delay_s : {0.001, 0.02}) {
        check_all({.link_delay_s = delay_s});
    }
}

TEST_CASE("declared walls: one that saturates settles in every hand, with no more than it gives") {
    for (const double saturation_N : {0.3, 1.0, 3.0}) {
        for (const double rate_Hz : {kLeastRate_Hz, 1000.0}) {
            for (const double stiffness : {100.0, 1000.0, 5000.0}) {
                for (const HumanImpedance& human : kHoldingHands) {
                    const DeclaredWallCourse course =
                        press_declared_wall({.stiffness_N_per_m = stiffness,
                                             .damping_Ns_per_m = 5.0,
                                             .rate_Hz = rate_Hz,
                                             .human = human,
                                             .press_m = 0.01,
                                             .saturation_N = saturation_N});
                    CAPTURE(stiffness, saturation_N, rate_Hz, human.mass_kg,
                            course.wall.last.swing_m, course.wall.last.force_N);
                    CHECK(course.wall.is_stable());
                    CHECK(course.wall.last.force_N < saturation_N + 0.02);
                    CHECK(course.felt.saturation_force_N == saturation_N);
                }
            }
        }
    }
}

TEST_CASE(
    "declared walls: a spring, a wall both ways, settles in every hand, at hand and over a link") {
    for (const std::optional<double> delay_s :
         {std::optional<double>{}, std::optional<double>{0.0}, std::optional<double>{0.01}}) {
        for (const double stiffness : {100.0, 500.0, 2000.0}) {
            for (const double damping : {0.0, 9.5, 50.0}) {
                for (const HumanImpedance& human : kHoldingHands) {
                    const DeclaredWallCourse course =
                        press_declared_wall({.stiffness_N_per_m = stiffness,
                                             .damping_Ns_per_m = damping,
                                             .human = human,
                                             .link_delay_s = delay_s,
                                             .is_spring = true});
                    CAPTURE(stiffness, damping, delay_s.value_or(-1.0), human.mass_kg,
                            course.wall.last.swing_m, course.felt.stiffness_N_per_m,
                            course.felt.damping_Ns_per_m);
                    CHECK(course.wall.is_stable());
                    CHECK(course.wall.last.force_N > 0.1);
                }
            }
        }
    }
}

TEST_CASE(
    "declared walls: each settles in a fingertip on an arm of seven joints, at hand and over "
    "a link") {
    for (const double damping : {0.0, 9.5, 36.0}) {
        for (const double stiffness : {100.0, 1000.0, 5000.0}) {
            for (const std::optional<double> delay_s :
                 {std::optional<double>{}, std::optional<double>{0.005}}) {
                const DeclaredWall wall{.stiffness_N_per_m = stiffness,
                                        .damping_Ns_per_m = damping,
                                        .arm = TriedArm::wam,
                                        .link_delay_s = delay_s,
                                        .press_m = 0.01};
                if (!may_be_declared(wall)) {
                    continue;
                }
                const DeclaredWallCourse course = press_declared_wall(wall);
                CAPTURE(stiffness, damping, delay_s.value_or(-1.0), course.wall.last.swing_m,
                        course.wall.last.force_N, course.felt.stiffness_N_per_m,
                        course.felt.damping_Ns_per_m);
                CHECK(course.wall.is_stable());
                CHECK(course.wall.last.force_N > 0.1);
            }
        }
    }
}

}  // namespace fulcrum::test
