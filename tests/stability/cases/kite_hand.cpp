// A hand that holds a kite's line through an arm at 1 kHz, while the kite flies at the world's rate, at 20 Hz, or stops.
#include "haptics/flight/kite_loop.h"
#include "haptics/math/length.h"
#include "tests/stability/cases/stability_case.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace fulcrum::stability {
namespace {

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
