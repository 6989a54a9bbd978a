#include "haptics/device/mouse/pointer_device.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;

PointerTarget at(const Vector3& position_D) {
    PointerTarget target;
    target.position_D = position_D;
    return target;
}

}  // namespace

TEST_CASE("pointer: begins at the first target and follows the next in closed form") {
    const PointerSettings settings;
    LatestValue<PointerTarget> target;
    PointerDevice mouse(settings, target);
    DeviceReading reading;
    target.publish(at(Vector3(0.1, 0.0, 0.0)));
    CHECK(mouse.read(0.0, reading));
    CHECK(reading.pose_D.position == Vector3(0.1, 0.0, 0.0));
    PointerTarget next = at(Vector3(0.11, 0.0, 0.0));
    next.buttons = 5;
    target.publish(next);
    for (int k = 1; k <= 300; ++k) {
        CHECK(mouse.read(k * kDt_s, reading));
        const double wt = settings.natural_rad_per_s * k * kDt_s;
        REQUIRE(reading.pose_D.position.x() ==
                Approx(0.11 - 0.01 * std::exp(-wt) * (1.0 + wt)).margin(1e-12));
        REQUIRE(reading.stamp_s == k * kDt_s);
    }
    CHECK(reading.buttons == 5);
}

TEST_CASE("pointer: never faster than its limit, and arrives without overshoot") {
    const PointerSettings settings;
    LatestValue<PointerTarget> target;
    PointerDevice mouse(settings, target);
    DeviceReading reading;
    target.publish(at(Vector3(-0.2, 0.0, 0.0)));
    CHECK(mouse.read(0.0, reading));
    target.publish(at(Vector3(0.2, 0.2, 0.0)));
    Vector3 before = reading.pose_D.position;
    double fastest_m_per_s = 0.0;
    for (int k = 1; k <= 1000; ++k) {
        CHECK(mouse.read(k * kDt_s, reading));
        const double speed = (reading.pose_D.position - before).norm() / kDt_s;
        REQUIRE(speed <= settings.max_speed_m_per_s * (1.0 + 1e-9));
        REQUIRE(reading.pose_D.position.x() <= 0.2 + 1e-12);
        // Far from its target it keeps its pace.
        if (k > 15 && k < 100) {
            REQUIRE(speed == Approx(settings.max_speed_m_per_s));
        }
        fastest_m_per_s = std::max(fastest_m_per_s, speed);
        before = reading.pose_D.position;
    }
    CHECK(fastest_m_per_s == Approx(settings.max_speed_m_per_s));
    CHECK((before - Vector3(0.2, 0.2, 0.0)).norm() < 1e-9);
}

TEST_CASE("pointer: without smoothing the target is the pose, held within the box") {
    PointerSettings settings;
    settings.smoothing = PointerSmoothing::none;
    LatestValue<PointerTarget> target;
    PointerDevice mouse(settings, target);
    DeviceReading reading;
    target.publish(at(Vector3(0.1, -0.1, 0.05)));
    CHECK(mouse.read(0.0, reading));
    CHECK(reading.pose_D.position == Vector3(0.1, -0.1, 0.05));
    target.publish(at(Vector3(5.0, -5.0, 0.0)));
    CHECK(mouse.read(kDt_s, reading));
    CHECK(reading.pose_D.position == Vector3(0.2, -0.2, 0.0));
}

TEST_CASE("pointer: renders no force, and a target that is not finite leaves it where it is") {
    LatestValue<PointerTarget> target;
    PointerDevice mouse(PointerSettings{}, target);
    CHECK_FALSE(mouse.traits().renders_force);
    CHECK(mouse.write(0.0, {Vector3(1, 2, 3), Vector3::Zero()}));
    DeviceReading reading;
    target.publish(at(Vector3(0.1, 0.0, 0.0)));
    CHECK(mouse.read(0.0, reading));
    target.publish(at(Vector3(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0)));
    for (int k = 1; k < 100; ++k) {
        CHECK(mouse.read(k * kDt_s, reading));
    }
    CHECK(reading.pose_D.position == Vector3(0.1, 0.0, 0.0));
}

TEST_CASE("pointer: a loaded hand hangs lower by the sag and follows later in closed form") {
    PointerSettings settings;
    settings.sag_m_per_N = 0.004;
    settings.slow_per_N = 0.2;
    LatestValue<PointerTarget> target;
    PointerDevice mouse(settings, target);
    DeviceReading reading;
    target.publish(at(Vector3::Zero()));
    CHECK(mouse.read(0.0, reading));
    CHECK(mouse.write(0.0, Wrench{Vector3(0.0, -5.0, 0.0), Vector3::Zero()}));
    const double w = settings.natural_rad_per_s / (1.0 + 0.2 * 5.0);
    for (int k = 1; k <= 400; ++k) {
        CHECK(mouse.read(k * kDt_s, reading));
        const double wt = w * k * kDt_s;
        REQUIRE(reading.pose_D.position.y() ==
                Approx(-0.02 * (1.0 - std::exp(-wt) * (1.0 + wt))).margin(1e-12));
    }
    // What is no number is no load.
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(mouse.write(0.4, Wrench{Vector3(nan, 0.0, 0.0), Vector3::Zero()}));
    for (int k = 401; k <= 900; ++k) {
        CHECK(mouse.read(k * kDt_s, reading));
    }
    CHECK(std::abs(reading.pose_D.position.y()) < 1e-6);
}
