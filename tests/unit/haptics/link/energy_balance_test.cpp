#include "haptics/link/energy_balance.h"

#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

constexpr double kRound_s = 0.001;
const EnergyBalanceSettings kNoCredit{.headroom_J = 0.0, .memory_s = 10.0, .lent_W = 0.0};

Vector3 along(double x) {
    return {x, 0.0, 0.0};
}

// A side of the link whose forces and motions are along x.
struct Side : EnergyBalance {
    explicit Side(LinkSide side, const EnergyBalanceSettings& settings = kNoCredit)
        : EnergyBalance(side, settings) {}
    void step(double force_N, double motion_m, double told_J = 0.0, double dt_s = kRound_s) {
        EnergyBalance::step(along(force_N), along(motion_m), told_J, dt_s);
    }
    double shift_back(double force_N, double shift_m) {
        return EnergyBalance::shift_back(along(force_N), along(shift_m), kRound_s).x();
    }
};

}  // namespace

TEST_CASE(
    "energy balance: what one side puts in, in closed form, may come out on the other, no more") {
    // A weight of 2 N goes down with the hand by 1 mm, and up again.
    Side arm(LinkSide::arm);
    Side scene(LinkSide::scene);
    for (Side* side : {&arm, &scene}) {
        side->step(-2.0, -0.001, 1.0);
        side->step(-2.0, 0.001, 1.0);
    }
    // Down the scene gives 2 mJ, up the hand does.
    CHECK(scene.gave_J() == Approx(0.002).epsilon(1e-12));
    CHECK(arm.gave_J() == Approx(0.002).epsilon(1e-12));
    arm = Side(LinkSide::arm, {.headroom_J = 0.01, .memory_s = 10.0, .lent_W = 0.0});
    arm.step(1.0, 0.003, 0.004);  // 3 mJ out for 4 in
    CHECK(arm.excess_J() == 0.0);
    arm.step(1.0, 0.003, 0.004);  // and 3 more for none
    CHECK(arm.excess_J() == Approx(0.002).epsilon(1e-3));
    CHECK(arm.peak_excess_J() == Approx(arm.excess_J()));
    // It comes late: the excess is gone.
    arm.step(0.0, 0.0, 0.007);
    CHECK(arm.excess_J() == 0.0);
}

TEST_CASE("energy balance: a late motion was gone under the force since the last, or under this") {
    // 3 mm in three rounds, which show in the last: at the mean of 5 N, for the last gave less, and at the last, for the mean gave less.
    Side falls(LinkSide::arm);
    falls.step(8.0, 0.0);
    falls.step(6.0, 0.0);
    falls.step(1.0, 0.003);
    CHECK(falls.excess_J() == Approx(0.015).epsilon(1e-12));
    falls.step(1.0, 0.001);
    CHECK(falls.excess_J() == Approx(0.016).epsilon(1e-12));
    Side rises(LinkSide::arm);
    rises.step(1.0, 0.0);
    rises.step(2.0, 0.003);
    CHECK(rises.excess_J() == Approx(0.006).epsilon(1e-12));
    // What is put in counts by the lesser.
    Side pressed(LinkSide::arm);
    pressed.step(1.0, 0.0);
    pressed.step(3.0, -0.001);
    CHECK(pressed.gave_J() == Approx(0.002).epsilon(1e-12));
    // What was longer ago than 50 ms fades.
    Side rested(LinkSide::arm);
    for (int i = 0; i < 500; ++i) {
        rested.step(i < 250 ? 100.0 : 1.0, 0.0);
    }
    rested.step(1.0, 0.001);
    CHECK(rested.excess_J() >= 0.001);
    CHECK(rested.excess_J() < 0.0017);
}

TEST_CASE("energy balance: in debt the arm's force gives no more along the way, else as it was") {
    Side arm(LinkSide::arm);
    const Vector3 force(2.0, 1.0, 0.0);
    const Vector3 motion = along(1.0e-4);
    // A debt that the brake pays alone leaves the force; one of half as much again takes half of what would give; a great one all.
    arm.step(1.0, 0.4e-3);
    CHECK(arm.hold_back(force, motion) == force);
    arm.step(1.0, 0.35e-3);
    CHECK(arm.hold_back(force, motion).x() == Approx(1.0).epsilon(1e-9));
    CHECK(arm.hold_back(force, motion).y() == 1.0);
    arm.step(1.0, 0.01);
    CHECK(arm.hold_back(force, motion).x() == Approx(0.0).margin(1e-12));
    // Against the way it takes: that is left, as is a force on a hand that does not move.
    CHECK(arm.hold_back(force, -motion) == force);
    CHECK(arm.hold_back(force, Vector3::Zero()) == force);
}

