#include "runtime/arms/arm_device.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum::runtime {
namespace {

// A port whose thread is the test's.
class HeldPort final : public ArmPort {
  public:
    explicit HeldPort(int& stops) : stops_(stops) {}
    void stop() noexcept override { ++stops_; }
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    [[nodiscard]] std::vector<ArmFact> facts() const override { return {}; }
    using ArmPort::tell;
    using ArmPort::wanted_D;

  private:
    DeviceTraits traits_{.name = "held 1", .renders_force = true, .max_force_N = 3.0};
    int& stops_;
};

struct Held {
    int stops = 0;
    HeldPort* port = new HeldPort(stops);
    ArmDevice device{std::unique_ptr<ArmPort>(port)};
};

}  // namespace

TEST_CASE("arm device: a pose is as old on the loop's clock as it is on the machine's") {
    Held held;
    DeviceReading reading;
    CHECK_FALSE(held.device.read(5.0, reading));
    CHECK_FALSE(held.device.write(5.0, {}));
    ArmSample sample{.stamp_s = monotonic_now_s() - 0.5, .buttons = 3, .is_there = true};
    sample.pose_D.position = {0.01, 0.02, 0.03};
    held.port->sample.publish(sample);
    REQUIRE(held.device.read(5.0, reading));
    // As late as the machine lets the test be, never younger.
    CHECK(reading.stamp_s <= 4.5);
    CHECK(reading.stamp_s > 3.5);
    CHECK(reading.pose_D.position == Vector3{0.01, 0.02, 0.03});
    CHECK(reading.buttons == 3);
    CHECK(held.device.write(5.0, {}));
}

TEST_CASE("arm device: the stamp of a pose never goes back, however late a round reads it") {
    Held held;
    held.port->sample.publish({.stamp_s = monotonic_now_s(), .is_there = true});
    DeviceReading reading;
    REQUIRE(held.device.read(5.0, reading));
    const double first_s = reading.stamp_s;
    // 20 ms pass on the machine's clock, and 1 ms on the loop's.
    const double until_s = monotonic_now_s() + 0.02;
    while (monotonic_now_s() < until_s) {
    }
    REQUIRE(held.device.read(5.001, reading));
    CHECK(reading.stamp_s >= first_s);
    // A clock that begins anew is another one.
    REQUIRE(held.device.read(0.0, reading));
    CHECK(reading.stamp_s <= 0.0);
}

TEST_CASE("arm device: an order counts for the silence and no longer, and none that is no number") {
    Held held;
    CHECK(held.port->wanted_D(monotonic_now_s()).force == Vector3::Zero());
    const Vector3 force{1.0, -2.0, 0.5};
    (void)held.device.write(0.0, {.force = force});
    const double at_s = monotonic_now_s();
    (void)held.port->order.take();
    const double sent_s = held.port->order.value().stamp_s;
    CHECK(sent_s <= at_s);
    CHECK(held.port->wanted_D(sent_s + 0.019).force == force);
    CHECK(held.port->wanted_D(sent_s + 0.021).force == Vector3::Zero());
    Wrench broken{.force = force};
    broken.torque[1] = std::numeric_limits<double>::quiet_NaN();
    (void)held.device.write(0.0, broken);
    CHECK(held.port->wanted_D(monotonic_now_s()).force == Vector3::Zero());
}

TEST_CASE("arm device: what has happened is told once; whoever lets go of it stops the arm") {
    int stops = 0;
    {
        auto port = std::make_unique<HeldPort>(stops);
        port->tell("The arm is warm: let it rest.");
        CHECK(port->take_notice() == "The arm is warm: let it rest.");
        CHECK(port->take_notice().empty());
        const ArmDevice device(std::move(port));
    }
    CHECK(stops == 1);
}

}  // namespace fulcrum::runtime
