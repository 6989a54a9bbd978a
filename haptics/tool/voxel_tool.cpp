#include "haptics/tool/voxel_tool.h"

#include "haptics/math/dense.h"
#include "haptics/math/length.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/objects_load.h"

#include <algorithm>

namespace fulcrum {
namespace {

// The velocity with which pull + damping velocity is at most `most`, along it; `most` 0: any. Along the damper's axes.
Vector3 limit_velocity(const Vector3& velocity, const Vector3& pull, const Vector3& damping,
                       double most) noexcept {
    const Vector3 lead = pull + damping.cwiseProduct(velocity);
    const double size = compute_length(lead);
    return most > 0.0 && damping.minCoeff() > 0.0 && size > most
               ? Vector3((lead * (most / size) - pull).cwiseQuotient(damping))
               : velocity;
}

// Brakes reckon with the step's length; a field has none.
void tell_cycle(VoxelSampling& sampling, double dt_s) noexcept {
    sampling.set_cycle(dt_s);
}
void tell_cycle(FieldSampling& /*sampling*/, double /*dt_s*/) noexcept {}

// Voxels are asked at each point, whatever the time: a solver's looks end with it.
void begin_step(const VoxelSampling& /*sampling*/, StepTime* /*time*/, int /*n_near*/) noexcept {}
void begin_step(const FieldSampling& sampling, StepTime* time, int n_near) noexcept {
    sampling.begin_step(time, n_near);
}
std::int64_t count_points(const VoxelSampling& sampling, std::int64_t n_looks) noexcept {
    return n_looks * static_cast<std::int64_t>(sampling.n_points());
}
std::int64_t count_points(const FieldSampling& /*sampling*/, std::int64_t /*n_looks*/) noexcept {
    return 0;  // the step's time knows
}

bool stop_at_touch(const VoxelSampling& sampling, const ToolMotion& motion, double /*depth_m*/,
                   RigidState& end) noexcept {
    return sampling.stop_at_touch(motion, end);
}
bool stop_at_touch(const FieldSampling& sampling, const ToolMotion& motion, double depth_m,
                   RigidState& end) noexcept {
    return sampling.stop_at_touch(motion, depth_m, end);
}

}  // namespace

template <class Sampling, class Plan>
Pose SampledTool<Sampling, Plan>::held_W() const noexcept {
    return {state_.pose_W * settings_.grip_T, state_.pose_W.orientation};
}

template <class Sampling, class Plan>
Pose SampledTool<Sampling, Plan>::grip_W() const noexcept {
    Pose grip = held_W();
    grip.orientation = grip.orientation * settings_.handle_turn.conjugate();
    return grip;
}

// As the object sees it, so that it may move with the hand.
template <class Sampling, class Plan>
void SampledTool<Sampling, Plan>::limit_lead_to(const MovingFrame& object, const Wrench& pull,
                                                MovingFrame& handle) const noexcept {
    const Vector3 object_W = compute_velocity_at(object, held_W().position);
    const Vector3& spin_W = object.velocity_W.angular;
    handle.velocity_W.linear =
        object_W + limit_velocity(handle.velocity_W.linear - object_W, pull.force,
                                  Vector3::Constant(coupling_.shift.damping_Ns_per_m),
                                  coupling_.shift.stiffness_N_per_m * coupling_.clamp_m);
    // The turn's damper lies along the tool's axes.
    const Quaternion& q_WT = state_.pose_W.orientation;
    const Quaternion q_TW = q_WT.conjugate();
    handle.velocity_W.angular =
        spin_W + q_WT * limit_velocity(q_TW * Vector3(handle.velocity_W.angular - spin_W),
                                       q_TW * pull.torque, coupling_.turn.damping_Nms_per_rad,
                                       coupling_.turn.stiffness_Nm_per_rad * coupling_.clamp_rad);
}

template <class Sampling, class Plan>
MovingFrame SampledTool<Sampling, Plan>::limit_lead(
    const MovingFrame& handle, std::span<const MovingFrame> objects) const noexcept {
    const Wrench pull = compute_tool_coupling(coupling_, {handle.pose_W, {}}, {held_W(), {}});
    MovingFrame limited = handle;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (near_[i] != 0) {
            limit_lead_to(objects[i], pull, limited);
        }
    }
    return limited;
}

template <class Sampling, class Plan>
void SampledTool<Sampling, Plan>::place(const Pose& handle_W) noexcept {
    state_ = {};
    state_.pose_W.orientation = handle_W.orientation * settings_.handle_turn;
    state_.pose_W.position = handle_W.position - state_.pose_W.orientation * settings_.grip_T;
    std::ranges::fill(near_, std::uint8_t{0});
    std::ranges::fill(depths_m_, 0.0);
    std::ranges::fill(touches_, ToolTouch{});
}

