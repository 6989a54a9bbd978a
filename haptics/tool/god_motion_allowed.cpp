// Which way the contacts of god_motion.h allow: those that are near, and those that held the tool when something else stopped it.
#include "haptics/tool/god_force.h"
#include "haptics/tool/god_motion.h"

#include <algorithm>
#include <span>

namespace fulcrum {

void GodMotion::add(std::size_t i, const GodContact& contact, bool pushes) noexcept {
    const Vector3 normal_W = objects_W_[i].orientation * contact.normal_O;
    double least_m = settings_.gap_m - contact.gap_m;
    Vector3 carried_W = Vector3::Zero();
    if (!is_same(objects_W_[i], goals_W_[i])) {
        carried_W = goals_W_[i] * contact.on_object_O - objects_W_[i] * contact.on_object_O;
        least_m += normal_W.dot(carried_W);
    }
    const Vector3 arm_W = objects_W_[i] * contact.on_tool_O - pose_W_.position;
    least_m = pushes ? least_m : std::min(least_m, 0.0);
    if (has_friction_) {
        dragging_.add(arm_W, normal_W, least_m, find_friction(i, contact), carried_W);
    } else {
        solver_.add(arm_W, normal_W, least_m);
    }
}

const LeastConstraint& GodMotion::solve(const Vector6& wanted, bool pushes) noexcept {
    solver_.clear();
    dragging_.clear();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        for (const GodContact& contact : pairs_[i].contacts()) {
            add(i, contact, pushes);
        }
    }
    for (Recalled& one : std::span(recalled_).first(n_recalled_)) {
        GodContact& contact = one.contact;
        contact.on_tool_O = (objects_W_[one.object].inverse() * pose_W_) * one.on_tool_T;
        contact.gap_m = contact.normal_O.dot(contact.on_tool_O - contact.on_object_O);
        add(one.object, contact, pushes);
    }
    return has_friction_ ? dragging_.solve(wanted) : solver_.solve(wanted);
}

// The k-th of those that were told to the last solve.
bool GodMotion::acts(std::size_t k) const noexcept {
    return has_friction_ ? !dragging_.force_W(k).isZero(0.0) : solver_.force_N(k) > 0.0;
}

void GodMotion::forget_idle() noexcept {
    std::size_t n_kept = 0;
    const auto n_contacts = static_cast<std::size_t>(step_.contacts);
    for (std::size_t k = 0; k < n_recalled_; ++k) {
        if (acts(n_contacts + k)) {
            recalled_[n_kept++] = recalled_[k];
        }
    }
    n_recalled_ = n_kept;
}

void GodMotion::recall() noexcept {
    std::size_t k = 0;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        for (const GodContact& contact : pairs_[i].contacts()) {
            if (acts(k++) && n_recalled_ < kMostRecalled) {
                recalled_[n_recalled_++] = {
                    i, contact, (pose_W_.inverse() * objects_W_[i]) * contact.on_tool_O};
            }
        }
    }
}

Vector6 GodMotion::find_allowed(const Pose& wanted_W) noexcept {
    const Vector6 wanted = find_way(pose_W_, wanted_W);
    if (step_.contacts == 0 && n_recalled_ == 0) {
        return wanted;
    }
    const Matrix3 inertia_W = compute_inertia_W(settings_.inertia, pose_W_.orientation);
    if (has_friction_) {
        dragging_.set_inertia(settings_.inertia.mass_kg, inertia_W);
    } else {
        solver_.set_inertia(settings_.inertia.mass_kg, inertia_W);
    }
    const LeastConstraint& allowed = solve(wanted, true);
    return allowed.exact ? allowed.acceleration : solve(wanted, false).acceleration;
}

// Does all that holds it press? What is still away from it goes on.
bool GodMotion::is_held() const noexcept {
    std::size_t k = 0;
    for (const GodPair& pair : pairs_) {
        for (const GodContact& contact : pair.contacts()) {
            if (acts(k++) && !may_press(contact)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace fulcrum
