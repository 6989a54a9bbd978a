// The step path of world_loop.h.
#include "haptics/dynamics/world_loop.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fulcrum {

void WorldLoop::step(double now_s) noexcept {
    if (!std::isfinite(now_s)) {
        return;
    }
    const double since_s = started_ ? now_s - now_s_ : period_s_;
    started_ = true;
    now_s_ = now_s;
    const double dt_s = std::clamp(since_s, 0.0, kLongestWorldStep_s);
    take_hand();
    take_commands();
    world_.set_time(now_s - dt_s);
    world_.step(dt_s, hand_);
    publish(now_s);
}

// Before the device's first good reading a state holds no pose. After it a faulty one holds the
// last that was good.
void WorldLoop::take_hand() noexcept {
    constexpr Fault kNoPose = Fault::device_read | Fault::device_stale | Fault::device_invalid;
    if (!haptics_.state_for_world.take()) {
        return;
    }
    const HapticState& newest = haptics_.state_for_world.value();
    heard_hand_ = heard_hand_ || !any(newest.faults & kNoPose);
    if (heard_hand_) {
        hand_ = newest;
    }
}

void WorldLoop::take_commands() noexcept {
    // As many as a ring holds: a lesson that never stops asking does not keep the world from
    // moving.
    constexpr int kMostCommands = 256;
    WorldCommand command;
    for (int i = 0; i < kMostCommands && channels_.commands.pop(command); ++i) {
        world_.apply(command);
    }
}

void WorldLoop::publish(double now_s) noexcept {
    for (const WorldEvent& event : world_.events()) {
        (void)channels_.events.push(event);  // a full ring counts what it drops
    }
    // Where all rest, only the clock has changed.
    const std::uint64_t revision = world_.revision();
    snapshots_.publish(
        revision, [&](WorldSnapshot& snapshot) { snapshot = world_.snapshot(); },
        [&](WorldSnapshot& snapshot) { snapshot.time_s = world_.snapshot().time_s; });
    frames_.publish(
        revision, [&](WorldFrame& frame) { frame = world_.make_frame(now_s, solid_bodies_); },
        [&](WorldFrame& frame) { frame.stamp_s = now_s; });
}

void WorldLoop::silence(double now_s) noexcept {
    frames_.publish(
        ThriftyWriter<WorldFrame>::kNoRevision,
        [&](WorldFrame& frame) {
            frame = world_.make_frame(now_s, solid_bodies_);
            frame.carried_force_W.setZero();
        },
        [&](WorldFrame& frame) { frame.stamp_s = now_s; });
}

}  // namespace fulcrum