template <class Sampling, class Plan>
void SampledTool<Sampling, Plan>::set_objects(std::span<const MovingFrame> objects, double now_s,
                                              double dt_s) noexcept {
    for (std::size_t i = 0; i < samplings_.size(); ++i) {
        tell_cycle(samplings_[i], dt_s);
        loads_[i].set_object(objects[i], now_s);
    }
}

// What is touched where the tool is now.
template <class Sampling, class Plan>
VoxelContact SampledTool<Sampling, Plan>::look(double now_s) noexcept {
    VoxelContact all;
    SharedBrakes shared;
    for (std::size_t i = 0; i < loads_.size(); ++i) {
        const VoxelContact one = loads_[i].compute_contact(state_, now_s);
        brakes_W_[i] = one.brakes_W;
        shared.add(one.brakes_W);
        near_[i] = one.deepest() != VoxelClass::free ? 1 : 0;
        depths_m_[i] = one.depth_m;
        touches_[i] = {one.wrench_W, one.n_surface + one.n_interior > 0, one.error_N};
        all.n_surface += one.n_surface;
        all.n_interior += one.n_interior;
        all.n_proximity += one.n_proximity;
        all.error_N += one.error_N;
        all.error_Nm += one.error_Nm;
    }
    for (std::size_t i = 0; i < loads_.size(); ++i) {
        shared.take_from(touches_[i].wrench_W, brakes_W_[i]);
        all.wrench_W.force += touches_[i].wrench_W.force;
        all.wrench_W.torque += touches_[i].wrench_W.torque;
        all.brakes_W.force += shared.share() * brakes_W_[i].force;
        all.brakes_W.torque += shared.share() * brakes_W_[i].torque;
    }
    return all;
}

template <class Sampling, class Plan>
bool SampledTool<Sampling, Plan>::is_free(std::span<const MovingFrame> objects) const noexcept {
    if (objects.size() != samplings_.size() || !are_finite(objects)) {
        return false;
    }
    begin_time(1);
    bool touches = false;
    for (std::size_t i = 0; i < objects.size() && !touches; ++i) {
        const VoxelContact contact = samplings_[i].sample(state_, objects[i]);
        touches = contact.n_surface + contact.n_interior > 0;
    }
    end_time();
    return !touches;
}

template <class Sampling, class Plan>
void SampledTool<Sampling, Plan>::begin_time(int n_looks) const noexcept {
    const auto n_near = static_cast<int>(std::ranges::count(near_, std::uint8_t{1}));
    time_.begin(n_looks);
    for (const Sampling& sampling : samplings_) {
        begin_step(sampling, &time_, n_near);
    }
}

template <class Sampling, class Plan>
void SampledTool<Sampling, Plan>::end_time() const noexcept {
    for (const Sampling& sampling : samplings_) {
        begin_step(sampling, nullptr, 1);
    }
}

template <class Sampling, class Plan>
ToolFelt SampledTool<Sampling, Plan>::move(const MovingFrame& handle,
                                           std::span<const MovingFrame> objects, double now_s,
                                           double dt_s) noexcept {
    const VoxelToolResult result = run(handle, objects, now_s, dt_s);
    const ToolFelt& felt = result;
    return felt;
}

template <class Sampling, class Plan>
VoxelToolResult SampledTool<Sampling, Plan>::step(const MovingFrame& handle,
                                                  const MovingFrame& object, double now_s,
                                                  double dt_s) noexcept {
    return run(handle, {&object, 1}, now_s, dt_s);
}

template <class Sampling, class Plan>
VoxelToolResult SampledTool<Sampling, Plan>::run(MovingFrame handle,
                                                 std::span<const MovingFrame> objects, double now_s,
                                                 double dt_s) noexcept {
    VoxelToolResult result;
    if (objects.size() != samplings_.size() || !is_finite(handle) || !are_finite(objects)) {
        result.moved = false;
        result.step.status = StepStatus::not_finite;
        return result;
    }
    handle.pose_W.orientation = handle.pose_W.orientation * settings_.handle_turn;
    // What acts on the tool.
    ToolCouplingLoad coupling(coupling_, settings_.grip_T);
    coupling.set_handle(settings_.lead_clamped ? limit_lead(handle, objects) : handle, now_s);
    set_objects(objects, now_s, dt_s);
    begin_time(StepTime::kLooks);
    const ObjectsLoad<Sampling> points(loads_, time_);
    const Pose before_W = state_.pose_W;
    // Where that moves it.
    if (settings_.mass == ToolMass::massive) {
        result.step = advance(coupling, points, now_s, dt_s);
    } else {
        result.step.status =
            settle(coupling, points, now_s) ? StepStatus::done : StepStatus::out_of_time;
    }
    result.moved = result.step.moved();
    if (settings_.swept && result.moved) {
        stop_at_touch(before_W, objects, dt_s);
    }
    // What the hand feels of it.
    result.contact = look(now_s);
    end_time();
    result.effort = tell_effort(result);
    if (result.contact.deepest() != VoxelClass::free || !settings_.silent_in_free_space) {
        const Pose grip = held_W();
        const Wrench pull = compute_tool_coupling(coupling_, {handle.pose_W, {}}, {grip, {}});
        result.felt_W = coupling.compute_felt_wrench(state_, now_s);
        if (settings_.lead_clamped) {
            result.felt_W.force = limit_length(
                result.felt_W.force, coupling_.shift.stiffness_N_per_m * coupling_.clamp_m);
            result.felt_W.torque = limit_length(
                result.felt_W.torque, coupling_.turn.stiffness_Nm_per_rad * coupling_.clamp_rad);
        }
        result.spring_W = {-pull.force, -pull.torque};
        result.spring_energy_J = compute_shift_energy_J(
            coupling_, compute_length(Vector3(handle.pose_W.position - grip.position)));
    }
    return result;
}

