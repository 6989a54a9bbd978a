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

// A drag is that of the face on which friction was solved. On the one where the proxy came to lie its part out of it pushes, and the rest is
// held as far as that may be held: by all that the solid pushes, for of two faces that were only just met one has all of the drag.
void lay_along(const SolidTouch& touch, std::span<const SolidTouch> all,
               DampedPlane& plane) noexcept {
    const double out = touch.drag_W.dot(touch.normal_W);
    double pushes = out;
    for (const SolidTouch& other : all) {
        pushes += other.solid == touch.solid ? other.push_m : 0.0;
    }
    plane.push_N = std::max(touch.push_m + out, 0.0);
    plane.drag_N_W =
        shorten<3>(touch.drag_W - out * touch.normal_W,
                   touch.friction_coefficient * std::max(pushes, 0.0) + touch.viscous_m);
}

}  // namespace

const CouplingSettings& ContactStage::coupling_of(std::int32_t solid) const noexcept {
    const auto i = static_cast<std::size_t>(solid);
    return solid >= 0 && i < couplings_.size() ? couplings_[i] : common_;
}

// A proxy that names no planes has one, its normal. Planes are in metres of stretch yet.
void ContactStage::take_touches(const ProxyContact& contact, std::span<const Vector3> velocities_W,
                                double stretch_m) noexcept {
    n_touches_ = 0;
    for (const SolidTouch& touch : contact.active()) {
        planes_[n_touches_] = {.normal_W = touch.normal_W,
                               .push_N = touch.push_m,
                               .drag_N_W = touch.drag_W,
                               .friction_coefficient = touch.friction_coefficient};
        touches_[n_touches_++] = {touch.solid, touch.normal_W, touch.push_m, 0.0};
    }
    if (n_touches_ == 0) {
        planes_[0] = {.normal_W = contact.normal_W, .push_N = stretch_m};
        touches_[n_touches_++] = {contact.solid, contact.normal_W, stretch_m, 0.0};
    }
    for (std::size_t i = 0; i < n_touches_; ++i) {
        planes_[i].velocity_W = velocities_W[std::min(i, velocities_W.size() - 1)];
        planes_[i].damping_Ns_per_m = coupling_of(touches_[i].solid).damping_Ns_per_m;
    }
}

ContactForce ContactStage::step(const ProxyContact& contact, const Vector3& hand_W,
                                std::span<const Vector3> velocities_W,
                                std::span<const Pose> solid_poses_W) noexcept {
    const double stretch_m = compute_length(Vector3(contact.position_W - hand_W));
    take_touches(contact, velocities_W, stretch_m);
    double pushes_m = 0.0;
    for (const TouchForce& touch : touches()) {
        pushes_m += touch.depth_m;
    }
    // Each touch's spring by its share of the push.
    ContactForce felt;
    for (const TouchForce& touch : touches()) {
        const CouplingSettings& coupling = coupling_of(touch.solid);
        const double share =
            pushes_m > 0.0 ? touch.depth_m / pushes_m : 1.0 / static_cast<double>(n_touches_);
        felt.spring.force += share * compute_coupling_spring(coupling, contact.position_W, hand_W);
        felt.spring.energy_J += share * compute_spring_energy_J(coupling, stretch_m);
    }
    felt.spring.normal = contact.normal_W;
    const Vector3 plain_W = felt.spring.force;
    const double force_N = compute_length(plain_W);
    double held_m = stretch_m;
    if (!shading_.empty() && shade(contact, solid_poses_W)) {
        Vector3 held_W = Vector3::Zero();
        for (const DampedPlane& plane : std::span(planes_.data(), n_touches_)) {
            held_W += plane.push_N * plane.normal_W + plane.drag_N_W;
        }
        if (held_W.squaredNorm() > 0.0) {
            held_m = compute_length(held_W);
            felt.spring.force = held_W * (force_N / held_m);
            felt.spring.normal = touches_[0].normal_W;
        }
    }
    for (std::size_t i = 0; i < n_touches_; ++i) {
        touches_[i].stiffness_N_per_m = stretch_m > 0.0 ? force_N / stretch_m : 0.0;
    }
    const ContactDamping damping = damp(held_m > 0.0 ? force_N / held_m : 0.0);
    felt.counted = shading_.empty() ? ElasticForce{plain_W, plain_W}
                                    : count({plain_W, felt.spring.energy_J},
                                            felt.spring.force - plain_W + damping.eased_W, hand_W,
                                            solid_poses_W);
    felt.force_W = felt.spring.force + damping.force_W;
    felt.force_W -= std::min(felt.force_W.dot(felt.spring.normal), 0.0) * felt.spring.normal;
    felt.spring.push = felt.force_W.dot(felt.spring.normal);
    return felt;
}

