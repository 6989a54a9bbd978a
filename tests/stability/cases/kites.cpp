#include "haptics/flight/kite_flight.h"
#include "haptics/flight/kite_loop.h"
#include "haptics/math/length.h"
#include "tests/stability/cases/stability_case.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

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

constexpr double kHapticDt_s = 0.001;
constexpr double kScale = 4.0;  // world metres a metre of the arm
constexpr double kWorld_Hz = 500.0;

// A mass on the spring and damper of whoever holds it; limp: 0.2 kg on 50 N/m.
class Holder {
  public:
    // A world made for 500 Hz that comes to a round so many times a second.
    Holder(const KiteFlightSettings& settings, double world_Hz, double share = 1.0)
        : loop_(settings, kWorld_Hz, *channels_), rounds_(rounds_of(world_Hz)) {
        LineFeelSettings feel;
        feel.share = share;
        feel_ = LineFeel(feel);
    }

    void slow_down(double world_Hz) { rounds_ = rounds_of(world_Hz); }

    // The hand wants to be `aim_m` along the wind from where it began. `flies`: the kite's loop runs.
    void step(double aim_m, bool flies) {
        now_s_ += kHapticDt_s;
        const Vector3 hand_W = Vector3(0.0, 1.0, 0.0) + kScale * at_D_;
        channels_->hand_W.publish(hand_W);
        if (flies && n_++ % rounds_ == 0) {
            loop_.step(now_s_);
        }
        (void)channels_->line.take();
        felt_ = feel_.step(channels_->line.value(), Pose::at(hand_W), now_s_, kHapticDt_s);
        const Vector3 pull_N =
            felt_.force + 50.0 * (Vector3(aim_m, 0.0, 0.0) - at_D_) - 2.0 * velocity_D_;
        velocity_D_ += kHapticDt_s / 0.2 * pull_N;
        at_D_ += kHapticDt_s * velocity_D_;
    }
    [[nodiscard]] const Vector3& at_D() const { return at_D_; }
    [[nodiscard]] double felt_N() const { return compute_length(felt_.force); }
    [[nodiscard]] bool is_flying() const {
        return loop_.flight().report().centre_W.y() > 5.0 && loop_.flight().report().n_failed == 0;
    }
    [[nodiscard]] const KiteReport& report() const { return loop_.flight().report(); }

  private:
    static int rounds_of(double world_Hz) {
        return static_cast<int>(std::lround(1.0 / (world_Hz * kHapticDt_s)));
    }

    std::unique_ptr<KiteChannels> channels_ = std::make_unique<KiteChannels>();
    KiteLoop loop_;
    LineFeel feel_{LineFeelSettings{}};
    int rounds_;
    int n_ = 0;
    double now_s_ = 0.0;
    Vector3 at_D_{Vector3::Zero()};
    Vector3 velocity_D_{Vector3::Zero()};
    Wrench felt_{};
};

KiteFlightSettings make_kite_of(double stretch_N) {
    KiteFlightSettings settings;
    settings.kite.knot_m = 0.7;
    settings.line.stretch_N = stretch_N;
    return settings;
}

Finding hold_still() {
    Finding finding{0.0, 5.0e-5, {}};
    for (const double world_Hz : {500.0, 100.0, 20.0}) {
        for (const double stretch_N : {100.0, 500.0, 5000.0}) {
            Holder holder(make_kite_of(stretch_N), 500.0);
            for (int i = 0; i < 40000; ++i) {
                // It flies before its world slows down: a launch is a time of its own.
                if (i == 15000) {
                    holder.slow_down(world_Hz);
                }
                holder.step(0.0, true);
            }
            Vector3 least = holder.at_D();
            Vector3 most = least;
            for (int i = 0; i < 1000; ++i) {
                holder.step(0.0, true);
                least = least.cwiseMin(holder.at_D());
                most = most.cwiseMax(holder.at_D());
            }
            // A hand that had lost the kite would be still as well.
            const double moved_m = holder.is_flying() && holder.felt_N() > 0.5
                                       ? compute_length(Vector3(most - least))
                                       : std::nan("");
            finding.worst = worse(finding.worst, moved_m);
        }
    }
    return finding;
}

struct Launch {
    double stretch_N;
    double gustiness;
    double wind_m_per_s;
};

// What came of it in twenty seconds.
struct Flown {
    Vector3 centre_W{Vector3::Zero()};
    double fastest_m_per_s = 0.0;
    double largest_step_N = 0.0;  // of what is felt, in a millisecond
    bool is_flying = false;
};

