// The step path of contact_stage.h.
#include "haptics/loop/contact_stage.h"

#include "haptics/coupling/virtual_coupling.h"
#include "haptics/math/length.h"

#include <algorithm>

namespace fulcrum {
namespace {

// `v` turned by the least turn that takes the unit vector `from` to `to`: two mirrors, through half way and through `to`.
Vector3 turn_along(const Vector3& from, const Vector3& to, const Vector3& v) noexcept {
    constexpr double kOpposite = 1.0e-6;
    const double half = 1.0 + from.dot(to);
    return half > kOpposite
               ? Vector3(v - (from + to).dot(v) / half * (from + to) + 2.0 * from.dot(v) * to)
               : v;
}

}  // namespace

const CouplingSettings& ContactStage::coupling_of(std::int32_t solid) const noexcept {
    const auto i = static_cast<std::size_t>(solid);
    return solid >= 0 && i < couplings_.size() ? couplings_[i] : common_;
}

// A proxy that names no planes has one, its normal.
void ContactStage::take_touches(const ProxyContact& contact, double stretch_m) noexcept {
    n_touches_ = 0;
    for (const SolidTouch& touch : contact.active()) {
        touches_[n_touches_++] = {touch.solid, touch.normal_W, touch.push_m, 0.0};
    }
    if (n_touches_ == 0) {
        touches_[n_touches_++] = {contact.solid, contact.normal_W, stretch_m, 0.0};
    }
}

ContactForce ContactStage::step(const ProxyContact& contact, const Vector3& hand_W,
                                const Vector3& relative_velocity_W,
                                std::span<const Pose> solid_poses_W) noexcept {
    const double stretch_m = compute_length(Vector3(contact.position_W - hand_W));
    take_touches(contact, stretch_m);
    double pushes_m = 0.0;
    for (const TouchForce& touch : touches()) {
        pushes_m += touch.depth_m;
    }
    // Each touch's coupling by its share of the push.
    ContactForce felt;
    CouplingSettings damper{.stiffness_N_per_m = 0.0, .damping_Ns_per_m = 0.0};
    for (const TouchForce& touch : touches()) {
        const CouplingSettings& coupling = coupling_of(touch.solid);
        const double share =
            pushes_m > 0.0 ? touch.depth_m / pushes_m : 1.0 / static_cast<double>(n_touches_);
        felt.spring.force += share * compute_coupling_spring(coupling, contact.position_W, hand_W);
        felt.spring.energy_J += share * compute_spring_energy_J(coupling, stretch_m);
        damper.damping_Ns_per_m += share * coupling.damping_Ns_per_m;
    }
    felt.spring.normal = contact.normal_W;
    const double force_N = compute_length(felt.spring.force);
    for (std::size_t i = 0; i < n_touches_; ++i) {
        touches_[i].stiffness_N_per_m = stretch_m > 0.0 ? force_N / stretch_m : 0.0;
    }
    if (!shading_.empty()) {
        const Vector3 turned_W = shade(contact, solid_poses_W);
        if (turned_W.squaredNorm() > 0.0) {
            felt.spring.force = force_N * compute_direction(turned_W);
            felt.spring.normal = touches_[0].normal_W;
        }
    }
    felt.force_W =
        compute_contact_force(damper, felt.spring.force, relative_velocity_W, felt.spring.normal);
    felt.spring.push = felt.force_W.dot(felt.spring.normal);
    return felt;
}

// Turns the touches' normals; returns where the whole force points then, zero where nothing is shaded.
Vector3 ContactStage::shade(const ProxyContact& contact,
                            std::span<const Pose> solid_poses_W) noexcept {
    bool any = false;
    Vector3 pushes_W = Vector3::Zero();
    Vector3 drags_W = Vector3::Zero();
    for (std::size_t i = 0; i < contact.active().size(); ++i) {
        const SolidTouch& touch = contact.touches[i];
        const auto solid = static_cast<std::size_t>(touch.solid);
        if (touch.feature >= 0 && solid < std::min(shading_.size(), solid_poses_W.size()) &&
            shading_[solid]) {
            const Pose& pose_W = solid_poses_W[solid];
            const Quaternion turn_BW = pose_W.orientation.conjugate();
            touches_[i].normal_W =
                pose_W.orientation *
                shading_[solid]->normal_B(touch.feature,
                                          turn_BW * (contact.position_W - pose_W.position),
                                          turn_BW * touch.normal_W);
            any = true;
        }
        pushes_W += touch.push_m * touches_[i].normal_W;
        drags_W += turn_along(touch.normal_W, touches_[i].normal_W, touch.drag_W);
    }
    return any ? Vector3(pushes_W + drags_W) : Vector3(Vector3::Zero());
}

}  // namespace fulcrum
