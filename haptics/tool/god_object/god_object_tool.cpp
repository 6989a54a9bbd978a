#include "haptics/tool/god_object/god_object_tool.h"

#include "haptics/math/length.h"

#include <algorithm>

namespace fulcrum {
namespace {

bool is_felt(const Wrench& wrench) noexcept {
    return !wrench.force.isZero(0.0) || !wrench.torque.isZero(0.0);
}

}  // namespace

Pose GodObjectTool::find_held_W(const Pose& handle_W) const noexcept {
    Pose held;
    held.orientation = (handle_W.orientation * settings_.handle_turn).normalized();
    held.position = handle_W.position - held.orientation * settings_.grip_T;
    return held;
}

Pose GodObjectTool::grip_W() const noexcept {
    return {pose_W_ * settings_.grip_T, pose_W_.orientation * settings_.handle_turn.conjugate()};
}

void GodObjectTool::place(const Pose& handle_W) noexcept {
    pose_W_ = find_held_W(handle_W);
    if (settings_.own_motion) {
        motion_->place(pose_W_);
    }
    goal_.placed_W = pose_W_;
    ++goal_.n_placements;
    is_known_ = false;
    since_s_ = 0.0;
    age_.restart();
    force_.begin(pose_W_);
    force_.forget_blend();
    texture_W_ = {};
    textured_N_ = 0.0;
    for (Rough& rough : rough_) {
        rough.texture.forget();
    }
    std::ranges::fill(touches_, ToolTouch{});
}

bool GodObjectTool::is_free(std::span<const MovingFrame> objects) const noexcept {
    return motion_->is_free(pose_W_, objects);
}

// The motion's step, here.
GodObjectTool::News GodObjectTool::go(const Pose& held_W, std::span<const MovingFrame> objects,
                                      bool was_felt) noexcept {
    if (listener_ != nullptr) {
        listener_->begins_round();
    }
    News news = News::overlaps;
    if (motion_->move(held_W, objects, was_felt)) {
        news = motion_->tell(*own_set_) ? News::learnt : News::none;
        pose_W_ = own_set_->tool_W;
    }
    if (listener_ != nullptr) {
        listener_->ended_round();
    }
    return news;
}

void GodObjectTool::tell_goal(const Pose& held_W, std::span<const MovingFrame> objects,
                              double now_s) noexcept {
    goal_.stamp_s = now_s;
    goal_.held_W = held_W;
    goal_.n_objects = static_cast<std::int32_t>(objects.size());
    std::ranges::copy(objects, goal_.objects.begin());
    channels_->goal.publish(goal_);
}

GodObjectTool::News GodObjectTool::take_set() noexcept {
    if (!channels_->set.take() || set().n_placements != goal_.n_placements) {
        return News::none;
    }
    return set().is_apart ? News::learnt : News::overlaps;
}

ToolFelt GodObjectTool::move(const MovingFrame& handle, std::span<const MovingFrame> objects,
                             double now_s, double dt_s) noexcept {
    ToolFelt nothing;
    nothing.moved = false;
    if (objects.size() != touches_.size() || !is_place(handle) || !(dt_s > 0.0) ||
        !std::ranges::all_of(objects, [](const MovingFrame& one) { return is_place(one); })) {
        return nothing;
    }
    const Pose held_W = find_held_W(handle.pose_W);
    const bool was_felt = is_felt(force_.compute(held_W));
    force_.keep(held_W);
    // What holds the tool.
    News news = News::none;
    if (settings_.own_motion) {
        news = go(held_W, objects, was_felt);
    } else {
        tell_goal(held_W, objects, now_s);
        news = take_set();
    }
    if (news == News::overlaps) {
        return nothing;
    }
    const bool is_new = news == News::learnt;
    since_s_ += dt_s;
    if (is_new) {
        tell_force();
    }
    if (!settings_.own_motion) {
        age_.step(now_s, is_known_ ? set().stamp_s : -1.0, dt_s);
    }
    // What that is felt like.
    force_.blend(held_W, dt_s, is_known_ && set().is_near);
    tell_touches();
    if (is_new) {
        tell_texture(since_s_);
        since_s_ = 0.0;
    }
    return tell_felt(handle.pose_W, is_new);
}

namespace {

bool is_of(const GodPress& press, std::size_t object) noexcept {
    return static_cast<std::size_t>(press.object) == object;
}

}  // namespace

Wrench GodObjectTool::about_grip(const Wrench& about_centre, const Pose& handle_W) const noexcept {
    // The hand holds the tool stiffly where it would have it: the force acts there.
    const Vector3 arm_W = find_held_W(handle_W).position - handle_W.position;
    return {about_centre.force, about_centre.torque + arm_W.cross(about_centre.force)};
}

// The set is what holds the tool from now on.
void GodObjectTool::tell_force() noexcept {
    const bool was_known = is_known_;
    is_known_ = true;
    pose_W_ = set().tool_W;
    force_.begin(pose_W_);
    for (const GodPress& press : presses()) {
        force_.add(press.arm_W, press.normal_W, press.least_m, press.friction);
    }
    for (std::size_t i = 0; i < seen_OT_.size() && !was_known; ++i) {
        seen_OT_[i] = set().objects[i].from_OT;
    }
}

void GodObjectTool::tell_touches() noexcept {
    std::ranges::fill(touches_, ToolTouch{});
    const std::span<const GodPress> all = presses();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Vector3 force_W = force_.force_W(k);
        if (!force_W.isZero(0.0)) {
            ToolTouch& touch = touches_[static_cast<std::size_t>(all[k].object)];
            add_point_force(all[k].arm_W, force_W, touch.wrench_W);
            touch.touches = true;
        }
    }
}

