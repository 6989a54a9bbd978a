// How a hand goes, by poses that come in steps: an encoder of 55 um shows a hand of 20 mm/s in every third round only, joints that
// step one after the other show it askew, and an arm that is read at half the rate shows it in every second round.
//
// The velocity is what was seen over the last few milliseconds, and keeps its direction through rounds that show nothing
//   v = D / S,   D <- D / (1 + T / tau) + d,   S <- S / (1 + T / tau) + T
// until nothing has been seen for so long that the hand rests.
//
// Thread: the loop that owns it. Cost: a few nanoseconds.
// Source: ours; a window over which steps are counted is that of F. Janabi-Sharifi, V. Hayward, C.-S. J. Chen 2000, Discrete-time
// adaptive windowing for velocity estimation, IEEE T-CST 8(6), section II, here with a fixed length and fading.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

class SeenWay {
  public:
    /// Longer than joints take to step one after the other at a hand's speed, shorter than a hand takes to turn round.
    static constexpr double kWindow_s = 0.003;
    /// A hand that shows nothing for so long rests.
    static constexpr double kRests_s = 0.05;

    /// A round of `dt_s` in which the pose was seen to go by `motion`, metres or radians.
    void step(const Vector3& motion, double dt_s) noexcept {
        if (!motion.allFinite() || !(dt_s > 0.0)) {
            return;
        }
        since_s_ = motion.isZero(0.0) ? since_s_ + dt_s : 0.0;
        const double kept = 1.0 / (1.0 + dt_s / kWindow_s);
        way_ = way_ * kept + motion;
        time_s_ = time_s_ * kept + dt_s;
    }
    /// Nothing has been seen.
    void reset() noexcept { *this = SeenWay{}; }

    /// Metres or radians a second; zero at rest.
    [[nodiscard]] Vector3 velocity() const noexcept {
        return since_s_ < kRests_s && time_s_ > 0.0 ? Vector3(way_ / time_s_)
                                                    : Vector3(Vector3::Zero());
    }

  private:
    Vector3 way_{Vector3::Zero()};
    double time_s_ = 0.0;
    double since_s_ = kRests_s;  // since it was last seen to go
};

}  // namespace fulcrum
