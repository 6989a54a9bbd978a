// Bodies on axles and contacts with them, for the tests of the axle stage.
#pragma once

#include "haptics/loop/axle_stage.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <utility>
#include <vector>

namespace fulcrum {

inline constexpr double kLimit_N = 5.0;  // what the gate lets through

// One solid on an axle.
inline HapticPlan make_on_axle(const SolidShape& shape, double inertia_kg_m2, double reach_m) {
    HapticPlan plan;
    plan.solids.push_back({.body = 0, .shape = shape});
    AxlePlan axle;
    axle.axle.inertia_kg_m2 = inertia_kg_m2;
    axle.reach_m = reach_m;
    plan.axles.push_back(axle);
    return plan;
}

// A globe of 0.1 m about a vertical axis in the origin.
inline HapticPlan make_globe() {
    HapticPlan plan = make_on_axle(SphereShape{0.1}, 0.02, 0.1);
    plan.axles[0].axle.axis_W = Vector3::UnitY();
    return plan;
}

// A beam that lies along x, 1 m long, 0.1 m high and deep, on an axle along z through its middle.
inline HapticPlan make_beam(double inertia_kg_m2 = 0.1) {
    return make_on_axle(BoxShape{Vector3(0.5, 0.05, 0.05)}, inertia_kg_m2, 0.51);
}

// The beam, and a ball that nothing turns.
inline HapticPlan make_beam_and_ball() {
    HapticPlan plan = make_beam();
    plan.solids.push_back({.body = 1, .shape = SphereShape{0.1}});
    return plan;
}

// A contact of one plane.
inline ProxyContact make_contact(const Vector3& at_W, const Vector3& normal_W,
                                 std::int32_t solid = 0) {
    ProxyContact contact;
    contact.position_W = at_W;
    contact.normal_W = normal_W;
    contact.solid = solid;
    contact.n_constraints = 1;
    contact.touches[0] = {solid, -1, normal_W, 0.001};
    return contact;
}

// A push of which the hand may feel so much.
inline HandPush make_push(const Vector3& force_W, double most_N = kLimit_N) {
    return {force_W, most_N};
}

// The stage by itself; every round ends with what it tells of its one axle.
struct StagedAxle {
    explicit StagedAxle(const HapticPlan& plan)
        : stage(plan, channels.get()), rest(plan.solids.size()) {}
    AxleReport push(const ProxyContact& contact, const HandPush& hand) {
        turned = stage.turn(rest);
        stage.push(contact, hand, kDt_s);
        return told();
    }
    // A round after the lesson has told its order, which may be the last one again; nobody pushes.
    AxleReport obey() {
        send();
        return push({}, {});
    }
    void send() {
        AxleOrders orders;
        orders.axles[0] = order;
        channels->orders.publish(orders);
    }
    AxleReport told() {
        REQUIRE(channels->frame.take());
        CHECK(channels->frame.value().n_axles == 1);
        return channels->frame.value().axles[0];
    }

    std::unique_ptr<AxleChannels> channels = std::make_unique<AxleChannels>();
    AxleStage stage;
    std::vector<Pose> rest;  // where the solids are before they are turned
    std::span<const Pose> turned;
    AxleOrder order;
};

}  // namespace fulcrum