// The contacts push as the solver says, in whatever shares; here they share it evenly, so that nothing jumps from one to another.
bool GodObjectTool::share_pressure() noexcept {
    pressure_.clear();
    Vector6 pushed = Vector6::Zero();
    const std::span<const GodPress> all = presses();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const GodPress& press = all[k];
        const Vector3 force_W = press.normal_W * press.normal_W.dot(force_.force_W(k));
        pushed.head<3>() += force_W;
        pushed.tail<3>() += press.arm_W.cross(force_W);
        pressure_.add(press.arm_W, press.normal_W, press.share);
    }
    return pressure_.solve(pushed);
}

void GodObjectTool::tell_relief(Rough& rough, bool is_pressed, double dt_s) noexcept {
    const GodObjectPlace& place = set().objects[rough.object];
    const Matrix3 R_WO = place.object_W.orientation.toRotationMatrix();
    const std::span<const GodPress> all = presses();
    double force_N = 0.0;
    for (std::size_t k = 0; k < all.size() && is_pressed; ++k) {
        force_N += is_of(all[k], rough.object) ? pressure_.force_N(k) : 0.0;
    }
    // On from the last set that was taken: others may have come and gone in between.
    rough.texture.begin(seen_OT_[rough.object], place.to_OT, force_N);
    for (std::size_t k = 0; k < all.size() && force_N > 0.0; ++k) {
        if (is_of(all[k], rough.object)) {
            rough.texture.add(all[k].on_object_O, R_WO.transpose() * all[k].normal_W,
                              pressure_.force_N(k));
        }
    }
    seen_OT_[rough.object] = place.to_OT;
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
    const bool is_pressed = held_N > 0.0 && share_pressure();
    textured_N_ = is_pressed ? held_N : 0.0;
    for (Rough& rough : rough_) {
        tell_relief(rough, is_pressed, dt_s);
    }
}

double GodObjectTool::find_held_N() const noexcept {
    const Wrench held = force_.held();
    return held.force.norm() + held.torque.norm() / motion_->reach_m();
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
    if (!is_known_ || !is_place(handle_W)) {
        return {};
    }
    const Wrench all = feel(handle_W).all;
    return {age_.share() * all.force, age_.share() * all.torque};
}

// A wall pushes with K depth along its own normal t; along n, the even one, the constraint solver pushes with K depth (t . n), so that
// f (n - t / (t . n)) is what turning adds, f what is pushed with.
void GodObjectTool::tell_even(const Pose& handle_W, ToolFelt& felt) const noexcept {
    Wrench even_W;
    const std::span<const GodPress> all = presses();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const GodPress& press = all[k];
        const double pushed_N = force_.force_W(k).dot(press.normal_W);
        if (pushed_N > 0.0) {
            const Vector3 turned = press.normal_W - press.true_W / press.true_W.dot(press.normal_W);
            add_point_force(press.arm_W, pushed_N * turned, even_W);
            felt.even_J += pushed_N * bumps_m_[static_cast<std::size_t>(press.object)];
        }
    }
    // As much of it as the coupling's limits, and an answer's age, leave of the contacts' wrench.
    const ToolCouplingSettings& coupling = settings_.coupling;
    const Wrench held = force_.held();
    const auto share_of = [&](const Vector3& whole, double most) {
        const double size = whole.norm();
        return age_.share() * (most > 0.0 && size > most ? most / size : 1.0);
    };
    const double by_force =
        share_of(held.force, coupling.shift.stiffness_N_per_m * coupling.clamp_m);
    const double by_torque =
        share_of(held.torque, coupling.turn.stiffness_Nm_per_rad * coupling.clamp_rad);
    felt.even_W = about_grip({by_force * even_W.force, by_torque * even_W.torque}, handle_W);
    felt.even_J *= by_force;
}

// Of answers that are late less and less.
ToolFelt GodObjectTool::tell_felt(const Pose& handle_W, bool is_new) noexcept {
    ToolFelt felt;
    const Felt told = feel(handle_W);
    const double share = age_.share();
    felt.felt_W = {share * told.all.force, share * told.all.torque};
    felt.spring_W = {share * told.contacts.force, share * told.contacts.torque};
    felt.texture_W = {felt.felt_W.force - felt.spring_W.force,
                      felt.felt_W.torque - felt.spring_W.torque};
    if (!bumps_m_.empty()) {
        tell_even(handle_W, felt);
    }
    for (const Rough& rough : rough_) {
        felt.bumps_J += rough.texture.bumps_J();
    }
    const double stiffness = settings_.coupling.shift.stiffness_N_per_m;
    felt.spring_energy_J =
        stiffness > 0.0 ? compute_shift_energy_J(settings_.coupling,
                                                 compute_length(felt.spring_W.force) / stiffness)
                        : 0.0;
    const GodObjectStep step = last_step();
    felt.effort.n_looks = step.rounds + 1;
    felt.effort.n_points = step.contacts;
    // Of a motion beside each step is told once, with those before it that were not.
    const bool is_told = settings_.own_motion || is_new;
    const bool is_settled = step.settled && (settings_.own_motion || step.unsettled == 0);
    felt.effort.tell(ToolLack::unsettled, is_told && !is_settled);
    felt.effort.tell(ToolLack::wedged, is_told && step.wedged);
    felt.effort.tell(ToolLack::crowded, is_told && step.too_many);
    felt.effort.tell(ToolLack::inexact, !force_.is_exact());
    return felt;
}

}  // namespace fulcrum
