#include "haptics/loop/hand_guard.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

Fault HandGuard::step(const Wrench& acted, const Vector3& motion, const Vector3& turn,
                      double dt_s) noexcept {
    const double given_J = acted.force.dot(motion) + acted.torque.dot(turn);
    if (!(dt_s > 0.0) || !std::isfinite(dt_s) || !std::isfinite(given_J) || !is_finite(motion)) {
        return Fault::none;
    }
    velocity_ += (motion / dt_s - velocity_) * std::min(dt_s / kWindow_s, 1.0);
    const double kept = std::max(1.0 - dt_s / kMemory_s, 0.0);
    energy_J_ = std::max(energy_J_ * kept + given_J, 0.0);
    Fault faults = Fault::none;
    if (!(velocity_.norm() <= max_speed_)) {
        faults |= Fault::hand_too_fast;
    }
    if (!(energy_J_ <= max_energy_J_)) {
        faults |= Fault::too_much_energy;
    }
    return faults;
}

}  // namespace fulcrum
