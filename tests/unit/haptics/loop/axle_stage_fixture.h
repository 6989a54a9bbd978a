// Bodies on axles and contacts with them, for the tests of the axle stage.
#pragma once

#include "haptics/loop/axle_stage.h"
#include "haptics/point/make_proxy.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

namespace fulcrum {

inline constexpr double kLimit_N = 5.0;  // what the gate lets through

// A globe of 0.1 m about a vertical axis in the origin.
inline HapticPlan make_globe(double inertia_kg_m2 = 0.02) {
    HapticPlan plan;
    plan.solids.push_back({.body = 0, .shape = SphereShape{0.1}});
    AxlePlan axle;
    axle.axle.axis_W = Vector3::UnitY();
    axle.axle.inertia_kg_m2 = inertia_kg_m2;
    axle.reach_m = 0.1;
    plan.axles.push_back(axle);
    return plan;
}

// A beam that lies along x, 1 m long, 0.1 m high and deep, on an axle along z through its middle.
inline HapticPlan make_beam(double inertia_kg_m2 = 0.1) {
    HapticPlan plan;
    plan.solids.push_back({.body = 0, .shape = BoxShape{Vector3(0.5, 0.05, 0.05)}});
    AxlePlan axle;
    axle.axle.inertia_kg_m2 = inertia_kg_m2;
    axle.reach_m = 0.51;
    plan.axles.push_back(axle);
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

// Nothing asks it to move.
struct StillProxy final : Proxy {
    void reset(const Vector3&) noexcept override {}
    void put_solid(std::size_t solid, const Pose& pose_W) noexcept override {
        put = solid;
        put_W = pose_W;
        ++n_put;
    }
    const ProxyContact& step(const Vector3&, std::span<const Pose>) noexcept override {
        return contact;
    }
    ProxyContact contact{};
    std::size_t put = 99;
    Pose put_W{};
    int n_put = 0;
};

}  // namespace fulcrum
