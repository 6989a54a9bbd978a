// Velocity estimators over an encoder: noise, lag, what a swing costs, and the damping that a wall may then have.
#include "haptics/coupling/velocity_estimator.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/wall_trial.h"

namespace fulcrum::bench {
namespace {

constexpr double kStep_m = 5.5e-5;
constexpr double kRate_Hz = 1000.0;

double count_steps(double position_m) {
    return std::round(position_m / kStep_m) * kStep_m;
}

// Root mean square error in mm/s over 20 s of a hand that swings.
double measure_swing_error(const VelocitySettings& settings, double amplitude_m,
                           double frequency_Hz) {
    VelocityEstimator estimator(settings);
    const double w = 2.0 * std::numbers::pi * frequency_Hz;
    RootMeanSquare errors;
    for (int k = 0; k < static_cast<int>(20.0 * kRate_Hz); ++k) {
        const double t_s = k / kRate_Hz;
        const Vector3 y(count_steps(amplitude_m * std::sin(w * t_s)), 0.0, 0.0);
        const double error = estimator.step(y, t_s).x() - amplitude_m * w * std::cos(w * t_s);
        if (t_s > 0.2) {
            errors.add(error);
        }
    }
    return 1000.0 * errors.value();
}

// How late the estimate is, in ms, while the hand speeds up from rest at 2 m/s^2.
double measure_lag_ms(const VelocitySettings& settings) {
    constexpr double kAcceleration = 2.0;
    VelocityEstimator estimator(settings);
    double sum_s = 0.0;
    int n = 0;
    for (int k = 0; k < 600; ++k) {
        const double t_s = k / kRate_Hz;
        const Vector3 y(count_steps(0.5 * kAcceleration * t_s * t_s), 0.0, 0.0);
        const double v = estimator.step(y, t_s).x();
        if (k >= 200) {
            sum_s += t_s - v / kAcceleration;
            ++n;
        }
    }
    return 1000.0 * sum_s / n;
}

// The largest B of a wall of the program's stiffness under this hand.
double find_damping(const VelocitySettings& settings, const HumanImpedance& human) {
    z_width::WallTrial trial = z_width::make_tap(human);
    trial.velocity = settings;
    trial.stiffness_N_per_m = CouplingSettings{}.stiffness_N_per_m;
    return z_width::find_largest_damping(trial).value_or(kNone);
}

Cost measure_step(const Run& run, const VelocitySettings& settings) {
    std::vector<Vector3> positions;
    for (int k = 0; k < 4096; ++k) {
        const double t_s = k / kRate_Hz;
        positions.emplace_back(count_steps(0.01 * std::sin(3.0 * t_s)),
                               count_steps(0.02 * std::cos(2.0 * t_s)), count_steps(0.001 * t_s));
    }
    VelocityEstimator estimator(settings);
    std::size_t k = 0;
    return measure_cost(
        [&] {
            keep(
                estimator.step(positions[k % positions.size()], static_cast<double>(k) / kRate_Hz));
            ++k;
        },
        {run.pick(4000, 400), 16, 200}, sizeof(VelocityEstimator));
}

CostPoint measure_point(const Run& run, const char* series, double knob_ms,
                        const VelocitySettings& settings) {
    return {series,
            knob_ms,
            measure_swing_error(settings, 0.01, 0.5),
            measure_step(run, settings),
            {measure_swing_error(settings, 0.0001, 0.5), measure_swing_error(settings, 0.05, 2.0),
             measure_lag_ms(settings), find_damping(settings, kFingertip),
             find_damping(settings, kArm)}};
}

VelocitySettings make_settings(VelocityMethod method) {
    VelocitySettings settings;
    settings.method = method;
    settings.noise_bound_m = kStep_m;
    return settings;
}

std::vector<CostPoint> measure_points(Run& run) {
    std::vector<CostPoint> points;
    points.push_back(measure_point(run, "finite difference", 1000.0 / kRate_Hz,
                                   make_settings(VelocityMethod::finite_difference)));
    run.progress(0.05, "low pass");
    for (const double cutoff_Hz : {400.0, 200.0, 120.0, 80.0, 40.0, 20.0, 10.0}) {
        VelocitySettings settings = make_settings(VelocityMethod::filtered_difference);
        settings.cutoff_Hz = cutoff_Hz;
        points.push_back(measure_point(run, "low pass",
                                       1000.0 / (2.0 * std::numbers::pi * cutoff_Hz), settings));
    }
    run.progress(0.4, "adaptive window");
    for (const double window_ms : {2.0, 3.0, 4.0, 6.0, 8.0}) {
        VelocitySettings settings = make_settings(VelocityMethod::adaptive_window);
        settings.longest_window_s = 0.001 * window_ms;
        points.push_back(measure_point(run, "adaptive window", window_ms, settings));
    }
    run.progress(0.7, "Kalman");
    for (const double lag_ms : {1.0, 2.0, 4.0, 8.0, 16.0}) {
        VelocitySettings settings = make_settings(VelocityMethod::kalman);
        settings.acceleration_density =
            compute_acceleration_density(0.001 * lag_ms, kStep_m, 1.0 / kRate_Hz);
        points.push_back(measure_point(run, "Kalman", lag_ms, settings));
    }
    return points;
}

// What is bought with lag: one line a method, through the same points.
LineChart draw_over_lag(const std::vector<CostPoint>& points) {
    LineChart chart;
    chart.name = "velocity-estimators-lag";
    chart.title = "Estimators of velocity: noise against lag";
    chart.work =
        "The same settings: the lag while a hand speeds up at 2 m/s^2, and the error while it "
        "swings 1 cm at 0.5 Hz, over encoder steps of 55 um at 1 kHz.";
    chart.advice =
        "Choose the lag that the wall's damping allows, then the method that is lowest there.";
    chart.x = {"lag in speeding up", "ms", true};
    chart.y = {"error in a slow swing, rms", "mm/s", true};
    for (const CostPoint& point : points) {
        if (chart.lines.empty() || chart.lines.back().name != point.series) {
            chart.lines.push_back({point.series});
        }
        chart.lines.back().add(point.extras[2], point.error);
    }
    return chart;
}

Report run_velocity_estimators(Run& run) {
    CostCurve curve;
    curve.name = "velocity-estimators";
    curve.title = "Estimators of velocity over encoder steps of 55 um, 1 kHz";
    curve.work =
        "Each estimator follows a hand that swings 1 cm at 0.5 Hz, then less and faster, then "
        "speeds up at 2 m/s^2; last it damps a wall of 500 N/m that a fingertip, then an arm taps "
        "on a simulated desktop arm without dry friction, until the hand no longer comes to rest "
        "within two steps and a ripple of 0.55 N.";
    curve.reference = "analytic: the velocity of the swing before the encoder";
    curve.knob = {"smoothing: period, time constant, longest window, or lag", "ms", true};
    curve.error = {"error in a slow swing, rms", "mm/s", true};
    curve.extras = {{"error nearly at rest, rms", "mm/s", true},
                    {"error in a fast swing (5 cm, 2 Hz), rms", "mm/s", true},
                    {"lag in speeding up", "ms", true},
                    {"largest stable damping, fingertip", "Ns/m", true},
                    {"largest stable damping, arm", "Ns/m", true}};
    curve.default_series = "adaptive window";
    curve.default_knob = 1000.0 * kLongestWindow_s;
    curve.points = measure_points(run);
    curve.advice =
        "The adaptive window of 8 ms is the default: a Kalman filter of 4 ms errs less in slow "
        "swings (1.9 for 3.0 mm/s) at less lag and the same damping under a fingertip, but under "
        "an arm it bears a fifth less. Take it where hands move slowly and walls damp little; for "
        "more damping than either bears, pay with lag: a low pass of 10 Hz, late by 16 ms.";
    return {curve, draw_over_lag(curve.points)};
}

const Registration kVelocityEstimators{
    {"velocity-estimators", "noise, lag and stable damping of the estimators of velocity",
     run_velocity_estimators}};

}  // namespace
}  // namespace fulcrum::bench
