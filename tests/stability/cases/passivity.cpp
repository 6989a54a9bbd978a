// What a scene may feed into the hand: a wall without a damper, and a lesson that swings its spring with the hand.
#include "tests/stability/cases/stability_case.h"
#include "tests/support/wall_press.h"

#include <cmath>
#include <memory>

namespace fulcrum::stability {
namespace {

constexpr double kDt_s = 0.001;

// Walls of 500 to 2000 N/m pressed by a 50 g handle in a grip of 0.2 Ns/m: less than k T / 2 of each.
Finding press_undamped_walls() {
    Finding finding{0.0, 0.01, {}};
    for (const double stiffness_N_per_m : {500.0, 1000.0, 1500.0, 2000.0}) {
        HapticPlan plan = wall_press::make_wall(stiffness_N_per_m, 0.0);
        const auto shaking = wall_press::last_second(
            wall_press::press(plan, wall_press::make_loose_grip(), {}), plan.rate_hz);
        // Nothing felt is no wall that stands still.
        finding.take(shaking.mean_N > 0.5 ? shaking.force_N : HUGE_VAL,
                     describe("at %.0f N/m", stiffness_N_per_m));
    }
    return finding;
}

// At each answer the spring's anchor leaps to the side that the hand is moving to: the most that a lesson can feed in through it.
Finding swing_with_hand() {
    constexpr double kTenSeconds = 10.0;
    HapticPlan plan;
    FieldPlan spring;
    spring.stiffness_N_per_m = 100.0;
    plan.fields = {spring};
    LatestValue<HandTarget> target;
    target.publish({});
    SimulatedHand hand(SimulatedHandSettings{}, target);
    const auto channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, hand, *channels);
    ForceCommand command;
    command.lesson_alive = true;
    double given_J = 0.0;
    Vector3 last_W = Vector3::Zero();
    Vector3 held_W = Vector3::Zero();
    for (int k = 1; k <= 13000; ++k) {
        if (k > 2500 && k % 17 == 0) {
            const bool goes_on = loop.state().tool_twist_W.linear.x() >= 0.0;
            command.fields[0].anchor_W.x() = goes_on ? 0.1 : -0.1;
        }
        command.stamp_s = k * kDt_s;
        channels->command.publish(command);
        loop.step(k * kDt_s);
        const Vector3& now_W = loop.state().tool_pose_W.position;
        given_J += k > 3000 ? held_W.dot(now_W - last_W) : 0.0;
        last_W = now_W;
        held_W = loop.state().applied_W.force;
    }
    // The force limit and the arm's own damping bound it; it was 0.82 W when this was written.
    const double power_W = given_J / kTenSeconds;
    return {power_W > 0.0 ? power_W : HUGE_VAL, 1.0, "5 N at most, on the usual arm"};
}

const HardCase kWalls{{"walls without a damper in a loose grip",
                       "the passivity stage keeps them from buzzing at 1 kHz",
                       "force's root mean square about its mean, last second", "N",
                       press_undamped_walls}};
const HardCase kSwing{{"a lesson that swings its spring with the hand",
                       "at 60 Hz the anchor leaps to where the hand is going",
                       "power into the hand", "W", swing_with_hand}};

}  // namespace
}  // namespace fulcrum::stability
