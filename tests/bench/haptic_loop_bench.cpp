// What one round costs: prints CSV of medians and tails. Fixed input, warm-up, every round timed on its own; ratios against
// the bare loop of the same run, for machines are noisy.
//   bench_haptic_loop [ROUNDS]
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/dynamics/world_loop.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/support/scripted_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr int kWarmUp = 5000;

struct Times {
    double p50_us = 0.0, p99_us = 0.0, max_us = 0.0;
};

// Times `round(k)` for each k; `prepare(k)` runs before it and is not timed.
template <class Prepare, class Round>
Times measure(int n, Prepare prepare, Round round) {
    std::vector<double> times_us;
    times_us.reserve(static_cast<std::size_t>(n));
    for (int k = 1; k <= n + kWarmUp; ++k) {
        prepare(k);
        const auto before = std::chrono::steady_clock::now();
        round(k);
        const auto after = std::chrono::steady_clock::now();
        if (k > kWarmUp) {
            times_us.push_back(std::chrono::duration<double, std::micro>(after - before).count());
        }
    }
    std::sort(times_us.begin(), times_us.end());
    return {times_us[times_us.size() / 2], times_us[times_us.size() * 99 / 100], times_us.back()};
}

void print(const char* what, const Times& times, double base_us) {
    std::printf("%s,%.3f,%.3f,%.1f,%.2f\n", what, times.p50_us, times.p99_us, times.max_us,
                times.p50_us / base_us);
}

HapticPlan make_gravity_plan() {
    HapticPlan plan;
    plan.carries_weight = true;
    plan.expects_world = true;
    return plan;
}

// Feeds a loop as lesson and world would: 60 and 500 times a second.
void feed(HapticChannels& channels, int k) {
    if (k % 16 == 0) {
        ForceCommand command;
        command.stamp_s = k * kDt_s;
        command.lesson_alive = true;
        channels.command.publish(command);
    }
    if (k % 2 == 0) {
        WorldFrame world;
        world.stamp_s = k * kDt_s;
        world.carried_force_W.y() = k % 4000 < 2000 ? 0.0 : -3.0;
        channels.world.publish(world);
    }
}

Vector3 hand_position(int k) {
    return {0.1 * std::sin(0.006 * k), 0.05 * std::cos(0.004 * k), 0.0};
}

Times measure_loop(const HapticPlan& plan, int n, bool with_hand) {
    auto channels = std::make_unique<HapticChannels>();
    LatestValue<HandTarget> target;
    SimulatedHand hand(SimulatedHandSettings{}, target);
    ScriptedDevice scripted;
    HapticLoop loop(plan, with_hand ? static_cast<Device&>(hand) : scripted, *channels);
    return measure(
        n,
        [&](int k) {
            feed(*channels, k);
            scripted.pose_D.position = hand_position(k);
            HandTarget wanted;
            wanted.pose_D.position = hand_position(k);
            target.publish(wanted);
        },
        [&](int k) { loop.step(k * kDt_s); });
}

Times measure_world(int n, bool falling) {
    auto haptics = std::make_unique<HapticChannels>();
    auto channels = std::make_unique<WorldChannels>();
    WorldPlan plan;
    plan.bodies.resize(4);
    plan.catcher.present = true;
    WorldLoop loop(plan, {}, *channels, *haptics);
    return measure(
        n,
        [&](int k) {
            if (falling && k % 200 == 0) {
                for (std::int32_t i = 0; i < 4; ++i) {
                    channels->commands.push(
                        {WorldCommand::Kind::drop, i, Vector3(0.3 * i, 1.0, 0.0)});
                }
            }
        },
        [&](int k) { loop.step(k * 2.0 * kDt_s); });
}

}  // namespace

int main(int argc, char** argv) {
    const int n = argc > 1 ? std::max(std::atoi(argv[1]), 1000) : 200'000;
    HapticPlan bare;
    bare.expects_lesson = false;
    const Times base = measure_loop(bare, n, false);
    std::printf("round,p50_us,p99_us,max_us,ratio_to_bare\n");
    print("clock alone",
          measure(
              n, [](int) {}, [](int) {}),
          base.p50_us);
    print("haptic loop without any force", base, base.p50_us);
    print("haptic loop of the gravity plan", measure_loop(make_gravity_plan(), n, false),
          base.p50_us);
    print("haptic loop of the gravity plan and simulated hand",
          measure_loop(make_gravity_plan(), n, true), base.p50_us);
    HapticPlan low_pass = make_gravity_plan();
    low_pass.velocity_method = VelocityMethod::filtered_difference;
    print("the same with the low-pass estimator", measure_loop(low_pass, n, true), base.p50_us);
    print("world loop at rest", measure_world(n, false), base.p50_us);
    print("world loop with four bodies falling", measure_world(n, true), base.p50_us);
    return 0;
}
