#include "haptics/loop/axle_stage.h"

#include <catch2/catch.hpp>

#include <memory>
#include <utility>

using namespace fulcrum;

namespace {

// A beam 1 m long on an axle along z through its middle, and a ball that nothing turns.
HapticPlan make_plan() {
    HapticPlan plan;
    plan.solids.push_back({.body = 0, .shape = BoxShape{Vector3(0.5, 0.05, 0.05)}});
    plan.solids.push_back({.body = 1, .shape = SphereShape{0.1}});
    AxlePlan axle;
    axle.axle.inertia_kg_m2 = 0.1;
    axle.reach_m = 0.51;
    plan.axles.push_back(axle);
    return plan;
}

}  // namespace

TEST_CASE(
    "axle stage: a tool turns a body by r x F and its couple, within what the hand may feel") {
    const HapticPlan plan = make_plan();
    const auto channels = std::make_unique<AxleChannels>();
    AxleStage stage(plan, channels.get());
    const Pose rest[] = {Pose{}, Pose{}};
    SolidPush pushes[2];
    pushes[0] = {true, Vector3(0.4, 0.05, 0), Vector3(1, -2, 3), Vector3(7, 5, 0.25)};
    const auto report = [&](double most_N, double most_Nm = 100.0) {
        (void)stage.turn(rest);
        stage.push_by_tool(pushes, {most_N, most_Nm}, 1e-3);
        REQUIRE(channels->frame.take());
        return channels->frame.value().axles[0];
    };
    const double torque_Nm = 0.4 * -2.0 - 0.05 * 1.0 + 0.25;
    CHECK(report(10.0).torque_Nm == Approx(torque_Nm));
    CHECK(report(10.0).touched);
    CHECK(report(10.0).force_W == pushes[0].force_W);
    CHECK(report(10.0).spin_rad_per_s == Approx(torque_Nm / 0.1 * 4e-3));
    // Half of the force may be felt: half turns.
    const double force_N = pushes[0].force_W.norm();
    CHECK(report(0.5 * force_N).torque_Nm == Approx(0.5 * torque_Nm));
    CHECK(report(0.0).torque_Nm == 0.0);
    // The couple alone has a limit of its own, behind a closed gate nothing.
    const double couple_Nm = pushes[0].couple_W.norm();
    CHECK(report(10.0, 0.5 * couple_Nm).torque_Nm == Approx(torque_Nm - 0.5 * 0.25));
    CHECK(report(10.0, 0.0).torque_Nm == Approx(torque_Nm - 0.25));
    pushes[0].force_W = Vector3::Zero();
    CHECK(report(10.0, 100.0).torque_Nm == Approx(0.25));
    CHECK(report(0.0, 0.5 * couple_Nm).torque_Nm == Approx(0.125));
    CHECK(report(10.0, 0.0).torque_Nm == 0.0);
    // Another solid's push is not its.
    std::swap(pushes[0], pushes[1]);
    CHECK(report(10.0).torque_Nm == 0.0);
    CHECK_FALSE(report(10.0).touched);
}
