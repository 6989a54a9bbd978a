// What the hand and the objects feel of god_object_tool.h, and how contacts hold along themselves.
#include "haptics/math/length.h"
#include "haptics/tool/god_object_tool.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kPressGaps = 2.0;  // what is within so many may press
constexpr double kPressRise =
    0.05;  // likewise; of a gap: what rounding and the last round leave of a flat contact
constexpr double kSlipShare = 1.0e-3;  // of the gap at rest: what goes so far in a step slips

bool may_press(const GodContact& contact, const GodObjectSettings& settings) noexcept {
    return contact.gap_m <= kPressGaps * settings.gap_m &&
           contact.rise_m <= kPressRise * settings.gap_m;
}

}  // namespace

Wrench GodObjectTool::about_grip(const Wrench& about_centre, const Pose& handle_W) const noexcept {
    // The hand holds the tool stiffly where it would have it: the force acts there.
    const Vector3 arm_W = find_held_W(handle_W).position - handle_W.position;
    return {about_centre.force, about_centre.torque + arm_W.cross(about_centre.force)};
}

// Of a place of the tool over the object, in the step before: it holds by the static coefficient what did not slip.
double GodObjectTool::find_friction(std::size_t i, const GodContact& contact) const noexcept {
    const FrictionSettings& friction = frictions_[i];
    if (friction.static_coefficient == friction.dynamic_coefficient) {
        return friction.dynamic_coefficient;
    }
    const Slip& slip = slips_[i];
    const Vector3 at_T = slip.to_OT.inverse() * contact.on_tool_O;
    const Vector3 slip_O = slip.to_OT * at_T - slip.from_OT * at_T;
    const Vector3 along_O = slip_O - contact.normal_O * contact.normal_O.dot(slip_O);
    return along_O.norm() > kSlipShare * settings_.gap_m ? friction.dynamic_coefficient
                                                         : friction.static_coefficient;
}

Vector3 GodObjectTool::find_felt_normal_W(std::size_t i, const GodContact& contact,
                                          const Matrix3& R_WO) const noexcept {
    if (shadings_.empty()) {
        return R_WO * contact.normal_O;
    }
    const Pose X_OT = objects_W_[i].inverse() * pose_W_;
    return R_WO *
           find_felt_normal_O(shadings_[i].object.get(), shadings_[i].tool.get(), contact, X_OT);
}

void GodObjectTool::note_slips() noexcept {
    for (std::size_t i = 0; i < pairs_.size() && has_friction_; ++i) {
        slips_[i] = {slips_[i].to_OT, objects_W_[i].inverse() * pose_W_};
    }
}

void GodObjectTool::forget_slips() noexcept {
    for (std::size_t i = 0; i < pairs_.size() && has_friction_; ++i) {
        const Pose at_OT = objects_W_[i].inverse() * pose_W_;
        slips_[i] = {at_OT, at_OT};
    }
}

void GodObjectTool::tell_force() noexcept {
    force_.begin(pose_W_);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        const Matrix3 R_WO = objects_W_[i].orientation.toRotationMatrix();
        for (const GodContact& contact : pairs_[i].contacts()) {
            if (!may_press(contact, settings_)) {
                continue;
            }
            const Vector3 arm_W =
                R_WO * contact.on_tool_O + objects_W_[i].position - pose_W_.position;
            force_.add(arm_W, find_felt_normal_W(i, contact, R_WO),
                       std::min(settings_.gap_m - contact.gap_m, 0.0), find_friction(i, contact));
        }
    }
}

void GodObjectTool::tell_touches() noexcept {
    std::size_t k = 0;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        const Matrix3 R_WO = objects_W_[i].orientation.toRotationMatrix();
        touches_[i] = {};
        for (const GodContact& contact : pairs_[i].contacts()) {
            const Vector3 force_W =
                may_press(contact, settings_) ? force_.force_W(k++) : Vector3(Vector3::Zero());
            if (!force_W.isZero(0.0)) {
                add_point_force(
                    R_WO * contact.on_tool_O + objects_W_[i].position - pose_W_.position, force_W,
                    touches_[i].wrench_W);
                touches_[i].touches = true;
            }
        }
    }
}

Wrench GodObjectTool::force(const Pose& handle_W) noexcept {
    if (!is_begun_ || !is_finite(handle_W)) {
        return {};
    }
    Wrench felt = force_.compute(find_held_W(handle_W));
    const ToolCouplingSettings& coupling = settings_.coupling;
    felt.force = limit_length(felt.force, coupling.shift.stiffness_N_per_m * coupling.clamp_m);
    felt.torque =
        limit_length(felt.torque, coupling.turn.stiffness_Nm_per_rad * coupling.clamp_rad);
    return about_grip(felt, handle_W);
}

}  // namespace fulcrum
