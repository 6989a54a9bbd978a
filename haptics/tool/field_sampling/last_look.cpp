#include "haptics/tool/field_sampling/last_look.h"

#include "haptics/math/length.h"

namespace fulcrum {

void LastLook::begin_step() noexcept {
    was_held_ = is_held_;
    is_held_ = false;
    is_known_in_step_ = false;
}

bool LastLook::is_known(const Pose& X_WO, const Pose& X_WT) const noexcept {
    const bool is_whole = touch_.weight == 1 && touch_.n_left == 0;
    return is_known_ && (is_whole || is_known_in_step_) && is_same(X_WO, X_WO_) &&
           is_same(X_WT, X_WT_);
}

void LastLook::remember(const Pose& X_WO, const Pose& X_WT, const FieldTouch& touch,
                        bool in_step) noexcept {
    X_WO_ = X_WO;
    X_WT_ = X_WT;
    touch_ = touch;
    is_known_ = true;
    is_known_in_step_ = in_step;
}

void LastLook::hold(const Pose& X_WO, bool is_cut_short, FieldTouch& touch) noexcept {
    const bool has_more = touch.n_left > 0 && (is_cut_short || touch.n_leaves == 0) &&
                          touch.n_touching < touch_.n_touching;
    if (!has_more || !is_known_ || was_held_) {
        return;
    }
    is_held_ = true;
    const Quaternion turned = X_WO.orientation * X_WO_.orientation.conjugate();
    const Wrench taken_W = touch.wrench_W;
    touch.wrench_W = {turned * touch_.wrench_W.force, turned * touch_.wrench_W.torque};
    touch.n_touching = touch_.n_touching;
    touch.deepest_m = touch_.deepest_m;
    touch.bound_N += compute_length(Vector3(touch.wrench_W.force - taken_W.force));
    touch.bound_Nm += compute_length(Vector3(touch.wrench_W.torque - taken_W.torque));
    touch.error_N = touch.bound_N;
    touch.error_Nm = touch.bound_Nm;
}

}  // namespace fulcrum
