#include "haptics/device/watched/watched_device.h"

#include "haptics/device/mouse/pointer_device.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/support/scripted_device.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

using namespace fulcrum;

namespace {

// A lesson's spring pulls at a watched device, whose sensor tells what `tell` says, for so long; what the loop makes of it.
struct Course {
    Fault faults = Fault::none;  // all
    double noticed_s = -1.0;     // the first, once the force was there
    double felt_N = 0.0;         // then
    double gone_s = -1.0;        // from then until there was no force
};

class Bench {
  public:
    explicit Bench(const SensorWatch& watch) {
        auto inner = std::make_unique<ScriptedDevice>();
        told_ = inner.get();
        begin(std::make_unique<WatchedDevice>(watch, std::move(inner)));
    }
    explicit Bench(std::unique_ptr<Device> device) { begin(std::move(device)); }

    // Pulls with `strength` times 4 N, and tells the place.
    void step(const Vector3& position_D, double strength) {
        now_s_ += 0.001;
        if (told_ != nullptr) {
            told_->pose_D.position = position_D;
        }
        ForceCommand command;
        command.lesson_alive = true;
        command.stamp_s = now_s_;
        command.fields[0].strength = strength;
        command.fields[0].anchor_W = {0.02, 0.0, 0.0};
        channels_->command.publish(command);
        loop_->step(now_s_);
    }
    // Three seconds of a hand that trembles, so that the gate is open and the force is there.
    void hold() {
        for (int i = 0; i < 3000; ++i) {
            step(tremble(i), 1.0);
        }
        REQUIRE(force_N() > 2.0);
        REQUIRE_FALSE(any(loop_->state().faults));
    }
    static Vector3 tremble(int i) { return {1.0e-5 * std::sin(0.05 * i), 0.0, 0.0}; }
    Course run(const std::function<Vector3(int)>& tell, const std::function<double(int)>& strength,
               int rounds) {
        Course course;
        course.felt_N = force_N();
        for (int i = 0; i < rounds; ++i) {
            step(tell(i), strength(i));
            const Fault faults = loop_->state().faults;
            course.faults |= faults;
            if (any(faults) && course.noticed_s < 0.0) {
                course.noticed_s = 0.001 * (i + 1);
            }
            if (course.noticed_s >= 0.0 && course.gone_s < 0.0 && force_N() == 0.0) {
                course.gone_s = 0.001 * (i + 1);
            }
        }
        return course;
    }
    [[nodiscard]] double force_N() const { return loop_->state().applied_W.force.norm(); }

  private:
    void begin(std::unique_ptr<Device> device) {
        device_ = std::move(device);
        HapticPlan plan;
        plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 200.0}};
        loop_ = std::make_unique<HapticLoop>(plan, *device_, *channels_);
    }

    ScriptedDevice* told_ = nullptr;
    std::unique_ptr<Device> device_;
    std::unique_ptr<HapticChannels> channels_ = std::make_unique<HapticChannels>();
    std::unique_ptr<HapticLoop> loop_;
    double now_s_ = 0.0;
};

const Vector3 kThere(0.001, 0.0, 0.0);
Vector3 stays(int) {
    return kThere;
}
double pulls(int) {
    return 1.0;
}
// The lesson lets go after a tenth of a second, as no hand that lives could not be moved by.
double lets_go(int i) {
    return i < 100 ? 1.0 : 0.1;
}

constexpr SensorLife kMotors{.moves_at_N = 2.0};

}  // namespace

TEST_CASE("watched device: a sensor that is frozen while the force changes fades the force") {
    Bench bench({kMotors});
    bench.hold();
    const Course course = bench.run(stays, lets_go, 500);
    CHECK(course.faults == Fault::device_stale);
    // When the force had changed by 2 N, for a lesson's force goes by and by, and the handle has not answered for as long as it may take.
    CHECK(course.noticed_s > 0.1 + SensorGuard::kAnswer_s);
    CHECK(course.noticed_s < 0.1 + SensorGuard::kAnswer_s + 0.06);
    CHECK(course.gone_s > 0.0);
    CHECK(course.gone_s <= course.noticed_s + 0.101);
}

TEST_CASE("watched device: a sensor known to tremble is frozen by its stillness alone") {
    Bench bench({{.trembles_within_s = 0.05}});
    bench.hold();
    const Course course = bench.run(stays, pulls, 300);
    CHECK(course.faults == Fault::device_stale);
    CHECK(course.noticed_s == Approx(0.052).margin(0.003));
    CHECK(course.gone_s <= course.noticed_s + 0.101);
}

