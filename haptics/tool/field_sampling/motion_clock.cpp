#include "haptics/tool/field_sampling/motion_clock.h"

#include <cmath>

namespace fulcrum {

void MotionClock::rebase() noexcept {
    voxels_ = 0.0;
    now_ = 0.0F;
    turned_rad_ = 0.0;
}

bool MotionClock::is_to_rebase() const noexcept {
    constexpr double kLongest_voxels = 4096.0;
    constexpr double kLongestTurn_rad = 100.0;
    return voxels_ > kLongest_voxels || turned_rad_ > kLongestTurn_rad;
}

void MotionClock::advance(const Pose& X_OT, double reach_m, double voxel_m) noexcept {
    constexpr double kAbove = 1.0 + 1.0e-6;  // rounding
    if (has_last_) {
        const Quaternion turn = last_OT_.orientation.conjugate() * X_OT.orientation;
        const double turned_rad = 2.0 * turn.vec().norm();
        turned_rad_ += kAbove * turned_rad;
        voxels_ +=
            kAbove * ((X_OT.position - last_OT_.position).norm() + turned_rad * reach_m) / voxel_m;
    }
    now_ = std::nextafter(static_cast<float>(voxels_), HUGE_VALF);
    last_OT_ = X_OT;
    has_last_ = true;
}

}  // namespace fulcrum
