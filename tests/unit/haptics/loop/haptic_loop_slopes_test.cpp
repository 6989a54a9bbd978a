// How steep a lesson's own force may be in the hand.
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace fulcrum;

TEST_CASE("haptic loop: a lesson's slopes are bounded in the hand, by what the fields leave") {
    // How stiff a lesson's spring of 1e5 N/m is in the hand, and its damping and torque slope.
    struct Felt {
        double stiffness, damping, torque_slope;
    };
    const auto feel = [](double scale, const std::vector<FieldPlan>& fields) {
        HapticPlan plan = make_lesson_plan();
        plan.workspace.scale = scale;
        plan.passivity.on = false;  // a hand that leaps is braked as well
        plan.fields = fields;
        Bench bench(plan);
        bench.command.fields[0].on = false;
        bench.command.linearised.stamp_s = kDt_s;
        bench.command.linearised.stiffness_N_per_m(0, 0) = -1e5;
        bench.command.linearised.damping_Ns_per_m(1, 1) = -1e4;
        bench.command.linearised.torque_stiffness_Nm_per_m(2, 0) = 1e4;
        bench.run(20);
        bench.device.pose_D.position.x() = 0.0005;
        bench.run(20);
        const Wrench bent = bench.state().commanded_W;
        for (int k = 0; k < 20; ++k) {
            bench.move(0.0, 1e-5);
        }
        return Felt{-bent.force.x() / 0.0005, -bench.state().commanded_W.force.y() / 0.01,
                    bent.torque.z() / 0.0005};
    };
    for (const double scale : {1.0, 0.5, 100.0}) {
        const Felt alone = feel(scale, {});
        CHECK(alone.stiffness == Approx(2000.0).epsilon(1e-6));
        CHECK(alone.damping == Approx(50.0).epsilon(1e-3));
        CHECK(alone.torque_slope == Approx(200.0).epsilon(1e-6));
        FieldPlan spring;
        spring.stiffness_N_per_m = 1500.0 / scale;
        spring.damping_Ns_per_m = 40.0 / scale;
        const Felt beside = feel(scale, {spring});
        CHECK(beside.stiffness == Approx(500.0).epsilon(1e-6));
        CHECK(beside.damping == Approx(10.0).epsilon(1e-3));
        FieldPlan magnet;
        magnet.kind = FieldKind::magnet;
        magnet.peak_force_N = 3.0;
        magnet.range_m = 0.005 * scale;
        CHECK(feel(scale, {magnet}).stiffness ==
              Approx(2000.0 - 600.0 * std::sqrt(std::exp(1.0))).epsilon(1e-6));
    }
}

TEST_CASE("haptic loop: a lesson's spring too stiff for the scale does not shake the usual arm") {
    for (const double felt_N_per_m : {500.0, 2000.0, 5000.0, 200000.0}) {
        constexpr double kScale = 100.0;
        HapticPlan plan = make_lesson_plan();
        plan.workspace.scale = kScale;
        HandBench bench(plan);
        double lowest_m = 1.0;
        double highest_m = -1.0;
        for (int k = 1; k < 7000; ++k) {
            if (k % 16 == 0) {
                LinearisedWrench& answer = bench.command.linearised;
                answer.stamp_s = bench.now_s + kDt_s;
                answer.at_position_W = bench.state().tool_pose_W.position;
                answer.stiffness_N_per_m = -felt_N_per_m / kScale * Matrix3::Identity();
                answer.force_W = answer.stiffness_N_per_m * answer.at_position_W;
            }
            // The hand is pushed 5 mm aside for a second.
            bench.run_to({k > 3000 && k < 4000 ? 0.005 : 0.0, 0.0, 0.0});
            if (k > 5000) {
                const double x_m = bench.state().tool_pose_W.position.x() / kScale;
                lowest_m = std::min(lowest_m, x_m);
                highest_m = std::max(highest_m, x_m);
            }
        }
        CHECK(highest_m - lowest_m < 0.001);
        CHECK(std::abs(highest_m) < 0.002);
    }
}
