// The step path of haptic_loop.h. What builds and describes the loop stands in haptic_loop_build.cpp, so that this object can be
// checked for calls that a real-time thread must not make.
#include "haptics/loop/haptic_loop.h"

#include "haptics/loop/workspace.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace fulcrum {
namespace {

// True when `stamp_s` is at most `timeout_s` old and at most `ahead_s` in the future; NaN is neither.
bool is_fresh(double stamp_s, double now_s, double timeout_s, double ahead_s) noexcept {
    const double age_s = now_s - stamp_s;
    return age_s <= timeout_s && age_s >= -ahead_s;
}

}  // namespace

// The whole round. `passed(stage)` is called as each stage ends; where nobody listens it is nothing, and no instruction of
// it is left. What is not in the plan is neither done nor told.
template <class Passed>
void HapticLoop::run_round(double now_s, Passed passed) noexcept {
    begin_round(now_s);
    take_inputs();
    passed(HapticStage::take_inputs);
    read_device();
    passed(HapticStage::read);
    estimate_motion();
    watch_hand();
    passed(HapticStage::estimate);
    const SceneRound round = make_scene_round();
    scene_.move(round, passed);
    scene_.compute(round, passed);
    if (passivity_) {
        keep_passive();
        passed(HapticStage::passivity);
    }
    limit_forces();
    passed(HapticStage::limits);
    write_device();
    passed(HapticStage::write);
    teller_->publish(state_, now_s_, dt_s_);
    passed(HapticStage::publish);
    if (channels_.record != nullptr) {
        late_faults_ |= teller_->record(state_, told_, {told_faults_, is_reading_});
        passed(HapticStage::record);
    }
}

void HapticLoop::step(double now_s) noexcept {
    run_round(now_s, NobodyListens{});
}

void HapticLoop::step_observed(double now_s, StageListener& listener) noexcept {
    run_round(now_s, TellsListener{listener});
}

void HapticLoop::begin_round(double now_s) noexcept {
    state_.faults = late_faults_;
    late_faults_ = Fault::none;
    // The first round has no predecessor; it is taken to be one period long.
    dt_s_ = started_ ? now_s - now_s_ : 1.0 / plan_.rate_hz;
    if (!std::isfinite(now_s)) {
        dt_s_ = std::numeric_limits<double>::quiet_NaN();
    } else {
        started_ = true;
        now_s_ = now_s;
    }
    if (!(dt_s_ > 0.0)) {
        state_.faults |= Fault::command_invalid;
    }
}

void HapticLoop::take_inputs() noexcept {
    heard_lesson_ = channels_.command.take() || heard_lesson_;
    heard_world_ = channels_.world.take() || heard_world_;
    const ForceCommand& command = channels_.command.value();
    const WorldFrame& world = channels_.world.value();
    // Their threads' clocks are read at other moments: a stamp may as well lie ahead.
    const double timeout_s = plan_.safety.command_timeout_s;
    const auto is_late = [&](double stamp_s) {
        return !is_fresh(stamp_s, now_s_, timeout_s, timeout_s);
    };
    // Who should be speaking and is not?
    if (plan_.expects_lesson) {
        if (!heard_lesson_ || is_late(command.stamp_s)) {
            state_.faults |= Fault::command_stale;
        } else if (!command.lesson_alive) {
            state_.faults |= Fault::lesson_failed;
        }
    }
    if (plan_.expects_world && (!heard_world_ || is_late(world.stamp_s))) {
        state_.faults |= Fault::command_stale;
    }
    // Has somebody asked for silence, or for its end?
    if (channels_.lesson_failed.load(std::memory_order_acquire)) {
        state_.faults |= Fault::lesson_failed;
    }
    if (channels_.ended.load(std::memory_order_acquire)) {
        state_.faults |= Fault::ended;
    }
    take_stop();
}

// A stop's fade comes to its end before it is lifted; a stop that comes meanwhile has been lifted by nobody.
void HapticLoop::take_stop() noexcept {
    const bool lifts = channels_.rearm.load(std::memory_order_acquire);
    const bool is_own = channels_.emergency_stop.take();
    const bool is_other = channels_.other_stopped.load(std::memory_order_acquire);
    state_.faults |= is_own ? Fault::emergency_stop : Fault::none;
    state_.faults |= is_other ? Fault::other_stopped : Fault::none;
    if (is_own || is_other) {
        if (lift_waits_) {
            channels_.rearm.store(false, std::memory_order_release);
        }
        lift_waits_ = lifts && !lift_waits_;
        return;
    }
    lift_waits_ = lifts && gate_.is_fading();
    if (lifts && !lift_waits_) {
        // Where nothing was stopped there is nothing to lift.
        channels_.rearm.store(false, std::memory_order_release);
        if (gate_.phase() == GatePhase::stopped) {
            gate_.reset();
        }
    }
}