template <class Sampling, class Plan>
ToolEffort SampledTool<Sampling, Plan>::tell_effort(const VoxelToolResult& result) const noexcept {
    const std::int64_t n_looks = time_.n_looks() + 1;  // and the one that ended the step
    // What is pulled with no more than the clamp is off by no more than twice that.
    const double most_N = coupling_.clamp_m > 0.0
                              ? 2.0 * coupling_.shift.stiffness_N_per_m * coupling_.clamp_m
                              : result.contact.error_N;
    ToolEffort effort{n_looks, time_.n_points(), std::min(result.contact.error_N, most_N),
                      result.step.status != StepStatus::out_of_time};
    effort.tell(ToolLack::inexact, result.step.status == StepStatus::iterations_spent &&
                                       settings_.integrator.newton_iterations > 1);
    for (const Sampling& sampling : samplings_) {
        effort.n_points += count_points(sampling, n_looks);
    }
    return effort;
}

template <class Sampling, class Plan>
void SampledTool<Sampling, Plan>::stop_at_touch(const Pose& before_W,
                                                std::span<const MovingFrame> objects,
                                                double dt_s) noexcept {
    for (std::size_t i = 0; i < samplings_.size(); ++i) {
        fulcrum::stop_at_touch(samplings_[i],
                               {before_W, move_evenly(objects[i], -dt_s).pose_W, objects[i]},
                               depths_m_[i], state_);
    }
}

template <class Sampling, class Plan>
StepResult SampledTool<Sampling, Plan>::advance(const Load& coupling, const Load& points,
                                                double now_s, double dt_s) noexcept {
    const Loads loads(coupling, points);
    const StepResult result =
        step_rigid_body(settings_.integrator, settings_.inertia, loads, now_s - dt_s, dt_s, state_);
    if (!result.moved()) {
        state_.velocity_W = {};
    }
    return result;
}

// Each step of Newton is cut to half a voxel at the grip's arm, for beyond it the voxels are others.
template <class Sampling, class Plan>
bool SampledTool<Sampling, Plan>::settle(const Load& coupling, const Load& points,
                                         double now_s) noexcept {
    constexpr double kSlack = 1.0e-3;  // of the coupling's stiffness: keeps the matrix regular
    const double most_m = 0.5 * least_voxel_m_;
    Vector6 slack;
    slack << Vector3::Constant(kSlack * coupling_.shift.stiffness_N_per_m),
        Vector3::Constant(kSlack * coupling_.turn.stiffness_Nm_per_rad);
    state_.velocity_W = {};
    for (int i = 0; i < settings_.static_iterations; ++i) {
        if (i > 0 && !points.has_time()) {
            return false;
        }
        Wrench wrench;
        WrenchJacobian jacobian;
        coupling.add_linearised_wrench(state_, now_s, wrench, jacobian);
        points.add_linearised_wrench(state_, now_s, wrench, jacobian);
        Vector6 force;
        force << wrench.force, wrench.torque;
        Matrix6 matrix = -jacobian.pose;
        matrix.diagonal() += slack;
        const Vector6 change = solve_lu(matrix, force);
        if (!change.allFinite()) {
            return true;
        }
        const double way_m =
            change.head<3>().norm() + samplings_.front().reach_m() * change.tail<3>().norm();
        const Vector6 cut = std::min(1.0, most_m / std::max(way_m, 1.0e-300)) * change;
        state_.pose_W.position += cut.head<3>();
        state_.pose_W.orientation = compute_exp(cut.tail<3>()) * state_.pose_W.orientation;
        state_.pose_W.orientation.normalize();
    }
    return true;
}

template class SampledTool<VoxelSampling, VoxelSamplingPlan>;
template class SampledTool<FieldSampling, FieldSamplingPlan>;

}  // namespace fulcrum
