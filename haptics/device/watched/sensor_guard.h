// Watches the position sensor itself: one that is frozen, and one that shakes as no hand and no handle can.
//
//   frozen    x_k = x_(k-1) to the bit for longer than trembles_within_s while |A| > kLeastFelt_N, or for kAnswer_s since A has changed by
//             more than moves_at_N: Fault::device_stale, until the position is another
//   shaking   w = d_1 - d_0 T_1 / T_0,   |w| > a T_1 (T_0 + T_1) / 2 + 2 n (1 + T_1 / T_0)       d_i = x_k+i-1 - x_k+i-2
//             is a turn that no handle makes, a the most acceleration, n the resolution; where one is followed by one the
//             other way (w_1 . w_0 < 0) it counts 1:   c <- c (1 - T_1 / kWindow_s) + 1;   c > kMostTurns: Fault::device_invalid
// A: what acts on the handle. w / (T_1 (T_0 + T_1) / 2) is the second divided difference, the acceleration; an error of n in each
// of the three positions makes it wrong by 2 n (1 + T_1 / T_0) at most. A thrust counts once, however long; so does a stop that the handle
// runs into. At 1 kHz an alternating error is seen from (a T^2 + 4 n) / 2 on: 0.2 mm for 300 m/s^2 and n = 30 um.
// What is not seen: a drift, which is no different from a hand that goes there; a smaller error; a turn of the handle that is told
// wrongly. The limits of force, torque, slew and energy bound what these do.
//
// Thread: the loop that owns the device. Cost: a few nanoseconds.
// Source: the laws are ours. What is known of a sensor, who serves the arm says (SensorLife).
#pragma once

#include "haptics/base/error.h"
#include "haptics/base/fault.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

/// How a healthy position sensor behaves. Zeros: that is not known, and not watched, as for an arm that may lie still for ever.
struct SensorLife {
    /// While a force acts, the longest that it tells the same position to the bit: of one whose last digit trembles in any hand. 0 to 1.
    double trembles_within_s = 0.0;
    /// The change of force that moves the handle by more than an encoder's step, however it is held: friction and stiffest grip. 0 to 10.
    double moves_at_N = 0.0;
    /// No handle is thrown to and fro by more than this: 0 to 10 000. 10 N on 45 g are 222 m/s^2.
    double most_m_per_s2 = 0.0;
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const SensorLife& life);

class SensorGuard {
  public:
    static constexpr double kAnswer_s = 0.1;  ///< until a handle that is pushed has moved by a step
    static constexpr double kWindow_s = 0.02;
    static constexpr double kMostTurns = 3.0;  ///< a handle that rings at 60 Hz stays below

    /// Takes what `validate` accepted; two readings of one place lie within `resolution_m`, all along an axis.
    SensorGuard(const SensorLife& life, double resolution_m) noexcept
        : life_(life), resolution_m_(resolution_m) {}

    /// Takes a position (frame D, m) that was measured at `stamp_s` while `acted` (N) was on the handle. One that is not later than
    /// the last, or not finite, is not counted.
    [[nodiscard]] Fault step(const Vector3& position, double stamp_s,
                             const Vector3& acted) noexcept;
    /// The hand has jumped, or another sensor is read.
    void forget() noexcept { n_ = 0; }

    [[nodiscard]] bool is_frozen() const noexcept { return is_frozen_; }
    /// c above.
    [[nodiscard]] double turns() const noexcept { return turns_; }

  private:
    void begin(const Vector3& position, double stamp_s, const Vector3& acted) noexcept;
    void watch_rest(const Vector3& motion, double dt_s, const Vector3& acted) noexcept;
    void watch_turns(const Vector3& motion, double dt_s) noexcept;

    SensorLife life_;
    double resolution_m_;
    int n_ = 0;  // positions taken, up to 2
    Vector3 position_{Vector3::Zero()};
    double stamp_s_ = 0.0;
    // Frozen.
    bool is_frozen_ = false;
    double still_s_ = 0.0;
    double pushed_s_ = 0.0;  // since the force is another than when it came to rest
    Vector3 rest_force_{Vector3::Zero()};
    // Shaking.
    Vector3 motion_{Vector3::Zero()};
    double dt_s_ = 0.0;
    Vector3 turn_{Vector3::Zero()};  // w of the last that was too fast
    double turns_ = 0.0;
};

}  // namespace fulcrum