// The world's rounds come at that rate from the launch on. A stiff line is felt at the share that a scene may have of it.
Flown fly_from_launch(const Launch& launch, double world_Hz) {
    constexpr double kStiffest_N_per_m = 2000.0;
    constexpr double kShortest_m = 5.0;
    KiteFlightSettings settings = make_kite_of(launch.stretch_N);
    settings.wind.gustiness = launch.gustiness;
    settings.wind.speed_m_per_s = launch.wind_m_per_s;
    settings.line.strength_N = 1.0e6;
    Holder holder(settings, world_Hz,
                  std::min(1.0, kStiffest_N_per_m * kShortest_m / (kScale * launch.stretch_N)));
    Flown flown;
    double last_N = 0.0;
    for (int i = 0; i < 20000; ++i) {
        holder.step(0.0, true);
        flown.fastest_m_per_s =
            std::max(flown.fastest_m_per_s, compute_length(holder.report().velocity_W));
        flown.largest_step_N = std::max(flown.largest_step_N, std::abs(holder.felt_N() - last_N));
        last_N = holder.felt_N();
    }
    flown.centre_W = holder.report().centre_W;
    flown.is_flying = holder.is_flying();
    return flown;
}

// How far from where it is at 500 Hz; no number where it is thrown, comes down or jolts the hand.
double compare_starved(const Launch& launch) {
    constexpr double kFaster = 1.5;
    constexpr double kJolt_N = 0.5;
    const Flown in_time = fly_from_launch(launch, kWorld_Hz);
    double farthest_m = 0.0;
    for (const double world_Hz : {100.0, 20.0}) {
        const Flown late = fly_from_launch(launch, world_Hz);
        const bool is_good = in_time.is_flying && late.is_flying &&
                             late.fastest_m_per_s <= kFaster * in_time.fastest_m_per_s &&
                             std::max(late.largest_step_N, in_time.largest_step_N) <= kJolt_N;
        farthest_m =
            worse(farthest_m, is_good ? compute_length(Vector3(late.centre_W - in_time.centre_W))
                                      : std::nan(""));
    }
    return farthest_m;
}

// From soft to stiff lines, in a breeze and a strong wind, steady and gusty: a world that is starved from the first moment flies as
// one in time.
Finding launch_starved() {
    Finding finding{0.0, 1.0, {}};
    for (const double stretch_N : {100.0, 500.0, 5.0e3, 5.0e4, 1.0e6}) {
        for (const Launch& launch : {Launch{stretch_N, 0.0, 6.0}, Launch{stretch_N, 2.0, 6.0},
                                     Launch{stretch_N, 0.0, 12.0}, Launch{stretch_N, 2.0, 12.0}}) {
            finding.worst = worse(finding.worst, compare_starved(launch));
        }
    }
    return finding;
}

// The hand goes to and fro in gusts; then the world stands still for ever.
Finding lose_the_world() {
    Finding finding{0.0, 0.0, {}};
    KiteFlightSettings settings = make_kite_of(500.0);
    settings.wind.gustiness = 1.0;
    settings.wind.speed_m_per_s = 9.0;
    Holder holder(settings, 500.0);
    double strongest_N = 0.0;
    for (int i = 0; i < 20000; ++i) {
        holder.step(0.05 * std::sin(0.012 * i), true);
        strongest_N = std::max(strongest_N, holder.felt_N());
    }
    for (int i = 0; i < 1000; ++i) {
        holder.step(0.05, false);
        strongest_N = std::max(strongest_N, holder.felt_N());
        // Timeout and fading are a tenth of a second each.
        if (i > 200) {
            finding.worst = worse(finding.worst, holder.felt_N());
        }
    }
    const double most_N = LineFeelSettings{}.most_N;
    if (!(strongest_N > 1.0 && strongest_N <= most_N * (1.0 + 1.0e-12))) {
        finding.worst = std::nan("");
    }
    return finding;
}

const HardCase kStill{
    {"kite's line in a hand",
     "a limp hand, a kite whose world slows to 100 and 20 Hz, lines from soft to stiff",
     "movement of the hand in a second of steady wind", "m", hold_still}};
const HardCase kStarved{
    {"kite launched in a starved world",
     "rounds at 500, 100 and 20 Hz from the launch on; lines of 100 N to 1 MN of "
     "stretch, winds of 6 and 12 m/s, steady and gusty",
     "distance from where it is at 500 Hz, 20 s later", "m", launch_starved}};
const HardCase kLost{{"kite whose world stops",
                      "gusts and a hand that goes to and fro; then the kite's loop ends",
                      "force on the hand from 0.2 s later", "N", lose_the_world}};

}  // namespace

}  // namespace fulcrum::stability
