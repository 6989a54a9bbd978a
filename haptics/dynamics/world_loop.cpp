// The step path of world_loop.h.
#include "haptics/dynamics/world_loop.h"

#include <algorithm>

namespace fulcrum {

void WorldLoop::step(double now_s) noexcept {
    const double since_s = started_ ? now_s - now_s_ : period_s_;
    started_ = true;
    now_s_ = now_s;
    const double dt_s = std::min(since_s, kLongestWorldStep_s);
    (void)haptics_.state_for_world.take();
    take_commands();
    world_.set_time(now_s - dt_s);
    world_.step(dt_s, haptics_.state_for_world.value());
    publish(now_s);
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
    channels_.snapshot.publish(world_.snapshot());
    haptics_.world.publish(world_.make_frame(now_s, solid_bodies_));
}

void WorldLoop::silence(double now_s) noexcept {
    WorldFrame frame = world_.make_frame(now_s, solid_bodies_);
    frame.carried_force_W.setZero();
    haptics_.world.publish(frame);
}

void WorldLoop::reset() noexcept {
    world_.reset();
    started_ = false;
}

}  // namespace fulcrum
