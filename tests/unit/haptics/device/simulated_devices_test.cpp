// What every simulated device must obey, an arm of joints as a mass on a spring: nothing bad moves it, what is no wrench is no force, and the same
// input leads to the same bits. Their own laws stand in the tests of their names.
#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/device/arm/wam_bench.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kRounding = 1e-9;

using Target = LatestValue<HandTarget>;

struct Kind {
    const char* name;
    std::unique_ptr<Device> (*make)(Target& target);
    double sticks_m = 0.0;  // so far from where springs hold it its dry friction may leave it
    void (*reset)(Device& device) = nullptr;
};

template <class Simulated>
void reset(Device& device) {
    static_cast<Simulated&>(device).reset();
}

std::unique_ptr<Device> make_hand(Target& target) {
    return std::make_unique<SimulatedHand>(SimulatedHandSettings{}, target);
}
std::unique_ptr<Device> make_arm(Target& target) {
    return std::make_unique<SimulatedArm>(SimulatedArmSettings{}, target);
}
std::unique_ptr<Device> make_late_arm(Target& target) {
    SimulatedArmSettings settings = make_desktop_arm();
    settings.delay_s = 0.0007;
    settings.start_D = Vector3(0.01, 0.0, 0.0);
    return std::make_unique<SimulatedArm>(settings, target);
}
std::unique_ptr<Device> make_wam(Target& target) {
    return SimulatedWam::create({}, target).value();
}
std::unique_ptr<Device> make_late_wam(Target& target) {
    SimulatedWamSettings settings;
    settings.delay_s = 0.0007;
    return SimulatedWam::create(settings, target).value();
}
std::unique_ptr<Device> make_smooth_wam(Target& target) {
    return SimulatedWam::create(arm_test::make_smooth(), target).value();
}

// A device with its target, and its clock.
struct Bench {
    explicit Bench(std::unique_ptr<Device> (*make)(Target& target)) : device(make(target)) {
        REQUIRE(device->read(0.0, reading));
    }
    void aim(const Vector3& position_D, const Vector3& turn = Vector3::Zero()) {
        HandTarget wanted;
        wanted.pose_D = {position_D, compute_exp(turn)};
        target.publish(wanted);
    }
    const Vector3& run(int n) {
        for (int i = 0; i < n; ++i) {
            now_s += kDt_s;
            REQUIRE(device->read(now_s, reading));
            REQUIRE(is_finite(reading.pose_D));
        }
        return reading.pose_D.position;
    }
    bool write(const Vector3& force_D, const Vector3& torque_D = Vector3::Zero()) {
        return device->write(now_s, {force_D, torque_D});
    }

    Target target;
    std::unique_ptr<Device> device;
    DeviceReading reading;
    double now_s = 0.0;
};

}  // namespace

TEST_CASE(
    "simulated devices: bad times and targets move nothing, and what comes after them counts") {
    for (const Kind& kind :
         {Kind{"hand", make_hand}, Kind{"arm", make_arm}, Kind{"WAM", make_wam, 0.01}}) {
        INFO(kind.name);
        Bench bench(kind.make);
        const Vector3 home = bench.reading.pose_D.position;
        bench.aim({kNan, 0.0, 0.0});
        CHECK(bench.run(100) == home);
        HandTarget no_turn;
        no_turn.pose_D.orientation.coeffs().setZero();
        bench.target.publish(no_turn);
        CHECK(bench.run(100) == home);
        bench.aim({0.1, 0.0, 0.0});
        for (const double bad_s : {kNan, kInfinity, -1.0}) {
            CHECK(bench.device->read(bad_s, bench.reading));
            CHECK(bench.reading.pose_D.position == home);
        }
        CHECK(bench.run(3000).x() == Approx(0.1).margin(kind.sticks_m));
        for (const double bad_s : {kNan, kInfinity}) {
            CHECK(bench.device->read(bad_s, bench.reading));
            CHECK(is_finite(bench.reading.pose_D));
        }
        // A wrench written at no time acts from the last read on: 3 N on 300 N/m.
        CHECK(bench.device->write(kNan, {Vector3(3.0, 0.0, 0.0), Vector3::Zero()}));
        CHECK(bench.run(3000).x() == Approx(0.11).margin(kind.sticks_m));
        bench.aim(Vector3::Zero());
        CHECK(std::abs(bench.run(3000).x() - 0.01) < 1e-3 + kind.sticks_m);
    }
}

