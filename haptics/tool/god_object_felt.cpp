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
    for (std::size_t i = 0; i < pairs_.size() && is_followed_; ++i) {
        slips_[i] = {slips_[i].to_OT, objects_W_[i].inverse() * pose_W_};
    }
}

void GodObjectTool::forget_slips() noexcept {
    for (std::size_t i = 0; i < pairs_.size() && is_followed_; ++i) {
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

// The contacts push as the solver says, in whatever shares; here they share it evenly, so that nothing jumps from one to another.
bool GodObjectTool::share_pressure() noexcept {
    pressure_.clear();
    Vector6 pushed = Vector6::Zero();
    std::size_t k = 0;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        const Matrix3 R_WO = objects_W_[i].orientation.toRotationMatrix();
        if (const auto rough = std::ranges::find(rough_, i, &Rough::object);
            rough != rough_.end()) {
            rough->first = k;
        }
        for (const GodContact& contact : pairs_[i].contacts()) {
            if (!may_press(contact, settings_)) {
                continue;
            }
            const Vector3 arm_W =
                R_WO * contact.on_tool_O + objects_W_[i].position - pose_W_.position;
            const Vector3 normal_W = find_felt_normal_W(i, contact, R_WO);
            const Vector3 force_W = normal_W * normal_W.dot(force_.force_W(k++));
            pushed.head<3>() += force_W;
            pushed.tail<3>() += arm_W.cross(force_W);
            // What comes nearer begins to press little by little.
            const double gaps = contact.gap_m / settings_.gap_m;
            pressure_.add(arm_W, normal_W,
                          std::clamp((kPressGaps - gaps) / (kPressGaps - 1.0), 0.0, 1.0));
        }
    }
    return pressure_.solve(pushed);
}

// Of one object whose contacts are told from `rough.first` on.
void GodObjectTool::tell_relief(Rough& rough, bool presses, double dt_s) noexcept {
    const Pose& object_W = objects_W_[rough.object];
    const Matrix3 R_WO = object_W.orientation.toRotationMatrix();
    const std::span<const GodContact> contacts = pairs_[rough.object].contacts();
    double force_N = 0.0;
    std::size_t k = rough.first;
    for (const GodContact& contact : contacts) {
        force_N += presses && may_press(contact, settings_) ? pressure_.force_N(k++) : 0.0;
    }
    rough.texture.begin(slips_[rough.object].from_OT, slips_[rough.object].to_OT, force_N);
    k = rough.first;
    for (const GodContact& contact : contacts) {
        if (force_N > 0.0 && may_press(contact, settings_)) {
            rough.texture.add(contact.on_object_O,
                              R_WO.transpose() * find_felt_normal_W(rough.object, contact, R_WO),
                              pressure_.force_N(k++));
        }
    }
    const Wrench& felt_O = rough.texture.finish(dt_s);
    texture_W_.force += R_WO * felt_O.force;
    texture_W_.torque += R_WO * felt_O.torque;
}

void GodObjectTool::tell_texture(double dt_s) noexcept {
    texture_W_ = {};
    textured_N_ = 0.0;
    if (rough_.empty()) {
        return;
    }
    const double held_N = find_held_N();
    const bool presses = held_N > 0.0 && share_pressure();
    textured_N_ = presses ? held_N : 0.0;
    for (Rough& rough : rough_) {
        tell_relief(rough, presses, dt_s);
    }
}

double GodObjectTool::find_held_N() const noexcept {
    const Wrench held = force_.held();
    return held.force.norm() + held.torque.norm() / reach_m_;
}

Wrench GodObjectTool::find_texture(double held_N) const noexcept {
    if (!(textured_N_ > 0.0)) {
        return {};
    }
    const double share = std::min(held_N / textured_N_, 1.0);
    return {share * texture_W_.force, share * texture_W_.torque};
}

GodObjectTool::Felt GodObjectTool::feel(const Pose& handle_W) noexcept {
    const ToolCouplingSettings& coupling = settings_.coupling;
    const auto limit = [&](const Wrench& wrench) {
        return Wrench{
            limit_length(wrench.force, coupling.shift.stiffness_N_per_m * coupling.clamp_m),
            limit_length(wrench.torque, coupling.turn.stiffness_Nm_per_rad * coupling.clamp_rad)};
    };
    const Wrench held = force_.compute(find_held_W(handle_W));
    Felt felt;
    felt.contacts = about_grip(limit(held), handle_W);
    felt.all = felt.contacts;
    if (!rough_.empty()) {
        const Wrench texture = find_texture(find_held_N());
        felt.all =
            about_grip(limit({held.force + texture.force, held.torque + texture.torque}), handle_W);
    }
    return felt;
}

Wrench GodObjectTool::force(const Pose& handle_W) noexcept {
    return is_begun_ && is_place(handle_W) ? feel(handle_W).all : Wrench{};
}

}  // namespace fulcrum
