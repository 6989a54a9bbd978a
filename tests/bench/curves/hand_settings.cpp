// What a hand's scale does to walls, and a turning hand's low pass to what is known of its turning.
#include "haptics/coupling/velocity_estimator.h"
#include "haptics/math/rotation.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/declared_wall.h"

namespace fulcrum::bench {
namespace {

// A hand's scale is world metres a metre of the device; a wall's stiffness is that at the hand whatever the scale.
Report run_hand_scale(Run& run) {
    LineChart felt;
    felt.name = "hand-scale";
    felt.title = "What a hand's scale does to walls";
    felt.work =
        "A fingertip on the desktop arm presses by 4 mm, of the device, walls that a lesson "
        "declares, with the plan that ships.";
    felt.reference = "the declared stiffness";
    felt.advice =
        "The wall stays as stiff; a scene of a metre, at a scale of 4, is felt in four times the "
        "encoder's steps.";
    felt.x = {"scale, world over device", "", true};
    felt.y = {"stiffness at the hand", "N/m", true};
    LineChart steps = felt;
    steps.name = "hand-scale-steps";
    steps.title = "How far what the hand holds still swings in the world";
    steps.reference.clear();
    steps.y = {"swing in the world once it is decided", "um", true};
    const auto scales = run.pick<std::vector<double>>({0.25, 0.5, 1, 2, 4, 8, 16}, {0.5, 2});
    for (const double stiffness_N_per_m : {200.0, 1000.0}) {
        const std::string name = to_text(stiffness_N_per_m) + " N/m";
        Line measured{name};
        Line declared{name + " as declared", LineStyle::theory};
        Line swings{name};
        for (const double scale : scales) {
            const test::DeclaredWallCourse course = test::press_declared_wall(
                {.stiffness_N_per_m = stiffness_N_per_m, .hand_scale = scale});
            measured.add(scale, course.wall.last.force_N / course.wall.last.depth_m);
            declared.add(scale, stiffness_N_per_m);
            swings.add(scale, 1.0e6 * scale * course.wall.last.swing_m);
        }
        felt.lines.push_back(measured);
        felt.lines.push_back(declared);
        steps.lines.push_back(swings);
    }
    return {felt, steps};
}

// Root mean square error over ten seconds of a handle that turns to and fro by `amplitude_rad`, told in whole steps of an encoder.
double find_turning_error(double cutoff_Hz, double amplitude_rad, double frequency_Hz) {
    constexpr double kRate_Hz = 1000.0;
    constexpr double kStep_rad = 2.0 * std::numbers::pi / 8192.0;
    AngularVelocityEstimator estimator(cutoff_Hz);
    const double w = 2.0 * std::numbers::pi * frequency_Hz;
    RootMeanSquare errors;
    for (int k = 0; k < static_cast<int>(10.0 * kRate_Hz); ++k) {
        const double t_s = k / kRate_Hz;
        const double angle_rad =
            std::round(amplitude_rad * std::sin(w * t_s) / kStep_rad) * kStep_rad;
        const Vector3 turn(0.0, 0.0, angle_rad);
        const double told = estimator.step(compute_exp(turn), t_s).z();
        if (t_s > 1.0) {
            errors.add(told - amplitude_rad * w * std::cos(w * t_s));
        }
    }
    return errors.value();
}

Report run_angular_cutoff(Run& run) {
    LineChart chart;
    chart.name = "angular-cutoff";
    chart.title = "How well a hand's turning is known, over the low pass";
    chart.work =
        "A handle turns to and fro at 1 kHz, told by an encoder of 8192 steps a turn: the error of "
        "its angular velocity.";
    chart.reference = "the motion's own velocity";
    chart.advice =
        "As it ships, 80 Hz: less is late for a hand that shakes, more is the encoder's noise for "
        "one that turns slowly.";
    chart.x = {"cutoff", "Hz", true};
    chart.y = {"rms error", "rad/s", true};
    const auto cutoffs_Hz =
        run.pick<std::vector<double>>({2, 5, 10, 20, 40, 80, 160, 320, 640}, {20, 160});
    struct Turn {
        const char* name;
        double amplitude_rad, frequency_Hz;
    };
    for (const Turn& turn : {Turn{"0.2 rad at 0.5 Hz", 0.2, 0.5}, Turn{"0.5 rad at 2 Hz", 0.5, 2.0},
                             Turn{"0.1 rad at 8 Hz", 0.1, 8.0}}) {
        chart.trace(turn.name, LineStyle::measured, cutoffs_Hz, [&](double cutoff_Hz) {
            return find_turning_error(cutoff_Hz, turn.amplitude_rad, turn.frequency_Hz);
        });
    }
    return {chart};
}

const Registration kHandScale{
    {"hand-scale", "what a hand's scale does to the walls that it feels", run_hand_scale}};
const Registration kAngularCutoff{{"angular-cutoff",
                                   "how well a hand's turning is known, over the low pass",
                                   run_angular_cutoff}};

}  // namespace
}  // namespace fulcrum::bench
