#include "haptics/device/watched/sensor_guard.h"

#include "haptics/math/felt.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

Fault SensorGuard::step(const Vector3& position, double stamp_s, const Vector3& acted) noexcept {
    const double dt_s = stamp_s - stamp_s_;
    if (!is_finite(position) || !std::isfinite(stamp_s) || !is_finite(acted)) {
        return Fault::none;
    }
    if (n_ == 0) {
        begin(position, stamp_s, acted);
        return Fault::none;
    }
    if (dt_s > 0.0) {
        const Vector3 motion = position - position_;
        watch_rest(motion, dt_s, acted);
        watch_turns(motion, dt_s);
        position_ = position;
        stamp_s_ = stamp_s;
        motion_ = motion;
        dt_s_ = dt_s;
        n_ = 2;
    }
    return (is_frozen_ ? Fault::device_stale : Fault::none) |
           (turns_ > kMostTurns ? Fault::device_invalid : Fault::none);
}

void SensorGuard::begin(const Vector3& position, double stamp_s, const Vector3& acted) noexcept {
    n_ = 1;
    position_ = position;
    stamp_s_ = stamp_s;
    is_frozen_ = false;
    still_s_ = 0.0;
    pushed_s_ = 0.0;
    rest_force_ = acted;
    turn_.setZero();
    turns_ = 0.0;
}

void SensorGuard::watch_rest(const Vector3& motion, double dt_s, const Vector3& acted) noexcept {
    const bool rests = motion.isZero(0.0);
    if (!rests) {
        is_frozen_ = false;
        still_s_ = 0.0;
        pushed_s_ = 0.0;
        rest_force_ = acted;
        return;
    }
    // A sensor that trembles is watched while somebody would feel it; one that does not, by what a push does to it.
    const bool is_felt = acted.norm() > kLeastFelt_N;
    still_s_ = is_felt ? still_s_ + dt_s : 0.0;
    const bool is_pushed =
        life_.moves_at_N > 0.0 && (acted - rest_force_).norm() > life_.moves_at_N;
    pushed_s_ = is_pushed ? pushed_s_ + dt_s : 0.0;
    is_frozen_ = is_frozen_ ||
                 (life_.trembles_within_s > 0.0 && still_s_ > life_.trembles_within_s) ||
                 pushed_s_ > kAnswer_s;
}

void SensorGuard::watch_turns(const Vector3& motion, double dt_s) noexcept {
    turns_ *= std::max(1.0 - dt_s / kWindow_s, 0.0);
    if (n_ < 2 || !(life_.most_m_per_s2 > 0.0)) {
        return;
    }
    const double ratio = dt_s / dt_s_;
    const Vector3 turn = motion - motion_ * ratio;
    const double most_m =
        0.5 * life_.most_m_per_s2 * dt_s * (dt_s + dt_s_) + 2.0 * resolution_m_ * (1.0 + ratio);
    if (!(turn.norm() > most_m)) {
        return;
    }
    turns_ += turn.dot(turn_) < 0.0 ? 1.0 : 0.0;
    turn_ = turn;
}

}  // namespace fulcrum
