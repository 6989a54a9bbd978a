#include "haptics/device/arm/arm_model.h"

#include "tests/unit/haptics/device/arm/arm_fixture.h"

#include <catch2/catch.hpp>

#include <limits>
#include <string>

using namespace fulcrum;
using namespace fulcrum::arm_test;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// What is done to a pendulum, and what the sentence says of it.
struct Spoiled {
    void (*spoil)(ArmModel& model);
    const char* told;
};

}  // namespace

TEST_CASE("arm model: arms that can be moved are accepted") {
    CHECK(validate(make_pendulum(1.0, 0.5)));
    CHECK(validate(make_barrett_wam()));
    CHECK(validate(make_free_wam()));
}

TEST_CASE("arm model: what is no arm is refused, and said in a sentence") {
    const Spoiled arms[] = {
        {[](ArmModel& m) { m.n = 0; }, "0 joints"},
        {[](ArmModel& m) { m.n = kMostJoints + 1; }, "8 joints"},
        {[](ArmModel& m) { m.links[0].mass_kg = -1.0; }, "link 1"},
        {[](ArmModel& m) { m.links[0].mass_kg = 0.0; }, "neither mass"},
        {[](ArmModel& m) { m.links[0].alpha_rad = kNan; }, "alpha_rad"},
        {[](ArmModel& m) { m.links[0].high_rad = -51.0; }, "high_rad"},
        {[](ArmModel& m) { m.links[0].damping_Nms_per_rad = 0.0; }, "damping"},
        {[](ArmModel& m) { m.links[0].centre_m.x() = kNan; }, "centre"},
        {[](ArmModel& m) { m.links[0].inertia_kg_m2(0, 1) = 1.0; }, "symmetric"},
        {[](ArmModel& m) { m.links[0].inertia_kg_m2(0, 0) = -1.0; }, "negative eigenvalue"},
        {[](ArmModel& m) { m.motors[0].max_torque_Nm = 0.0; }, "motor 1"},
        {[](ArmModel& m) { m.transmission(0, 0) = 0.0; }, "transmission"},
        {[](ArmModel& m) { m.transmission = JointMatrix(2, 2); }, "transmission"},
        {[](ArmModel& m) { m.handle.orientation.coeffs().setZero(); }, "handle"},
        {[](ArmModel& m) { m.gravity_B.y() = kNan; }, "gravity"}};
    for (const Spoiled& arm : arms) {
        ArmModel model = make_pendulum(1.0, 0.5);
        arm.spoil(model);
        INFO(arm.told);
        const auto checked = validate(model);
        REQUIRE_FALSE(checked);
        CHECK(to_sentence(checked.error()).find(arm.told) != std::string::npos);
    }
    // A rotor alone is inertia enough.
    ArmModel rotor = make_pendulum(1.0, 0.5);
    rotor.links[0].mass_kg = 0.0;
    rotor.motors[0].rotor_inertia_kg_m2 = 0.1;
    CHECK(validate(rotor));
}

TEST_CASE("arm model: a rotor counts with the square of its ratio, and two on a differential add") {
    ArmModel model = make_pendulum(1.0, 0.5);
    model.n = 2;
    model.motors[0].rotor_inertia_kg_m2 = 0.001;
    model.motors[1].rotor_inertia_kg_m2 = 0.002;
    model.transmission = JointMatrix(2, 2);
    model.transmission(0, 0) = model.transmission(1, 0) = 10.0;
    model.transmission(0, 1) = -5.0;
    model.transmission(1, 1) = 5.0;
    const JointMatrix inertia = compute_rotor_inertia(model);
    CHECK(inertia(0, 0) == Approx(0.3));
    CHECK(inertia(1, 1) == Approx(0.075));
    CHECK(inertia(0, 1) == Approx(0.05));
    CHECK(inertia(1, 0) == Approx(0.05));
}