TEST_CASE("energy balance: the arm's brake takes the excess back in a round like the last") {
    Side arm(LinkSide::arm);
    const Vector3 motion = along(1e-4);
    arm.step(1.0, 1e-4);
    const double alpha = arm.compute_damping(motion, kRound_s, 1e9);
    // alpha d / T along d: alpha |d|^2 / T = excess.
    CHECK(alpha * motion.squaredNorm() / kRound_s == Approx(arm.excess_J()).epsilon(1e-12));
    CHECK(arm.compute_damping(motion, kRound_s, 3.0) == 3.0);
    CHECK(arm.compute_damping(Vector3::Zero(), kRound_s, 1e9) == 0.0);
    // With nothing to take back there is no brake.
    Side quiet(LinkSide::arm);
    quiet.step(1.0, -1e-4);
    CHECK(quiet.compute_damping(motion, kRound_s, 1e9) == 0.0);
}

TEST_CASE("energy balance: what a side in debt puts in pays that debt, and is no new energy") {
    Side arm(LinkSide::arm);
    arm.step(1.0, 0.003);   // 3 mJ too much
    arm.step(1.0, -0.002);  // 2 mJ of them back
    CHECK(arm.excess_J() == Approx(0.001).epsilon(1e-9));
    CHECK(arm.gave_J() == 0.0);
    arm.step(1.0, -0.002);  // the last, and one for the other side
    CHECK(arm.excess_J() == Approx(0.0).margin(1e-15));
    CHECK(arm.gave_J() == Approx(0.001).epsilon(1e-9));
}

TEST_CASE("energy balance: the same energy is given out once, however late it is told") {
    for (const int delay : {20, 100, 200, 250}) {
        Side arm(LinkSide::arm);
        // The scene gives 10 mJ at once; before it is told, and after, the hand takes what it can.
        double out_J = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const double told_J = i >= delay ? 0.01 : 0.0;
            const bool takes = i == 0 || (arm.excess_J() == 0.0 && i >= delay);
            const double way_m = takes ? (i == 0 ? 0.01 : 1e-5) : 0.0;
            arm.step(1.0, way_m, told_J);
            out_J += way_m;
            if (i > delay && arm.excess_J() > 0.0) {
                break;
            }
        }
        INFO("delay " << delay);
        CHECK(out_J <= 0.0101);
    }
}

TEST_CASE("energy balance: the scene's hand moves on along the force by what was taken too much") {
    Side scene(LinkSide::scene);
    scene.step(4.0, -0.001);  // pressed in: the scene took 4 mJ, nobody gave
    CHECK(scene.excess_J() == Approx(0.004));
    const Vector3 moved = scene.shift(along(4.0), 1.0);
    CHECK(moved.x() == Approx(0.001));
    CHECK(scene.excess_J() == Approx(0.0).margin(1e-15));
    // No further than it may.
    scene.step(4.0, -0.001);
    CHECK(scene.shift(along(4.0), 1e-4).x() == Approx(1e-4));
    CHECK(scene.excess_J() == Approx(0.0036).epsilon(1e-3));
}

TEST_CASE(
    "energy balance: a shift goes back free in free space, in contact as far as is paid for") {
    Side scene(LinkSide::scene, {.headroom_J = 0.01, .memory_s = 10.0, .lent_W = 0.0});
    CHECK(scene.shift_back(0.0, -0.002) == -0.002);
    CHECK(scene.shift_back(-1.0, -0.002) == -0.002);  // the scene gives: free
    CHECK(scene.shift_back(2.0, -0.002) == 0.0);      // it would take 4 mJ, unpaid
    scene.step(0.0, 0.0, 0.002);                      // the hand has put 2 mJ in
    CHECK(scene.shift_back(2.0, -0.002) == Approx(-0.001));
    CHECK(scene.shift_back(2.0, -0.001) == Approx(0.0).margin(1e-12));
    scene = Side(LinkSide::scene, {.headroom_J = 0.0, .memory_s = 10.0, .lent_W = 0.004});
    // 4 mW for a millisecond against 2 N: 2 um.
    CHECK(scene.shift_back(2.0, -0.001) == Approx(-2e-6));
    CHECK(scene.excess_J() == 0.0);
    CHECK(scene.shift_back(2.0, -1e-7) == Approx(-1e-7));
}

