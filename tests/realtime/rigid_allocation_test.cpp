// No round of a world of rigid bodies allocates, on one thread or more, nor of the hands that push and grip in it; and both sides run at
// once on threads of their own.
#include "tests/realtime/allocation_trap.h"
#include "tests/support/hands_in_world.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <cmath>
#include <thread>

using namespace fulcrum;
using fulcrum::test::BoxScene;
using fulcrum::test::HandsInWorld;

namespace {

BoxScene make_busy_scene(int n_threads) {
    BoxScene scene;
    scene.grip_buttons = 1U;
    scene.n_threads = n_threads;
    for (int i = 0; i < 6; ++i) {
        scene.boxes.push_back({.at_W = {0.1 * (i % 3 + 1), 0.03 + 0.061 * (i / 3), 0.0}});
    }
    return scene;
}

}  // namespace

TEST_CASE("no allocation: rounds of rigid bodies that are pushed, gripped, hidden and dropped") {
    for (const int n_threads : {1, 3}) {
        HandsInWorld hands(make_busy_scene(n_threads), {{-0.06, 0.03, 0.0}, {0.3, 0.14, 0.0}});
        double most_N = 0.0;
        const auto play = [&] {
            for (int i = 0; i < 2000; ++i) {
                hands.aim(0, {-0.06 + 1.0e-4 * i, 0.03, 0.0});
                hands.aim(1, {0.3, 0.14 - 0.03 * std::sin(0.004 * i), 0.0},
                          i / 500 % 2 == 1 ? 1U : 0U);
                if (i % 300 == 0) {
                    (void)hands.lesson.commands.push(
                        {i % 600 == 0 ? WorldCommand::Kind::drop : WorldCommand::Kind::hide,
                         5,
                         {0.2, 0.5, 0.0}});
                }
                hands.step();
                most_N = std::max(most_N, hands.state(1).applied_W.force.norm());
            }
        };
        CHECK(count_allocations(play) == 0);
        CHECK(most_N > 0.5);
        CHECK(hands.world().report().n_islands > 1);
    }
}

TEST_CASE("live: haptic loop and world of rigid bodies on threads of their own") {
    const BoxScene scene = make_busy_scene(2);
    RigidChannels rigid;
    HapticChannels channels;
    channels.rigid = &rigid;
    WorldChannels lesson;
    LatestValue<HandTarget> target;
    SimulatedArm arm({.start_D = {-0.06, 0.03, 0.0}}, target);
    target.publish({Pose::at({0.05, 0.03, 0.0}), Vector3::Zero(), 0U});
    HapticLoop loop(scene.make_hand(), arm, channels);
    RigidChannels* const hands[] = {&rigid};
    const auto world = std::move(RigidLoop::create(scene.make_world(), &lesson, hands)).value();
    std::atomic<int> n_world{0};
    std::atomic<bool> ends{false};
    std::thread beside([&] {
        while (!ends.load()) {
            world->step(1.0e-3 * n_world.fetch_add(1));
        }
    });
    for (int i = 0; i < 1500; ++i) {
        loop.step(1.0e-3 * i);
        // Neither runs away from the other's time for good.
        while (n_world.load() < i) {
            std::this_thread::yield();
        }
    }
    ends.store(true);
    beside.join();
    lesson.snapshot.take();
    CHECK(lesson.snapshot.value().bodies[0].pose_W.position.allFinite());
    CHECK(loop.state().applied_W.force.allFinite());
}