// The touched solid whose even normals do most; kNoBody where none has any.
std::int32_t ContactStage::find_shaded() const noexcept {
    std::int32_t found = kNoBody;
    for (const TouchForce& touch : touches()) {
        const auto solid = static_cast<std::size_t>(touch.solid);
        if (touch.solid >= 0 && solid < shading_.size() && shading_[solid] &&
            (found == kNoBody ||
             shading_[solid]->bump_m() > shading_[static_cast<std::size_t>(found)]->bump_m())) {
            found = touch.solid;
        }
    }
    return found;
}

bool ContactStage::touches_only(std::int32_t solid) const noexcept {
    return std::ranges::all_of(touches(),
                               [=](const TouchForce& touch) { return touch.solid == solid; });
}

// What of the spring's force gives back the hand's work: all of it as it was, and what shading turned of it as far as that is lent. The
// hand's way is that against the solid: what moves on with the hand gives it nothing by its facets.
ElasticForce ContactStage::count(const PlainSpring& plain, const Vector3& lent_W,
                                 const Vector3& hand_W,
                                 std::span<const Pose> solid_poses_W) noexcept {
    ElasticForce counted{plain.force_W, plain.force_W};
    const std::int32_t solid = find_shaded();
    if (solid == kNoBody || static_cast<std::size_t>(solid) >= solid_poses_W.size()) {
        loan_.leave(period_s_);
        lender_ = kNoBody;
        return counted;
    }
    const auto index = static_cast<std::size_t>(solid);
    const Pose& pose_W = solid_poses_W[index];
    const bool is_only = touches_only(solid);
    Vector3 moved_W = Vector3::Zero();
    Vector3 against_W = Vector3::Zero();
    if (lender_ != kNoBody) {
        // What was not touched in the round before is taken to stand still.
        moved_W = hand_W - hand_W_;
        against_W = solid == lender_ ? Vector3(hand_W - pose_W * hand_B_) : moved_W;
    }
    if (solid != lender_) {
        unpaid_J_ = 0.0;
    }
    // What the proxy let go of as it slipped: the hand has paid it, and none of it comes back. What the spring gained by more than its work is
    // taken off first.
    double paid_J = 0.0;
    if (pays_slips_ && solid == lender_ && is_only && only_lender_) {
        const double slipped_J = plain_.energy_J - plain.energy_J -
                                 0.5 * (plain_.force_W + plain.force_W).dot(against_W);
        paid_J = std::max(slipped_J - unpaid_J_, 0.0);
        unpaid_J_ = std::max(unpaid_J_ - slipped_J, 0.0);
    }
    loan_.allow(compute_length(plain.force_W) * shading_[index]->bump_m(), period_s_);
    counted += loan_.step_evenly(lent_W, moved_W, against_W, paid_J);
    lender_ = solid;
    only_lender_ = is_only;
    plain_ = plain;
    hand_W_ = hand_W;
    hand_B_ = pose_W.inverse() * hand_W;
    return counted;
}

void ContactStage::leave() noexcept {
    n_touches_ = 0;
    if (!shading_.empty()) {
        lender_ = kNoBody;
        loan_.leave(period_s_);
    }
}

// What the touches' dampers add, with a spring of so many newtons a metre.
ContactDamping ContactStage::damp(double N_per_m) noexcept {
    const std::span planes(planes_.data(), n_touches_);
    for (DampedPlane& plane : planes) {
        plane.push_N *= N_per_m;
        plane.drag_N_W *= N_per_m;
    }
    return compute_contact_damping(planes);
}

// Turns the touches' normals, and what friction holds with them; false where none of them is shaded.
bool ContactStage::shade(const ProxyContact& contact,
                         std::span<const Pose> solid_poses_W) noexcept {
    bool any = false;
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
            lay_along(touch, contact.active(), planes_[i]);
            planes_[i].drag_N_W =
                turn_along(touch.normal_W, touches_[i].normal_W, planes_[i].drag_N_W);
            planes_[i].normal_W = touches_[i].normal_W;
            any = true;
        }
    }
    return any;
}

}  // namespace fulcrum