TEST_CASE("watched device: a sensor that jumps, and one that shakes, fade the force") {
    Bench jumping({kMotors});
    jumping.hold();
    const Course jumped = jumping.run(
        [](int i) { return Vector3(Bench::tremble(i) + Vector3(0.1, 0.0, 0.0)); }, pulls, 300);
    CHECK(jumped.faults == Fault::device_invalid);
    CHECK(jumped.noticed_s == Approx(0.001));
    CHECK(jumped.gone_s <= 0.102);
    Bench shaking({{.most_m_per_s2 = 300.0}});
    shaking.hold();
    const Course shaken = shaking.run(
        [](int i) { return Vector3(i % 2 == 0 ? 0.001 : -0.001, 0.0, 0.0); }, pulls, 300);
    CHECK(shaken.faults == Fault::device_invalid);
    CHECK(shaken.noticed_s < 0.02);
}

TEST_CASE("watched device: what may stand still, at an end or without a motor, does") {
    // Nothing is known of it, as of a mouse or a SpaceMouse.
    Bench unknown(SensorWatch{});
    unknown.hold();
    const Course still = unknown.run(stays, lets_go, 60'000);
    CHECK(still.faults == Fault::none);
    // A mouse that nobody moves.
    LatestValue<PointerTarget> target;
    target.publish({});
    Bench mouse(std::make_unique<WatchedDevice>(
        SensorWatch{}, std::make_unique<PointerDevice>(PointerSettings{}, target)));
    const Course rest = mouse.run(stays, lets_go, 10'000);
    CHECK(rest.faults == Fault::none);
    SensorWatch at_stop{kMotors};
    at_stop.stop_D = {kThere.x(), 0.15, 0.15};
    Bench stopped(at_stop);
    stopped.hold();
    CHECK(stopped.run(stays, lets_go, 1000).faults == Fault::none);
    Bench stopped_back(at_stop);
    stopped_back.hold();
    const auto stays_back = [](int) { return Vector3(-kThere); };
    CHECK(stopped_back.run(stays_back, lets_go, 1000).faults == Fault::none);
    SensorWatch unpushed{kMotors};
    unpushed.pushed_D = {0.0, 1.0, 1.0};
    Bench loose(unpushed);
    loose.hold();
    CHECK(loose.run(stays, lets_go, 1000).faults == Fault::none);
}

TEST_CASE("watched device: after another clock it is watched from its first reading on") {
    auto inner = std::make_unique<ScriptedDevice>();
    inner->traits_.position_resolution_m = 1.0e-5;
    ScriptedDevice& scripted = *inner;
    WatchedDevice device({.life = {.moves_at_N = 1.0}}, std::move(inner));
    Fault seen = Fault::none;
    // Written 3 N from its second reading on, while its place stays the same to the bit.
    const auto hold = [&](double from_s) {
        seen = Fault::none;
        for (int i = 0; i < 300; ++i) {
            DeviceReading reading;
            REQUIRE(device.read(from_s + 0.001 * i, reading));
            seen |= reading.faults;
            if (i < 50) {
                CHECK(seen == Fault::none);
            }
            REQUIRE(
                device.write(from_s + 0.001 * i, {{i > 0 ? 3.0 : 0.0, 0.0, 0.0}, Vector3::Zero()}));
        }
    };
    hold(20.0);
    CHECK(any(seen & Fault::device_stale));
    REQUIRE(device.write(20.3, Wrench{}));
    scripted.pose_D.position.x() = 0.01;
    device.begin_anew();
    hold(0.0);
    CHECK(any(seen & Fault::device_stale));
}

TEST_CASE("watched device: a time without a reading, or at a stop, is no stillness under a push") {
    auto inner = std::make_unique<ScriptedDevice>();
    ScriptedDevice& scripted = *inner;
    WatchedDevice device({.life = {.moves_at_N = 1.0}, .stop_D = {0.1, 0.0, 0.0}},
                         std::move(inner));
    double now_s = 0.0;
    const auto hold = [&](double x, double force_N, int rounds) {
        Fault seen = Fault::none;
        scripted.pose_D.position.x() = x;
        for (int i = 0; i < rounds; ++i) {
            now_s += 0.001;
            DeviceReading reading;
            CHECK(device.read(now_s, reading) == scripted.gives_pose);
            seen |= reading.faults;
            REQUIRE(device.write(now_s, {{force_N, 0.0, 0.0}, Vector3::Zero()}));
        }
        return seen;
    };
    CHECK(hold(0.05, 0.0, 5) == Fault::none);
    CHECK(hold(0.05, 3.0, 90) == Fault::none);
    scripted.gives_pose = false;
    (void)hold(0.05, 3.0, 200);
    scripted.gives_pose = true;
    CHECK(hold(0.05, 3.0, 90) == Fault::none);
    CHECK(hold(0.05, 0.0, 5) == Fault::none);
    CHECK(hold(0.06, 0.0, 5) == Fault::none);
    CHECK(hold(0.06, 3.0, 90) == Fault::none);
    CHECK(hold(0.1, 3.0, 200) == Fault::none);
    CHECK(hold(0.06, 3.0, 90) == Fault::none);
}
