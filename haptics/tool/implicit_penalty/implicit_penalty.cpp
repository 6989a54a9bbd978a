#include "haptics/tool/implicit_penalty/implicit_penalty.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kNearRises_s = 0.005;  // and falls: a step of 1 ms is a fifth of what comes

}  // namespace

Pose ImplicitPenaltyTool::held_W() const noexcept {
    return {state_.pose_W * settings_.grip_T, state_.pose_W.orientation};
}

Pose ImplicitPenaltyTool::grip_W() const noexcept {
    Pose grip = held_W();
    grip.orientation = grip.orientation * settings_.handle_turn.conjugate();
    return grip;
}

void ImplicitPenaltyTool::place(const Pose& handle_W) noexcept {
    state_ = {};
    state_.pose_W.orientation = handle_W.orientation * settings_.handle_turn;
    state_.pose_W.position = handle_W.position - state_.pose_W.orientation * settings_.grip_T;
    planes_.clear();
    taylor_.clear();
    ++place_.n_placements;
    age_.restart();
    round_due_s_ = 0.0;
    near_share_ = 0.0;
    std::ranges::fill(touches_, ToolTouch{});
}

bool ImplicitPenaltyTool::is_free(std::span<const MovingFrame> objects) const noexcept {
    if (objects.size() != touches_.size() || !are_finite(objects)) {
        return false;
    }
    ContactLoop& asked = asked_ != nullptr ? *asked_ : *loop_;
    return asked.is_free(state_.pose_W, objects, settings_.contacts.within_m);
}

// As all was when the step began.
void ImplicitPenaltyTool::tell_place(std::span<const MovingFrame> objects, double began_s,
                                     double dt_s) noexcept {
    place_.stamp_s = began_s;
    place_.tool = {state_.pose_W, state_.velocity_W};
    place_.n_objects = static_cast<std::int32_t>(objects.size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        place_.objects[i] = move_evenly(objects[i], -dt_s);
    }
    channels_->place.publish(place_);
}

void ImplicitPenaltyTool::take_model(double began_s) noexcept {
    const bool at_once = settings_.own_rounds && settings_.round_s == 0.0;
    const bool is_due = settings_.own_rounds && began_s >= round_due_s_;
    if (at_once) {
        loop_->step(began_s);
    }
    if ((!settings_.own_rounds || is_due) && channels_->model.take() &&
        model().n_placements == place_.n_placements) {
        if (settings_.contacts.model == PenaltyModel::planes) {
            planes_.learn(model());
        } else {
            taylor_.learn(model());
        }
    }
    if (is_due && !at_once) {
        // Found now, told at the next round. A rounding less, so that rounds stay in step with the steps.
        loop_->step(began_s);
        round_due_s_ = began_s + settings_.round_s * (1.0 - 1.0e-9);
    }
}

void ImplicitPenaltyTool::note_age(double began_s, double dt_s) noexcept {
    if (!settings_.own_rounds) {
        const bool is_of_here = model().n_placements == place_.n_placements;
        age_.step(began_s, is_of_here ? model().stamp_s : -1.0, dt_s);
    }
}

bool ImplicitPenaltyTool::is_near() const noexcept {
    return settings_.contacts.model == PenaltyModel::planes ? planes_.is_near() : taylor_.is_near();
}

// The coupling drags the tool's mass before anything touches: with the first cluster that comes bit by bit, with the last it goes so.
void ImplicitPenaltyTool::note_near(double dt_s) noexcept {
    if (!settings_.silent_in_free_space) {
        near_share_ = 1.0;
        return;
    }
    const double step = dt_s / kNearRises_s;
    near_share_ = std::clamp(near_share_ + (is_near() ? step : -step), 0.0, 1.0);
}

