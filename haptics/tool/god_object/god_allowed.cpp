#include "haptics/tool/god_object/god_allowed.h"

#include "haptics/tool/god_object/god_force.h"
#include "haptics/tool/god_object/god_presses.h"

#include <algorithm>
#include <span>

namespace fulcrum {

void GodAllowed::add(const GodPairs& pairs, const GodSlips& slips, std::size_t i,
                     const GodContact& contact, bool pushes) noexcept {
    const Pose& object_W = pairs.object_W(i);
    const Vector3 normal_W = object_W.orientation * contact.normal_O;
    double least_m = gap_m_ - contact.gap_m;
    Vector3 carried_W = Vector3::Zero();
    if (pairs.moves(i)) {
        carried_W = pairs.goal_W(i) * contact.on_object_O - object_W * contact.on_object_O;
        least_m += normal_W.dot(carried_W);
    }
    const Vector3 arm_W = object_W * contact.on_tool_O - pairs.tool_W().position;
    least_m = pushes ? least_m : std::min(least_m, 0.0);
    if (has_friction_) {
        dragging_.add(arm_W, normal_W, least_m, slips.find_friction(i, contact), carried_W);
    } else {
        solver_.add(arm_W, normal_W, least_m);
    }
}

const LeastConstraint& GodAllowed::solve(const GodPairs& pairs, const GodSlips& slips,
                                         const Vector6& wanted, bool pushes) noexcept {
    solver_.clear();
    dragging_.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        for (const GodContact& contact : pairs.all()[i].contacts()) {
            add(pairs, slips, i, contact, pushes);
        }
    }
    for (Recalled& one : std::span(recalled_).first(n_recalled_)) {
        GodContact& contact = one.contact;
        contact.on_tool_O = pairs.seen_OT(one.object) * one.on_tool_T;
        contact.gap_m = contact.normal_O.dot(contact.on_tool_O - contact.on_object_O);
        add(pairs, slips, one.object, contact, pushes);
    }
    return has_friction_ ? dragging_.solve(wanted) : solver_.solve(wanted);
}

// The k-th of those that were told to the last solve.
bool GodAllowed::acts(std::size_t k) const noexcept {
    return has_friction_ ? !dragging_.force_W(k).isZero(0.0) : solver_.force_N(k) > 0.0;
}

void GodAllowed::forget_idle(const GodPairs& pairs) noexcept {
    std::size_t n_kept = 0;
    const auto n_contacts = static_cast<std::size_t>(pairs.found().contacts);
    for (std::size_t k = 0; k < n_recalled_; ++k) {
        if (acts(n_contacts + k)) {
            recalled_[n_kept++] = recalled_[k];
        }
    }
    n_recalled_ = n_kept;
}

void GodAllowed::recall(const GodPairs& pairs) noexcept {
    std::size_t k = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        for (const GodContact& contact : pairs.all()[i].contacts()) {
            if (acts(k++) && n_recalled_ < kMostRecalled) {
                recalled_[n_recalled_++] = {
                    i, contact, (pairs.tool_W().inverse() * pairs.object_W(i)) * contact.on_tool_O};
            }
        }
    }
}

Vector6 GodAllowed::find(const GodPairs& pairs, const GodSlips& slips,
                         const Pose& wanted_W) noexcept {
    const Vector6 wanted = find_way(pairs.tool_W(), wanted_W);
    if (pairs.found().contacts == 0 && n_recalled_ == 0) {
        return wanted;
    }
    const Matrix3 inertia_W = compute_inertia_W(inertia_, pairs.tool_W().orientation);
    if (has_friction_) {
        dragging_.set_inertia(inertia_.mass_kg, inertia_W);
    } else {
        solver_.set_inertia(inertia_.mass_kg, inertia_W);
    }
    const LeastConstraint& allowed = solve(pairs, slips, wanted, true);
    return allowed.exact ? allowed.acceleration : solve(pairs, slips, wanted, false).acceleration;
}

bool GodAllowed::is_held(const GodPairs& pairs) const noexcept {
    std::size_t k = 0;
    for (const GodPair& pair : pairs.all()) {
        for (const GodContact& contact : pair.contacts()) {
            if (acts(k++) && !may_press(contact, gap_m_)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace fulcrum
