// The verdict on a wall tried out in time: against eigenvalues, on limit cycles, and window by window.
#include "tests/support/wall_trial.h"

#include "tests/support/linear_wall.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace fulcrum::z_width {
namespace {

// A hand that comes from 10 mm away and presses 4 mm into the wall, on the desktop arm without its dry friction.
WallTrial make_tap(const HumanImpedance& human, double resolution_m) {
    WallTrial trial;
    trial.arm = make_desktop_arm();
    trial.arm.human = human;
    trial.arm.dry_friction_N = 0.0;
    trial.arm.max_force_N = 10.0;
    trial.arm.position_resolution_m = resolution_m;
    trial.start_m = 0.01;
    trial.press_m = 0.004;
    trial.velocity.noise_bound_m = 1.0e-9;
    return trial;
}

TEST_CASE("wall trial: a wall far beyond the boundary buzzes, and the verdict says so") {
    WallTrial trial;
    trial.arm = make_desktop_arm();
    trial.arm.human = kFingertip;
    trial.press_m = 0.004;
    trial.stiffness_N_per_m = 300.0;
    const WallCourse calm = run_wall_trial(trial);
    CHECK(calm.is_stable());
    // Spring and finger share the way: F = K d = k_h (press - d), but for the dry friction.
    CHECK(calm.last.force_N == Approx(0.004 * 300.0 * 300.0 / 600.0).margin(0.26 + 300.0 * 5.5e-5));
    // The wall pushes by its depth, seen to half a step.
    CHECK(calm.last.depth_m == Approx(calm.last.force_N / 300.0).margin(0.5 * 5.5e-5));
    trial.stiffness_N_per_m = 50000.0;
    const WallCourse buzz = run_wall_trial(trial);
    CHECK_FALSE(buzz.is_stable());
    CHECK(buzz.last.swing_m > 2.0 * kCalmSteps * 5.5e-5);
    CHECK(buzz.last.ripple_N > 1.0);
}

TEST_CASE("wall trial: a limit cycle is unstable, however it shrinks; a ceiling is no boundary") {
    // Beyond its boundary by eigenvalues (13.9 kN/m) this arm's wall takes seconds to settle on a swing of 0.2 to 1 mm, which
    // then stands for ever.
    for (const double stiffness : {2.0e4, 1.0e5, 1.0e6}) {
        WallTrial trial = make_tap(kArm, 5.5e-5);
        trial.stiffness_N_per_m = stiffness;
        const WallCourse course = run_wall_trial(trial);
        INFO(stiffness << " N/m, " << course.lasted_s << " s");
        CHECK_FALSE(course.is_stable());
        CHECK(course.last.swing_m > 1.0e-4);
    }
    WallTrial trial = make_tap(kFingertip, 0.0);
    trial.press_m = -0.02;  // never at the wall
    CHECK_FALSE(find_largest_stiffness(trial).has_value());
    CHECK_FALSE(find_largest_damping(trial).has_value());
}

TEST_CASE(
    "wall trial: a surface that only pushes ends where the eigenvalues say, steps take a third") {
    constexpr double kWithin = 0.02;
    for (const HumanImpedance& human : {kFingertip, kArm, kPosture}) {
        LinearWall wall;
        wall.modes = {{0.045 + human.mass_kg, human.damping_Ns_per_m, human.stiffness_N_per_m}};
        wall.device_damping_Ns_per_m = 0.5;
        const double exact = find_linear_boundary(wall);
        const double smooth = find_largest_stiffness(make_tap(human, 0.0), 0.005).value();
        CHECK(smooth == Approx(exact).epsilon(kWithin));
        // An encoder's steps keep a vibration alive a little before that; none makes a wall stiffer.
        const double stepped = find_largest_stiffness(make_tap(human, 5.5e-5)).value();
        CHECK(stepped < smooth);
        CHECK(stepped > 0.65 * exact);
    }
    for (const double damping : {0.0, 2.0, 8.0, 20.0}) {
        WallTrial smooth = make_tap(kFingertip, 0.0);
        smooth.damping_Ns_per_m = damping;
        WallTrial stepped = make_tap(kFingertip, 5.5e-5);
        stepped.damping_Ns_per_m = damping;
        CHECK(find_largest_stiffness(smooth).value() > find_largest_stiffness(stepped).value());
    }
}

// The verdict on a vibration of these swings, window by window; undecided when they end first.
WallVerdict judge(const std::vector<double>& swings, double ripple_N = 0.0,
                  bool is_linear = false) {
    WallTrial trial;
    trial.arm.position_resolution_m = 1.0e-4;
    trial.stiffness_N_per_m = 1000.0;
    WallJudge judge(trial);
    for (const double swing_m : swings) {
        const WallVerdict verdict =
            judge.take({.swing_m = swing_m, .ripple_N = ripple_N, .is_linear = is_linear});
        if (verdict != WallVerdict::undecided) {
            return verdict;
        }
    }
    return WallVerdict::undecided;
}

std::vector<double> make_swings(double first, double ratio, int n) {
    std::vector<double> swings;
    for (int i = 0; i < n; ++i) {
        swings.push_back(first * std::pow(ratio, i));
    }
    return swings;
}

TEST_CASE("wall trial: the verdict on swings of 0.1 mm steps") {
    // Two steps are calm, when two windows show them and the force is calm too: K d + 0.52 N.
    CHECK(judge({1e-2, 2.0e-4}) == WallVerdict::undecided);
    CHECK(judge({1e-2, 2.0e-4, 2.0e-4}) == WallVerdict::stable);
    CHECK(judge({1e-5, 1e-5}) == WallVerdict::undecided);
    CHECK(judge(make_swings(2.0e-4, 1.0, 8), 0.61) == WallVerdict::stable);
    CHECK(judge(make_swings(2.0e-4, 1.0, 8), 0.63) == WallVerdict::unstable);
    // More than two are none, if they stand; four as little as forty.
    CHECK(judge(make_swings(2.1e-4, 1.0, 8)) == WallVerdict::unstable);
    CHECK(judge(make_swings(4.0e-4, 1.0, 8)) == WallVerdict::unstable);
    CHECK(judge(make_swings(4.0e-3, 1.0, 8)) == WallVerdict::unstable);
    // Growing; shrinking by less, and by more, than a hundredth in two seconds.
    CHECK(judge(make_swings(1.0e-3, 1.1, 8)) == WallVerdict::unstable);
    CHECK(judge(make_swings(1.0e-2, 0.998, 8)) == WallVerdict::unstable);
    CHECK(judge(make_swings(1.0e-2, 0.997, 8)) == WallVerdict::undecided);
    CHECK(judge(make_swings(1.0e-2, 0.9, 40)) == WallVerdict::stable);
    // It shrank at first, and stands now.
    std::vector<double> settling = make_swings(1.0e-2, 0.9, 10);
    settling.insert(settling.end(), 8, settling.back());
    CHECK(judge(settling) == WallVerdict::unstable);
    // What is linear goes on as it began; what is not may not.
    CHECK(judge(make_swings(1.0e-2, 0.99, 8), 0.0, true) == WallVerdict::stable);
    CHECK(judge(make_swings(1.0e-2, 0.99, 8), 0.0, false) == WallVerdict::undecided);
    CHECK(judge(make_swings(1.0e-2, 1.0, 8), 0.0, true) == WallVerdict::unstable);
    CHECK(judge({std::nan("")}) == WallVerdict::unstable);
    CHECK(judge({1e-3}, HUGE_VAL) == WallVerdict::unstable);
    // A force at the motor's limit is not calm, however coarse the steps.
    WallTrial strong;
    strong.arm.position_resolution_m = 1.0e-2;
    strong.arm.max_force_N = 3.0;
    strong.stiffness_N_per_m = 1.0e4;
    WallJudge judge_strong(strong);
    WallVerdict last = WallVerdict::undecided;
    for (int i = 0; i < 8 && last == WallVerdict::undecided; ++i) {
        last = judge_strong.take({.swing_m = 1.0e-3, .ripple_N = 3.1});
    }
    CHECK(last == WallVerdict::unstable);
}

TEST_CASE(
    "wall trial: a window sees a slow swing whole, and a verdict comes within the longest time") {
    // A free swing of 0.45 s about the place where the hand wants to be, 4 mm each way.
    WallTrial trial;
    const double w_per_s = 2.0 * std::numbers::pi / 0.45;
    trial.arm.mass_kg = 1.0;
    trial.arm.human = {0.0, 0.0, w_per_s * w_per_s};
    trial.both_ways = true;
    trial.start_m = 0.004;
    const WallCourse course = run_wall_trial(trial);
    CHECK_FALSE(course.is_stable());
    CHECK(course.last.swing_m == Approx(0.008).epsilon(1e-4));
    // Damped so little that it is undecided for long, and not linear to the judge for its steps.
    trial.arm.human.damping_Ns_per_m = 0.05;
    trial.arm.position_resolution_m = 1.0e-9;
    trial.longest_s = 7.0;
    const WallCourse cut = run_wall_trial(trial);
    CHECK(cut.verdict == WallVerdict::unstable);
    CHECK(cut.lasted_s == 7.0);
}

}  // namespace
}  // namespace fulcrum::z_width
