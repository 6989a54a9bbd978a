// The simulated WAM on a bench of its own: a clock, a target, and what its motors give.
#pragma once

#include "haptics/device/arm/simulated_wam.h"
#include "haptics/math/rotation.h"
#include "tests/unit/haptics/device/arm/arm_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace fulcrum::arm_test {

inline constexpr double kTick_s = 0.001;

/// No dry friction and no encoders, so that a rest is an equilibrium.
inline SimulatedWamSettings make_smooth() {
    SimulatedWamSettings settings;
    for (ArmLink& link : settings.model.links) {
        link.dry_friction_Nm = 0.0;
    }
    for (ArmMotor& motor : settings.model.motors) {
        motor.counts_per_turn = 0.0;
    }
    return settings;
}

/// An arm with its target, and its clock.
struct Bench {
    explicit Bench(const SimulatedWamSettings& settings = {}) {
        auto made = SimulatedWam::create(settings, target);
        REQUIRE(made);
        wam = std::move(*made);
        REQUIRE(wam->read(0.0, reading));
    }
    void aim(const Vector3& position_D, const Vector3& turn = Vector3::Zero()) {
        HandTarget wanted;
        wanted.pose_D = {position_D, compute_exp(turn)};
        target.publish(wanted);
    }
    const DeviceReading& run(int n, double dt_s = kTick_s) {
        for (int i = 0; i < n; ++i) {
            now_s += dt_s;
            REQUIRE(wam->read(now_s, reading));
        }
        return reading;
    }
    [[nodiscard]] double find_most_torque() const {
        const ArmControl control(wam->model(), {make_wam_home(), 0.0});
        const JointVector motors = control.compute_motor_torque(wam->command().torque_Nm);
        double most = 0.0;
        for (int k = 0; k < 7; ++k) {
            most =
                std::max(most, std::abs(motors(k)) /
                                   wam->model().motors[static_cast<std::size_t>(k)].max_torque_Nm);
        }
        return most;
    }

    LatestValue<HandTarget> target;
    std::unique_ptr<SimulatedWam> wam;
    DeviceReading reading;
    double now_s = 0.0;
};

}  // namespace fulcrum::arm_test
