// Kites in winds from none to a storm, on lines from soft to stiff, in long steps, snapped, and in an unquiet hand.
#include "haptics/flight/kite_flight.h"
#include "haptics/math/length.h"
#include "tests/stability/cases/stability_case.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace fulcrum::stability {
namespace {

constexpr double kDt_s = 0.002;
const Vector3 kHand_W(0.0, 1.0, 0.0);

KiteFlightSettings make_settings(KiteShape shape) {
    KiteFlightSettings settings;
    settings.kite.shape = shape;
    settings.kite.width_m = shape == KiteShape::box ? 0.4 : 0.75;
    return settings;
}

// How fast anything of it moves; no number where a step failed.
double find_speed_m_per_s(const KiteFlight& flight) {
    double fastest = compute_length(flight.state().velocity_W.linear);
    for (const Vector3& velocity_W : flight.line().velocities_W()) {
        fastest = std::max(fastest, compute_length(velocity_W));
    }
    return flight.report().n_failed == 0 && std::isfinite(fastest) ? fastest : std::nan("");
}

// The wind rises from nothing to 30 m/s with twice the gusts of the specification, and goes down again. Lines that hold, and such
// as snap; every shape, from the lowest knot to the highest.
Finding fly_into_storm() {
    constexpr double kStorm_m_per_s = 30.0;
    constexpr int kSteps = 4000;
    Finding finding{0.0, 4.0, {}};
    for (const KiteShape shape : kKiteShapes) {
        for (const double knot_m : {0.55, 0.68, 0.8}) {
            KiteFlightSettings settings = make_settings(shape);
            settings.kite.knot_m = knot_m;
            settings.wind.gustiness = 2.0;
            settings.line.strength_N = knot_m < 0.6 ? 60.0 : 1.0e6;
            KiteFlight flight(settings);
            for (int i = 0; i < kSteps; ++i) {
                const double wind = kStorm_m_per_s * std::sin(std::numbers::pi * i / kSteps);
                flight.set_wind_speed_m_per_s(wind);
                flight.step(kDt_s, kHand_W);
                finding.worst = worse(finding.worst, find_speed_m_per_s(flight) / kStorm_m_per_s);
            }
        }
    }
    return finding;
}

// Where the kite stands does not depend on the step, and 25 times the world's own is held.
Finding fly_in_long_steps() {
    KiteFlight fine(make_settings(KiteShape::diamond));
    KiteFlight coarse(make_settings(KiteShape::diamond));
    for (int i = 0; i < 30000; ++i) {
        fine.step(kDt_s, kHand_W);
    }
    for (int i = 0; i < 1200; ++i) {
        coarse.step(25.0 * kDt_s, kHand_W);
    }
    return {compute_length(Vector3(fine.report().centre_W - coarse.report().centre_W)), 1.0e-3, {}};
}

// From thread to wire: light and stiff lines in a steady wind come to rest.
Finding fly_on_any_line() {
    Finding finding{0.0, 1.0e-3, {}};
    for (const double stretch_N : {10.0, 1.0e3, 1.0e6}) {
        for (const double mass_kg_per_m : {1.0e-5, 5.0e-3}) {
            for (const int segments : {1, 32}) {
                KiteFlightSettings settings = make_settings(KiteShape::diamond);
                settings.kite.knot_m = 0.7;
                settings.line.stretch_N = stretch_N;
                settings.line.mass_kg_per_m = mass_kg_per_m;
                settings.line.segments = segments;
                settings.line.strength_N = 1.0e6;
                KiteFlight flight(settings);
                for (int i = 0; i < 8000; ++i) {
                    flight.step(0.01, kHand_W);
                }
                finding.take(find_speed_m_per_s(flight), describe("stretch %g N", stretch_N));
            }
        }
    }
    return finding;
}

// A line that snaps in a storm: the hand then holds no more than what the wind does to the rest of it.
Finding snap_in_storm() {
    Finding finding{0.0, 3.0, {}};
    for (const KiteShape shape : kKiteShapes) {
        KiteFlightSettings settings = make_settings(shape);
        settings.wind.speed_m_per_s = 20.0;
        settings.wind.gustiness = 1.0;
        KiteFlight flight(settings);
        for (int i = 0; i < 6000; ++i) {
            if (i == 2500) {
                flight.snap_line();
            }
            flight.step(kDt_s, kHand_W);
            // What was stretched springs back for half a second.
            if (i > 2750) {
                finding.worst = worse(finding.worst, compute_length(flight.report().hand_force_W));
            }
            if (std::isnan(find_speed_m_per_s(flight))) {
                finding.worst = std::nan("");
            }
        }
    }
    return finding;
}

// The hand goes to and fro by half a metre, twice a second, so that the line goes slack and taut again.
Finding jerk() {
    Finding finding{0.0, 60.0, {}};
    for (const double stretch_N : {100.0, 500.0, 1.0e5}) {
        KiteFlightSettings settings = make_settings(KiteShape::diamond);
        settings.line.stretch_N = stretch_N;
        settings.line.strength_N = 1.0e6;
        KiteFlight flight(settings);
        int n_slack = 0;
        for (int i = 0; i < 8000; ++i) {
            const double phase = 4.0 * std::numbers::pi * kDt_s * i;
            flight.step(kDt_s, kHand_W + Vector3(0.5 * std::sin(phase), 0.0, 0.0));
            const double felt_N = compute_length(flight.report().hand_force_W);
            n_slack += felt_N < 0.1 ? 1 : 0;
            finding.worst = worse(finding.worst, felt_N);
            if (std::isnan(find_speed_m_per_s(flight))) {
                finding.worst = std::nan("");
            }
        }
        if (n_slack == 0) {
            finding.worst = std::nan("");  // it was to go slack
        }
    }
    return finding;
}

const HardCase kStorm{{"kite from calm to storm",
                       "four kites, three knots, wind from 0 to 30 m/s and back, with gusts",
                       "fastest part over the storm's speed", "", fly_into_storm}};
const HardCase kLongSteps{{"kite in steps of 50 ms", "a diamond in a steady wind at 20 Hz",
                           "distance from where it stands at 500 Hz", "m", fly_in_long_steps}};
const HardCase kAnyLine{{"kite on thread and wire",
                         "lines of 10 N to 1 MN of stretch, 0.01 to 5 g a metre, 1 and 32 segments",
                         "speed after 80 s of steady wind", "m/s", fly_on_any_line}};
const HardCase kSnap{{"kite whose line snaps", "in a storm of 20 m/s, every shape",
                      "force on the hand from half a second later", "N", snap_in_storm}};
const HardCase kJerk{{"kite in an unquiet hand",
                      "the hand jerks by half a metre at 2 Hz; the line goes slack and taut",
                      "largest force on the hand", "N", jerk}};

}  // namespace
}  // namespace fulcrum::stability
