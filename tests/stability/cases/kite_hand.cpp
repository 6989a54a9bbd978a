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

// A mass on the spring and damper of whoever holds it; limp: 0.2 kg on 50 N/m.
class Holder {
  public:
    Holder(const KiteFlightSettings& settings, double world_Hz)
        : loop_(settings, world_Hz, *channels_), rounds_(rounds_of(world_Hz)) {}

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
const HardCase kLost{{"kite whose world stops",
                      "gusts and a hand that goes to and fro; then the kite's loop ends",
                      "force on the hand from 0.2 s later", "N", lose_the_world}};

}  // namespace
}  // namespace fulcrum::stability
