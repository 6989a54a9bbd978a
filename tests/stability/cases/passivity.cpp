// What a scene may feed into the hand: a wall without a damper, and a lesson that swings its spring with the hand.
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/touchable.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace fulcrum::stability {
namespace {

constexpr double kDt_s = 0.001;

// A hand of the simulation in a loop of the plan.
struct Stand {
    Stand(const HapticPlan& plan, const SimulatedHandSettings& settings)
        : hand(settings, target), loop(plan, hand, *channels) {}

    void step(int k, const Vector3& wanted_W) {
        HandTarget wanted;
        wanted.pose_D.position = wanted_W;
        target.publish(wanted);
        command.stamp_s = k * kDt_s;
        command.lesson_alive = true;
        channels->command.publish(command);
        loop.step(k * kDt_s);
    }
    LatestValue<HandTarget> target;
    SimulatedHand hand;
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    HapticLoop loop;
    ForceCommand command;
};

// Root mean square of the force about its mean in the last second, of walls of 500 to 2000 N/m pressed by a 50 g handle in a grip of
// 0.2 Ns/m: less than k T / 2 of each.
Finding press_undamped_walls() {
    double worst_N = 0.0;
    double stiffest_N_per_m = 0.0;
    for (const double stiffness_N_per_m : {500.0, 1000.0, 1500.0, 2000.0}) {
        HapticPlan plan;
        plan.coupling = {.stiffness_N_per_m = stiffness_N_per_m, .damping_Ns_per_m = 0.0};
        plan.solids = only_solid(touchable(make_box(Vector3::Constant(0.4))));
        plan.solids[0].initial_pose_W = Pose::at(Vector3(0.0, -0.2, 0.0));
        SimulatedHandSettings grip;
        grip.mass_kg = 0.05;
        grip.stiffness_N_per_m = 50.0;
        grip.damping_Ns_per_m = 0.2;
        grip.start_pose_D = Pose::at(Vector3(0.0, 0.03, 0.0));
        Stand stand(plan, grip);
        std::vector<double> last_N;
        for (int k = 1; k <= 7000; ++k) {
            const double way_m = 0.1 * std::max(k * kDt_s - 3.0, 0.0);
            stand.step(k, Vector3(0.0, std::max(0.03 - way_m, -0.02), 0.0));
            if (k > 6000) {
                last_N.push_back(stand.loop.state().applied_W.force.y());
            }
        }
        double mean_N = 0.0;
        double square_N2 = 0.0;
        for (const double force_N : last_N) {
            mean_N += force_N / static_cast<double>(last_N.size());
        }
        for (const double force_N : last_N) {
            square_N2 += std::pow(force_N - mean_N, 2) / static_cast<double>(last_N.size());
        }
        // Nothing felt is no wall that stands still.
        const double shaking_N = mean_N > 0.5 ? std::sqrt(square_N2) : HUGE_VAL;
        if (shaking_N > worst_N) {
            worst_N = shaking_N;
            stiffest_N_per_m = stiffness_N_per_m;
        }
    }
    return {worst_N, 0.01, "at " + std::to_string(std::lround(stiffest_N_per_m)) + " N/m"};
}

// At each answer the spring's anchor leaps to the side that the hand is moving to: the most that a lesson can feed in through it.
Finding swing_with_hand() {
    constexpr double kTenSeconds = 10.0;
    HapticPlan plan;
    FieldPlan spring;
    spring.stiffness_N_per_m = 100.0;
    plan.fields = {spring};
    Stand stand(plan, SimulatedHandSettings{});
    double given_J = 0.0;
    Vector3 last_W = Vector3::Zero();
    Vector3 held_W = Vector3::Zero();
    for (int k = 1; k <= 13000; ++k) {
        if (k > 2500 && k % 17 == 0) {
            const bool goes_on = stand.loop.state().tool_twist_W.linear.x() >= 0.0;
            stand.command.fields[0].anchor_W.x() = goes_on ? 0.1 : -0.1;
        }
        stand.step(k, Vector3::Zero());
        const Vector3& now_W = stand.loop.state().tool_pose_W.position;
        given_J += k > 3000 ? held_W.dot(now_W - last_W) : 0.0;
        last_W = now_W;
        held_W = stand.loop.state().applied_W.force;
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