void HapticLoop::read_device() noexcept {
    has_new_pose_ = false;
    is_reading_ = true;
    told_faults_ = Fault::none;
    DeviceReading reading{};
    if (!device_.read(now_s_, reading)) {
        state_.faults |= Fault::device_read;
        return;
    }
    is_reading_ = is_reading(reading);
    told_faults_ = reading.faults;
    if (!is_reading_) {
        state_.faults |= Fault::device_invalid;
        return;
    }
    told_ = reading;
    state_.faults |= reading.faults;
    // What is not of now is not taken over: its stamp would make later ones look early.
    const double period_s = 1.0 / plan_.rate_hz;
    if (!is_fresh(reading.stamp_s, now_s_, plan_.safety.device_timeout_s, period_s)) {
        state_.faults |= Fault::device_stale;
    } else if (!accept(reading)) {
        state_.faults |= Fault::device_invalid;
    }
}

// Takes a reading over; false when it is an impossible jump from the last one, in space or back in
// time.
bool HapticLoop::accept(const DeviceReading& reading) noexcept {
    const double since_s = reading.stamp_s - reading_.stamp_s;
    const double reach_m =
        plan_.safety.max_hand_speed_m_per_s * std::max(since_s, 1.0 / plan_.rate_hz);
    const double way_m = (reading.pose_D.position - reading_.pose_D.position).norm();
    const bool follows = has_pose_ && since_s >= 0.0 && way_m <= reach_m;
    has_new_pose_ = !follows || since_s > 0.0;
    reading_ = reading;
    reading_.pose_D.orientation.normalize();
    state_.tool_pose_W = compute_world_pose(plan_.workspace, reading_.pose_D);
    state_.buttons = reading.buttons;
    // A new beginning has no velocity and no proxy yet.
    if (!follows) {
        forget_motion();
    }
    const bool is_first = !has_pose_;
    has_pose_ = true;
    return follows || is_first;
}

void HapticLoop::estimate_motion() noexcept {
    if (!has_pose_) {
        return;
    }
    state_.tool_twist_W.linear = velocity_.step(state_.tool_pose_W.position, reading_.stamp_s);
    state_.tool_twist_W.angular =
        angular_velocity_.step(state_.tool_pose_W.orientation, reading_.stamp_s);
}

// What acted since the last round did so along the way from there to here, in the device's own metres.
void HapticLoop::watch_hand() noexcept {
    if (!has_pose_) {
        return;
    }
    const Pose& now_D = reading_.pose_D;
    const Vector3 turn_D = compute_log(now_D.orientation * watched_D_.orientation.conjugate());
    state_.faults |= guard_.step(applied_D_, now_D.position - watched_D_.position, turn_D, dt_s_);
    watched_D_ = now_D;
}

SceneRound HapticLoop::make_scene_round() noexcept {
    return {.state = state_,
            .teller = *teller_,
            .gate = gate_,
            .hand = {velocity_, reading_.stamp_s},
            .now_s = now_s_,
            .dt_s = dt_s_,
            .has_pose = has_pose_,
            .heard_world = heard_world_};
}

void HapticLoop::keep_passive() noexcept {
    if (!has_pose_) {
        return;
    }
    const Wrench brake_W =
        passivity_->step(scene_.demand(), state_.tool_pose_W, dt_s_, has_new_pose_);
    state_.commanded_W.force += brake_W.force;
    state_.commanded_W.torque += brake_W.torque;
    teller_->share(Effect::brake, brake_W.force, brake_W.torque);
    state_.force_energy = passivity_->force_energy();
    state_.torque_energy = passivity_->torque_energy();
}

void HapticLoop::limit_forces() noexcept {
    const Wrench commanded_D = compute_device_wrench(plan_.workspace, state_.commanded_W);
    applied_D_ = gate_.pass(commanded_D, state_.faults, dt_s_, guard_.speed_m_per_s());
    state_.faults |= gate_.faults();
    state_.gate = gate_.phase();
}

void HapticLoop::write_device() noexcept {
    // What this finds comes after the gate, and so fades the force from the next round on.
    const bool is_written = device_.write(now_s_, applied_D_);
    if (!is_written) {
        late_faults_ |= Fault::device_write;
    }
    is_still_ = is_written && gate_.is_still();
    channels_.emergency_stop.tell_still(is_still_ &&
                                        channels_.others_still.load(std::memory_order_acquire));
    state_.applied_W = compute_world_wrench(plan_.workspace, applied_D_);
    if (passivity_) {
        passivity_->sent(state_.applied_W);
    }
}

void HapticLoop::forget_motion() noexcept {
    guard_.forget();
    watched_D_ = reading_.pose_D;
    velocity_.reset();
    angular_velocity_.reset();
    state_.tool_twist_W = Twist{};
    scene_.forget(state_.tool_pose_W.position);
    if (passivity_) {
        passivity_->forget();
    }
}

void HapticLoop::silence(double now_s) noexcept {
    gate_.silence();
    applied_D_ = Wrench{};
    (void)device_.write(now_s, applied_D_);
    if (passivity_) {
        passivity_->sent(Wrench{});
    }
}

}  // namespace fulcrum
