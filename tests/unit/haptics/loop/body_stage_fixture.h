// A stage of rigid bodies, and a world that tells it of them.
#pragma once

#include "haptics/loop/body_stage.h"
#include "tests/unit/haptics/loop/axle_stage_fixture.h"

#include <catch2/catch.hpp>

#include <memory>

namespace fulcrum {

inline HapticPlan make_body_plan(std::uint32_t grip_buttons = 0) {
    HapticPlan plan;
    plan.coupling = {.stiffness_N_per_m = 600.0, .damping_Ns_per_m = 5.0};
    plan.solids = {{.body = 0, .shape = BoxShape{{0.1, 0.1, 0.1}}},
                   {.body = 1, .shape = BoxShape{{0.1, 0.1, 0.1}}}};
    plan.rigid = {{1, 0.5, 2.0e-3, grip_buttons}};
    return plan;
}

// The second of two solids is a rigid body.
struct StagedBody {
    explicit StagedBody(const HapticPlan& plan = make_body_plan()) : stage(plan, channels.get()) {}
    void tell(double stamp_s, const Vector3& at_W, const Vector3& velocity_W,
              std::uint32_t n_placements = 0, double behind_s = 0.0) {
        RigidFrame frame;
        frame.stamp_s = stamp_s;
        frame.solids[1] = {
            Pose::at(at_W), {velocity_W, Vector3::Zero()}, behind_s, true, n_placements};
        channels->frame.publish(frame);
    }
    void tell(const RigidFrame& frame) { channels->frame.publish(frame); }
    Pose felt(double now_s) {
        const Pose rest[] = {Pose::at({7.0, 0.0, 0.0}), Pose::at({9.0, 0.0, 0.0})};
        const auto poses_W = stage.place(rest, now_s);
        REQUIRE(poses_W.size() == 2);
        CHECK(poses_W[0].position.x() == 7.0);
        return poses_W[1];
    }
    // A hand at its top that presses the button, so that it grips.
    void grip_top(const GrippingHand& hand) {
        (void)stage.grip(make_contact({0.0, 0.1, 0.0}, Vector3::UnitY(), 1), hand);
    }
    // Pushed at its left side; what the world hears of it.
    const HandPushes& push(double force_N, double now_s, double most_N = 4.0, double at_m = 0.1,
                           std::int32_t solid = 1) {
        stage.push(make_contact({at_m, 0.0, 0.0}, Vector3::UnitX(), solid),
                   make_push({force_N, 0.0, 0.0}, most_N), now_s);
        return told();
    }
    // Nothing is touched; what the world hears of a grip.
    const HandPushes& push_nothing(double most_N, double now_s = 1.002) {
        stage.push({}, make_push(Vector3::Zero(), most_N), now_s);
        return told();
    }
    const HandPushes& told() {
        REQUIRE(channels->pushes.take());
        return channels->pushes.value();
    }
    std::unique_ptr<RigidChannels> channels = std::make_unique<RigidChannels>();
    BodyStage stage;
};

}  // namespace fulcrum