void ImplicitPenaltyTool::tell_touches(std::span<const MovingFrame> objects) noexcept {
    std::ranges::fill(touches_, ToolTouch{});
    if (settings_.contacts.model != PenaltyModel::planes) {
        for (std::size_t i = 0; i < objects.size(); ++i) {
            touches_[i].wrench_W = taylor_.compute_wrench_of(static_cast<std::int32_t>(i), state_);
            touches_[i].touches = touches_[i].wrench_W.force != Vector3::Zero();
        }
        return;
    }
    const std::span<const PlaneContact> planes = planes_.planes();
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const double push_N = compute_push_N(planes[i], state_);
        if (push_N > 0.0) {
            ToolTouch& touch = touches_[static_cast<std::size_t>(planes_.object(i))];
            add_point_force(state_.pose_W.orientation * planes[i].point_B,
                            push_N * planes[i].normal_W, touch.wrench_W);
            touch.touches = true;
        }
    }
}

ToolFelt ImplicitPenaltyTool::feel(const ToolCouplingLoad& coupling, const MovingFrame& handle,
                                   double now_s) const noexcept {
    ToolFelt felt;
    if (near_share_ == 0.0) {
        return felt;
    }
    const Pose grip = held_W();
    const Wrench pull = compute_tool_coupling(settings_.coupling, {handle.pose_W, {}}, {grip, {}});
    felt.felt_W = coupling.compute_felt_wrench(state_, now_s);
    const double share = near_share_ * age_.share();
    felt.felt_W.force = share * limit_length(felt.felt_W.force, most_felt_N_);
    felt.felt_W.torque = share * limit_length(felt.felt_W.torque, most_felt_Nm_);
    felt.spring_W = {-share * pull.force, -share * pull.torque};
    felt.spring_energy_J =
        share *
        compute_shift_energy_J(settings_.coupling,
                               compute_length(Vector3(handle.pose_W.position - grip.position)));
    return felt;
}

ToolFelt ImplicitPenaltyTool::move(const MovingFrame& handle, std::span<const MovingFrame> objects,
                                   double now_s, double dt_s) noexcept {
    if (objects.size() != touches_.size() || !is_finite(handle) || !are_finite(objects) ||
        !std::isfinite(now_s) || !(dt_s >= 0.0) || !std::isfinite(dt_s)) {
        ToolFelt nothing;
        nothing.moved = false;
        return nothing;
    }
    MovingFrame held = handle;
    held.pose_W.orientation = held.pose_W.orientation * settings_.handle_turn;
    // What is near.
    const double began_s = now_s - dt_s;
    if (!settings_.own_rounds || began_s >= round_due_s_) {
        tell_place(objects, began_s, dt_s);
    }
    take_model(began_s);
    note_age(began_s, dt_s);
    // Where coupling and contacts take the tool.
    ToolCouplingLoad coupling(settings_.coupling, settings_.grip_T);
    coupling.set_handle(held, now_s);
    const IntegratorSettings integrator{.newton_iterations = settings_.newton_iterations};
    StepResult result;
    if (settings_.contacts.model == PenaltyModel::planes) {
        planes_.begin_step(state_.pose_W, objects, dt_s);
        const PlaneContactsLoad contacts(planes_.planes());
        result = step_rigid_body(integrator, settings_.inertia, Loads(coupling, contacts), began_s,
                                 dt_s, state_);
    } else {
        taylor_.begin_step(objects);
        result = step_rigid_body(integrator, settings_.inertia, Loads(coupling, taylor_), began_s,
                                 dt_s, state_);
    }
    if (!result.moved()) {
        state_.velocity_W = {};
    }
    // What the hand feels of it.
    note_near(dt_s);
    tell_touches(objects);
    ToolFelt felt = feel(coupling, held, now_s);
    felt.moved = result.moved();
    felt.effort = {result.n_solves, model().n_near, 0.0, !model().is_cut};
    felt.effort.tell(ToolLack::inexact, result.status == StepStatus::iterations_spent &&
                                            settings_.newton_iterations > 1);
    return felt;
}

}  // namespace fulcrum