TEST_CASE("energy balance: credit is small, and fades by 1 - T / memory a round") {
    Side arm(LinkSide::arm, {.headroom_J = 0.001, .memory_s = 0.1});
    arm.step(0.0, 0.0, 5.0);  // a great deal at once
    arm.step(1.0, 0.002, 5.0);
    CHECK(arm.excess_J() == Approx(0.001).epsilon(0.02));
    // What it earned is forgotten, what it owes is not: news that come late must not pay twice.
    for (int i = 0; i < 300; ++i) {
        arm.step(0.0, 0.0, 5.0);
    }
    CHECK(arm.excess_J() == Approx(0.001).epsilon(0.02));
    arm.step(0.0, 0.0, 5.001);
    CHECK(arm.excess_J() < 0.1e-3);
    arm = Side(LinkSide::arm, {.headroom_J = 0.001, .memory_s = 0.1});
    arm.step(0.0, 0.0, 5.0);
    for (int i = 0; i < 99; ++i) {
        arm.step(0.0, 0.0, 5.0);
    }
    // What is left after a hundred rounds, and out of it 1 mJ.
    const double left_J = 0.001 * std::pow(0.99, 100);
    arm.step(1.0, 0.001, 5.0);
    CHECK(arm.excess_J() == Approx(0.001 - left_J).epsilon(1e-9));
}

TEST_CASE("energy balance: what is not finite is not counted, and bad settings are refused") {
    Side arm(LinkSide::arm);
    arm.step(kNan, 1.0);
    arm.step(1.0, kNan);
    arm.step(1.0, 1.0, kNan);
    arm.step(1.0, 1.0, 0.0, 0.0);
    arm.step(1.0, 1.0, 0.0, kNan);
    CHECK(arm.gave_J() == 0.0);
    CHECK(arm.excess_J() == 0.0);
    // A sum that shrinks and grows again by as much is no new energy.
    arm.step(0.0, 0.0, 0.5);
    arm.step(0.0, 0.0, 0.0);
    arm.step(1.0, 0.1, 0.5);
    CHECK(arm.excess_J() == Approx(0.1).epsilon(1e-3));
    CHECK(validate(EnergyBalanceSettings{}));
    CHECK_FALSE(validate(EnergyBalanceSettings{.headroom_J = -1e-9}));
    CHECK_FALSE(validate(EnergyBalanceSettings{.headroom_J = kNan}));
    CHECK_FALSE(validate(EnergyBalanceSettings{.memory_s = 0.0}));
    CHECK_FALSE(validate(EnergyBalanceSettings{.memory_s = 11.0}));
}

TEST_CASE("energy balance: a new session begins with no sums, no debt and no force of before") {
    Side arm(LinkSide::arm);
    arm.step(2.0, -0.001);  // puts in
    arm.step(2.0, 0.002, 5.0);
    arm.step(2.0, 3.0, 5.0);  // in debt
    arm.step(100.0, 0.0, 5.0);
    REQUIRE(arm.gave_J() > 0.0);
    REQUIRE(arm.excess_J() > 0.5);
    arm.reset();
    CHECK(arm.gave_J() == 0.0);
    CHECK(arm.excess_J() == 0.0);
    // The other side's sum begins at 0 too, and what it says now is news.
    arm.step(1.0, 0.001, 0.003);
    CHECK(arm.excess_J() == 0.0);
    // At this round's force alone.
    arm.reset();
    arm.step(100.0, 0.0);
    arm.reset();
    arm.step(1.0, 0.001);
    CHECK(arm.excess_J() == Approx(0.001).epsilon(1e-12));
}