TEST_CASE("simulated devices: the first time of all may be none") {
    for (const auto make : {make_hand, make_arm}) {
        Target target;
        const auto device = make(target);
        HandTarget wanted;
        wanted.pose_D.position.x() = 0.1;
        target.publish(wanted);
        DeviceReading reading;
        CHECK(device->read(kNan, reading));
        for (int k = 1; k <= 1000; ++k) {
            REQUIRE(device->read(k * kDt_s, reading));
        }
        CHECK(reading.pose_D.position.x() == Approx(0.1).epsilon(1e-3));
    }
}

TEST_CASE("simulated devices: a wrench that is none is refused and leaves no force") {
    for (const Kind& kind :
         {Kind{"hand", make_hand}, Kind{"arm", make_arm}, Kind{"WAM", make_smooth_wam}}) {
        INFO(kind.name);
        Bench bench(kind.make);
        const Wrench wrenches[] = {{Vector3(kNan, 0.0, 0.0), Vector3::Zero()},
                                   {Vector3(0.0, kInfinity, 0.0), Vector3::Zero()},
                                   {Vector3::Zero(), Vector3(0.0, 0.0, kNan)}};
        for (const Wrench& bad : wrenches) {
            REQUIRE(bench.write({0.0, 5.0, 0.0}));
            CHECK(bench.run(300).y() > 0.005);
            CHECK_FALSE(bench.device->write(bench.now_s, bad));
            CHECK(bench.run(3000).norm() < 1e-4);
        }
    }
}

TEST_CASE("simulated devices: reset puts it back, and the same input moves it to the same bits") {
    for (const Kind& kind : {Kind{"hand", make_hand, 0.0, reset<SimulatedHand>},
                             Kind{"arm", make_late_arm, 0.0, reset<SimulatedArm>},
                             Kind{"WAM", make_late_wam, 0.0, reset<SimulatedWam>}}) {
        INFO(kind.name);
        Bench bench(kind.make);
        const Vector3 home = bench.reading.pose_D.position;
        const auto go = [&] {
            bench.now_s = 0.0;
            bench.aim({0.05, -0.07, 0.06}, {0.2, 0.0, -0.3});
            REQUIRE(bench.device->read(0.0, bench.reading));
            CHECK(bench.reading.pose_D.position == home);
            for (int k = 0; k < 777; ++k) {
                REQUIRE(bench.write({2.0 * std::sin(0.1 * k), 1.0, 0.0}));
                bench.run(1);
            }
            return bench.reading.pose_D;
        };
        const Pose first = go();
        kind.reset(*bench.device);
        const Pose again = go();
        CHECK(again.position == first.position);
        CHECK(again.orientation.coeffs() == first.orientation.coeffs());
        CHECK((first.position - home).norm() > 0.05);
    }
}

namespace {

// One device twice on one target, of which the second has an encoder.
template <class Simulated, class Settings>
void check_encoder(Settings settings, double step_m, const Vector3& to_D) {
    Target targets[2];
    Simulated exact(settings, targets[0]);
    settings.position_resolution_m = step_m;
    Simulated counted(settings, targets[1]);
    HandTarget wanted;
    wanted.pose_D.position = to_D;
    targets[0].publish(wanted);
    targets[1].publish(wanted);
    for (int k = 0; k < 1000; ++k) {
        DeviceReading truth;
        DeviceReading shown;
        REQUIRE(exact.read(k * kDt_s, truth));
        REQUIRE(counted.read(k * kDt_s, shown));
        const Vector3 steps = shown.pose_D.position / step_m;
        REQUIRE((steps - Vector3(steps.cwiseRound())).norm() < kRounding);
        REQUIRE((truth.pose_D.position - shown.pose_D.position).cwiseAbs().maxCoeff() <=
                0.5 * step_m + kRounding);
    }
    CHECK(counted.traits().position_resolution_m == step_m);
}

}  // namespace

TEST_CASE("simulated devices: an encoder shows the nearest whole step of where it is") {
    check_encoder<SimulatedHand>(SimulatedHandSettings{}, 0.001, {0.2, -0.13, 0.0});
    check_encoder<SimulatedArm>(SimulatedArmSettings{}, 5.5e-5, {0.02, -0.013, 0.0});
}
