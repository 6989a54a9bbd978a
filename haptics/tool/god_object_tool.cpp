#include "haptics/tool/god_object_tool.h"

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

}  // namespace fulcrum
