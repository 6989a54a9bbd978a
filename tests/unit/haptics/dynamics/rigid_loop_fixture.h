// A loop of rigid bodies with a hand and a lesson that listens.
#pragma once

#include "haptics/dynamics/rigid_loop.h"
#include "tests/support/rigid_worlds.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <vector>

namespace fulcrum {

// A ground and two cubes: the scene's bodies 3 and 5, the hand's solids 0 and 2; solid 1 is none of them.
inline RigidLoopPlan make_two_cubes() {
    RigidLoopPlan plan;
    plan.world.bodies = {plan_ground(), plan_cube(0.05, {0.0, 0.05, 0.0}, 0.5),
                         plan_cube(0.05, {0.5, 0.05, 0.0}, 0.5)};
    plan.scene_bodies = {kNoBody, 3, 5};
    plan.solids = {1, kNoBody, 2};
    return plan;
}

// A grip on solid 2, which the hand takes to be at rest there.
inline RigidPush make_push(const Vector3& body_W, const Vector3& at_W, const Vector3& force_W) {
    RigidPush push;
    push.solid = 2;
    push.pose_W = Pose::at(body_W);
    push.hold.at_W = at_W;
    push.hold.push_W.force = force_W;
    push.hold.bounds = {.most_N = 9.0, .most_Nm = 1.0};
    return push;
}

struct CubesLoop {
    explicit CubesLoop(const RigidLoopPlan& plan = make_two_cubes()) {
        RigidChannels* const hands[] = {hand.get()};
        loop = std::move(RigidLoop::create(plan, lesson.get(), hands)).value();
    }
    void run(double seconds, double dt_s = 1.0e-3) {
        for (const double until_s = now_s + seconds; now_s < until_s - 0.5 * dt_s;) {
            now_s += dt_s;
            loop->step(now_s);
        }
    }
    void order(WorldCommand::Kind kind, std::int32_t body, const Vector3& at_W,
               const Vector3& velocity_W = Vector3::Zero()) {
        REQUIRE(lesson->commands.push({kind, body, at_W, velocity_W}));
    }
    // What a hand tells at once, or some time to come.
    void push(const std::vector<RigidPush>& told, double in_s = 0.0) {
        HandPushes pushes;
        pushes.stamp_s = now_s + in_s;
        pushes.count = static_cast<int>(told.size());
        std::ranges::copy(told, pushes.pushes.begin());
        hand->pushes.publish(pushes);
    }
    // Of the second cube.
    [[nodiscard]] const RigidState& state() const { return loop->world().state(2); }
    const BodyState& seen(std::size_t body) {
        lesson->snapshot.take();
        return lesson->snapshot.value().bodies[body];
    }
    const RigidSolid& felt(std::size_t solid) {
        hand->frame.take();
        return hand->frame.value().solids[solid];
    }
    std::vector<WorldEvent> events() {
        std::vector<WorldEvent> all;
        for (WorldEvent event; lesson->events.pop(event);) {
            all.push_back(event);
        }
        return all;
    }
    std::unique_ptr<WorldChannels> lesson = std::make_unique<WorldChannels>();
    std::unique_ptr<RigidChannels> hand = std::make_unique<RigidChannels>();
    std::unique_ptr<RigidLoop> loop;
    double now_s = 0.0;
};

}  // namespace fulcrum
