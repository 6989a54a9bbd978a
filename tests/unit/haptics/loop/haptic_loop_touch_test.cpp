// What touches: the proxy's side of the haptic loop.
#include "haptics/geometry/shape.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/touchable.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>

using namespace fulcrum;

namespace {

// A plan whose one solid is the floor.
HapticPlan make_floor_plan(std::int32_t body = 0, double damping_Ns_per_m = 2.0) {
    HapticPlan plan;
    plan.coupling.damping_Ns_per_m = damping_Ns_per_m;
    plan.solids.push_back({body, nullptr, {}});
    return plan;
}

// A hand over the floor, or in it.
struct FloorBench : Bench {
    explicit FloorBench(const HapticPlan& plan, double height_m = 0.01)
        : Bench(plan, {.proxy = std::make_unique<FloorProxy>()}) {
        device.pose_D.position.y() = height_m;
    }
};

}  // namespace

TEST_CASE("haptic loop: a touched solid pushes with the coupling's spring; sliding is free") {
    HapticPlan plan = make_floor_plan(7);
    plan.coupling.stiffness_N_per_m = 400.0;
    FloorBench bench(plan);
    bench.run(3000);
    CHECK(bench.state().touched_body == kNoBody);
    CHECK(bench.written_N().norm() == 0.0);
    for (int k = 0; k < 500; ++k) {
        bench.device.pose_D.position.y() =
            std::max(bench.device.pose_D.position.y() - 0.0001, -0.005);
        bench.run(1);
    }
    CHECK(bench.state().touched_body == 7);
    CHECK((bench.written_N() - Vector3(0.0, 2.0, 0.0)).norm() < kRounding);
    for (int k = 0; k < 500; ++k) {
        bench.move(0.0001);
    }
    CHECK((bench.written_N() - Vector3(0.0, 2.0, 0.0)).norm() < 1e-6);
    // Pressing further in at 0.05 m/s adds b v.
    for (int k = 0; k < 50; ++k) {
        bench.move(0.0, -0.00005);
    }
    CHECK(bench.state().commanded_W.force.y() == Approx(400.0 * 0.0075 + 2.0 * 0.05).epsilon(1e-6));
}

TEST_CASE("haptic loop: solids stand where the world says, and NaN there is a fault") {
    HapticPlan plan = make_floor_plan();
    plan.expects_world = true;
    FloorBench bench(plan);
    bench.run(3000);
    CHECK(bench.state().touched_body == kNoBody);
    bench.world.solid_poses_W[0].position.y() = 0.012;
    bench.run(10);
    CHECK(bench.state().touched_body == 0);
    CHECK(bench.state().proxy_position_W.y() == 0.012);
    bench.world.solid_poses_W[0].position.y() = kNan;
    bench.run(1);
    CHECK(bench.saw(Fault::command_invalid));
    CHECK(is_finite(bench.device.written_D));
}

TEST_CASE("haptic loop: a solid put on the hand gives no force, one that moves there does") {
    HapticPlan plan;
    plan.expects_world = true;
    plan.solids.push_back({0, touchable(make_box(Vector3(0.1, 0.1, 0.1))), {}});
    plan.solids[0].initial_pose_W.position.y() = 1.0;
    plan.solids[0].lets_out = true;
    Bench bench(plan);
    bench.device.pose_D.position.setZero();
    bench.world.solid_poses_W[0].position.y() = 1.0;
    bench.run(3000);
    bench.world.solid_poses_W[0].position.y() = 0.01;
    ++bench.world.solid_placements[0];
    bench.run(20);
    CHECK(bench.state().touched_body == kNoBody);
    CHECK(bench.state().commanded_W.force.norm() == 0.0);
    // Put away and moved there instead.
    bench.world.solid_poses_W[0].position.y() = 0.2;
    ++bench.world.solid_placements[0];
    bench.run(20);
    for (int i = 0; i < 160; ++i) {
        bench.world.solid_poses_W[0].position.y() -= 0.001;
        bench.run(1);
    }
    CHECK(bench.state().touched_body == 0);
    CHECK(bench.state().commanded_W.force.y() < -1.0);
}

TEST_CASE("haptic loop: a hand that jumps while it touches feels the spring alone at first") {
    FloorBench bench(make_floor_plan(), -0.004);
    for (int k = 0; k < 100; ++k) {
        bench.move(0.0005);
    }
    bench.move(0.1);
    CHECK(bench.saw(Fault::device_invalid));
    CHECK((bench.state().commanded_W.force - Vector3(0.0, 500.0 * 0.004, 0.0)).norm() < kRounding);
}

TEST_CASE("haptic loop: a solid that is no body pushes, lets go, and stands where the plan says") {
    FloorBench bench(make_floor_plan(kNoBody), -0.004);
    bench.run(10);
    CHECK(bench.state().commanded_W.force.y() == Approx(500.0 * 0.004));
    CHECK(bench.state().touched_body == kNoBody);
    FloorBench other(make_floor_plan(0, 10.0), -0.005);
    other.run(100);
    for (int k = 0; k < 30; ++k) {
        other.move(0.0, 0.0005);
        REQUIRE(other.state().commanded_W.force.y() >= 0.0);
    }
    HapticPlan plan = make_floor_plan();
    plan.expects_world = true;
    plan.solids[0].initial_pose_W.position.y() = 0.012;
    FloorBench third(plan);
    third.world_awake = false;
    third.run(1);
    CHECK(third.state().proxy_position_W.y() == 0.012);
    third.world_awake = true;
    third.run(1);
    CHECK(third.state().proxy_position_W.y() == 0.01);
}

TEST_CASE("haptic loop: a bare handle on a wall, and a hand, come to rest at 1 and 5 kHz") {
    constexpr double kEncoder_m = 5.5e-5;
    SimulatedHandSettings handle;
    handle.mass_kg = 0.05;
    handle.stiffness_N_per_m = 1.0;
    handle.damping_Ns_per_m = 0.0;
    for (SimulatedHandSettings held : {handle, SimulatedHandSettings{}}) {
        for (const double rate_Hz : {1000.0, 5000.0}) {
            HapticPlan plan = make_floor_plan();
            plan.coupling = {};
            plan.rate_hz = rate_Hz;
            held.position_resolution_m = kEncoder_m;
            held.start_pose_D.position.y() = 0.01;
            HandBench bench(plan, held, {.proxy = std::make_unique<FloorProxy>()});
            double lowest_m = 1.0;
            double highest_m = -1.0;
            for (int k = 1; k < static_cast<int>(6.0 * rate_Hz); ++k) {
                const double now_s = k / rate_Hz;
                // Pressed down with 2 N from 2.5 s on.
                bench.run_to({0.0, now_s < 2.5 ? 0.01 : -2.0 / held.stiffness_N_per_m, 0.0});
                if (now_s > 5.0) {
                    const double y_m = bench.state().tool_pose_W.position.y();
                    lowest_m = std::min(lowest_m, y_m);
                    highest_m = std::max(highest_m, y_m);
                }
            }
            CHECK(highest_m - lowest_m < 1.5 * kEncoder_m);
            CHECK(highest_m < -0.002);
        }
    }
}
