#include "runtime/arms/haply/haply_watch.h"

#include "haptics/base/clock.h"
#include "runtime/arms/haply/haply_session.h"
#include "tests/support/eventually.h"
#include "tests/support/haply_service.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test_support::eventually;
using test_support::HaplyOptions;
using test_support::HaplyService;

HaplyArm watched_arm(bool has_config) {
    HaplyArm arm;
    arm.id = "049D";
    if (has_config) {
        arm.config = HaplyConfig{};
    }
    return arm;
}

}  // namespace

TEST_CASE("haply watch: everything is asked for once a second") {
    HaplyWatch watch(watched_arm(true), {}, "", 1);
    watch.begin(watched_arm(true), {}, 100.0);
    int n = 0;
    for (int i = 1; i <= 5000; ++i) {
        n += watch.is_due(100.0 + 0.001 * i) ? 1 : 0;
    }
    CHECK(n >= 4);
    CHECK(n <= 5);
    CHECK(watch.change().empty());
}

TEST_CASE("haply watch: a change is found where it is told, and stays") {
    HaplyWatch watch(watched_arm(true), 1.0, "", 1);
    watch.begin(watched_arm(true), 1.0, 100.0);
    HaplyArm mirrored = watched_arm(true);
    mirrored.config->basis = "XZY";
    watch.note(mirrored, 100.5);
    CHECK(watch.change() == "the basis");
    watch.note(watched_arm(true), 100.6);
    watch.begin(watched_arm(true), 1.0, 101.0);
    CHECK(watch.change() == "the basis");
}

TEST_CASE("haply watch: a session that begins otherwise than the first did is a change") {
    HaplyWatch scale(watched_arm(true), 1.0, "", 1);
    scale.begin(watched_arm(true), 2.0, 100.0);
    CHECK(scale.change() == "the scale of forces");
    HaplyArm other = watched_arm(true);
    other.config->preset = "arm_front_centered";
    HaplyWatch preset(watched_arm(true), {}, "", 1);
    preset.begin(other, {}, 100.0);
    CHECK(preset.change() == "the preset");
}

TEST_CASE("haply watch: a service that tells its settings no more is not vouched for") {
    HaplyWatch watch(watched_arm(true), {}, "", 1);
    watch.begin(watched_arm(true), {}, 100.0);
    watch.note(watched_arm(false), 104.9);
    CHECK(watch.change().empty());
    watch.note(watched_arm(true), 104.95);
    watch.note(watched_arm(false), 109.9);
    CHECK(watch.change().empty());
    watch.note(watched_arm(false), 110.0);
    CHECK(watch.change() == "whether it tells its settings");
}

TEST_CASE("haply watch: the scale of forces is asked for on the way") {
    HaplyService service;
    HaplyWatch watch(watched_arm(true), 1.0, kHaplyScalePath, service.port());
    watch.begin(watched_arm(true), 1.0, monotonic_now_s());
    const auto asks_on = [&] {
        const double now_s = monotonic_now_s();
        (void)watch.is_due(now_s);
        watch.note(watched_arm(true), now_s);
        watch.step();
        return !watch.change().empty();
    };
    bool has_changed = false;
    for (const double until_s = monotonic_now_s() + 1.5; monotonic_now_s() < until_s;) {
        has_changed = asks_on() || has_changed;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK_FALSE(has_changed);
    service.change([](HaplyOptions& now) { now.force_scale = 2.0; });
    CHECK(eventually(asks_on));
    CHECK(watch.change() == "the scale of forces");
}

}  // namespace fulcrum::runtime
