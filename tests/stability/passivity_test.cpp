// A wall without a damper, and what the passivity stage makes of it; and that it takes nothing where nothing is to take.
#include "tests/support/wall_press.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::wall_press;

namespace {

bool same_bytes(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vector3)) == 0;
}

}  // namespace

TEST_CASE("passivity: a wall that buzzes in a loose grip stands still with the stage") {
    struct Case {
        double stiffness_N_per_m, rate_hz;
    };
    for (const Case& c : {Case{500, 1000}, Case{1000, 1000}, Case{2000, 1000}, Case{2000, 2000},
                          Case{2000, 4000}}) {
        HapticPlan plan = make_wall(c.stiffness_N_per_m, 0.0);
        plan.rate_hz = c.rate_hz;
        const Shaking with = last_second(press(plan, make_loose_grip(), {}), c.rate_hz);
        plan.passivity.on = false;
        const Shaking without = last_second(press(plan, make_loose_grip(), {}), c.rate_hz);
        CAPTURE(c.stiffness_N_per_m, c.rate_hz, with.force_N, without.force_N);
        CHECK(without.force_N > 0.5);
        CHECK(without.speed_m_per_s > 0.1);
        CHECK(with.force_N < 0.01);
        CHECK(with.speed_m_per_s < 0.001);
        // And it is still the wall that is felt: 50 N/m from 20 mm into it.
        CHECK(
            with.mean_N ==
            Approx(50.0 * 0.02 * c.stiffness_N_per_m / (c.stiffness_N_per_m + 50.0)).epsilon(0.01));
    }
}

TEST_CASE("passivity: an encoder's steps do not set the controller off into a buzz of its own") {
    for (const double step_m : {1.0e-5, 5.5e-5}) {
        SimulatedHandSettings grip = make_loose_grip();
        grip.position_resolution_m = step_m;
        HapticPlan plan = make_wall(1000.0, 0.0);
        const Shaking with = last_second(press(plan, grip, {}), plan.rate_hz);
        plan.passivity.on = false;
        const Shaking without = last_second(press(plan, grip, {}), plan.rate_hz);
        CAPTURE(step_m, with.force_N, without.force_N);
        CHECK(without.force_N > 1.0);
        CHECK(with.force_N < 0.25);
        CHECK(with.speed_m_per_s < 0.005);
    }
}

TEST_CASE("passivity: a damped wall is left as it is, to the byte, however fast the hand comes") {
    for (const double speed_m_per_s : {0.02, 0.1, 0.3, 0.8}) {
        HapticPlan plan = make_wall(500.0, 9.5);  // the usual coupling
        for (const SimulatedHandSettings& arm : {make_loose_grip(), SimulatedHandSettings{}}) {
            SimulatedHandSettings from_above = arm;
            from_above.start_pose_D = Pose::at(Vector3(0.0, 0.03, 0.0));
            plan.passivity.on = true;
            const Course with = press(plan, from_above, {speed_m_per_s, 0.01});
            plan.passivity.on = false;
            const Course without = press(plan, from_above, {speed_m_per_s, 0.01});
            CAPTURE(speed_m_per_s, arm.mass_kg, with.peak_J);
            CHECK(same_bytes(with.force_N, without.force_N));
            CHECK(with.braked_J == 0.0);
            CHECK(last_second(with, plan.rate_hz).mean_N > 0.4);
        }
    }
}

TEST_CASE("passivity: a weight that is carried up and down is left as it is, to the byte") {
    const auto carry = [](bool on) {
        HapticPlan plan;
        plan.expects_lesson = false;
        plan.expects_world = true;
        plan.carries_weight = true;
        plan.passivity.on = on;
        LatestValue<HandTarget> target;
        SimulatedHand hand(SimulatedHandSettings{}, target);
        auto channels = std::make_unique<HapticChannels>();
        HapticLoop loop(plan, hand, *channels);
        Course course;
        for (int k = 1; k <= 12000; ++k) {
            HandTarget wanted;
            wanted.pose_D.position =
                Vector3(0.1 * std::sin(0.004 * k), 0.15 * std::sin(0.006 * k), 0.0);
            target.publish(wanted);
            WorldFrame world;
            world.stamp_s = 0.001 * k;
            world.carried_force_W.y() = k % 4000 < 1500 ? 0.0 : -3.0;  // caught, and gone again
            channels->world.publish(world);
            loop.step(0.001 * k);
            course.force_N.push_back(loop.state().applied_W.force);
        }
        course.peak_J = loop.state().force_energy.peak_J;
        return course;
    };
    const Course with = carry(true);
    CHECK(same_bytes(with.force_N, carry(false).force_N));
    CHECK(with.force_N[9000].y() == 0.0);
    CHECK(with.force_N[7900].y() == Approx(-3.0));
    CHECK(with.peak_J < 1e-9);
}

TEST_CASE("passivity: a minute in honey is no licence for a wall to buzz") {
    // A spring without a damper far too stiff for its rate, after a liquid that was stirred for long.
    const auto shake = [](bool stirred) {
        HapticPlan plan = make_wall(2000.0, 0.0);
        plan.expects_lesson = true;
        plan.fields.push_back({FieldKind::viscosity, Vector3::Zero(), 0.0, 5.0});
        LatestValue<HandTarget> target;
        SimulatedHand hand(make_loose_grip(), target);
        auto channels = std::make_unique<HapticChannels>();
        HapticLoop loop(plan, hand, *channels);
        double most_N = 0.0;
        for (int k = 1; k <= 28000; ++k) {
            const double t_s = 0.001 * k;
            HandTarget wanted;
            wanted.pose_D.position.y() =
                t_s < 23.0 ? 0.04 + (stirred && t_s < 18.0 ? 0.03 * std::sin(6.0 * t_s) : 0.0)
                           : std::max(0.04 - 0.1 * (t_s - 23.0), -0.02);
            target.publish(wanted);
            ForceCommand command;
            command.stamp_s = t_s;
            command.lesson_alive = true;
            command.fields[0].on = t_s < 22.0;
            channels->command.publish(command);
            loop.step(t_s);
            if (k > 26000) {
                most_N = std::max(most_N, std::abs(loop.state().applied_W.force.norm() - 0.976));
            }
        }
        return most_N;
    };
    CHECK(shake(false) < 0.05);
    CHECK(shake(true) < 0.05);
}
