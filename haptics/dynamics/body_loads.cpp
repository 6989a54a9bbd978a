#include "haptics/dynamics/body_loads.h"

#include "haptics/dynamics/hand_rows.h"
#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

bool are_usable(const PushSlopes& slopes) noexcept {
    const double values[] = {slopes.stiffness_N_per_m, slopes.damping_Ns_per_m,
                             slopes.turn_stiffness_Nm_per_rad, slopes.turn_damping_Nms_per_rad,
                             slopes.late_mass_kg};
    return std::ranges::all_of(values,
                               [](double value) { return value >= 0.0 && std::isfinite(value); });
}

bool are_usable(const PushBounds& bounds) noexcept {
    const double values[] = {bounds.friction_N, bounds.most_N, bounds.most_Nm};
    return is_finite(bounds.along_W) && std::ranges::all_of(values, [](double value) {
               return value >= 0.0 && std::isfinite(value);
           });
}

}  // namespace

void BodyLoads::push(const Wrench& wrench_W, RigidWorldBody& body) noexcept {
    if (!is_finite(wrench_W)) {
        return;
    }
    body.load_W.force += wrench_W.force;
    body.load_W.torque += wrench_W.torque;
    body.touch();
}

void BodyLoads::hold(const BodyHold& hold, RigidWorldBody& body) noexcept {
    if (!are_usable(hold.slopes) || !are_usable(hold.bounds)) {
        return;
    }
    const Vector3 arm = hold.at_W - body.state.pose_W.position;
    if (!is_finite(Wrench{hold.push_W.force, hold.push_W.torque + arm.cross(hold.push_W.force)}) ||
        !std::isfinite(arm.squaredNorm())) {
        return;
    }
    Hand hand{hold, body.held};
    if (!hand.hold.bounds.along_W.isZero(0.0)) {
        hand.hold.bounds.along_W = compute_direction(hand.hold.bounds.along_W);
    }
    if (!hands_.add(hand)) {
        ++n_refused_;
        return;
    }
    body.held = static_cast<std::int32_t>(hands_.count()) - 1;
    body.touch();
}

void BodyLoads::carry(const RigidState& before, const RigidWorldBody& body) noexcept {
    for (std::int32_t i = body.held; i >= 0; i = at(i).next) {
        carry_hold(before, body.state, hands_[static_cast<std::size_t>(i)].hold);
    }
}

}  // namespace fulcrum
