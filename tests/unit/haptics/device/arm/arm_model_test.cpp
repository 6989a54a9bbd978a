#include "haptics/device/arm/arm_model.h"

#include "tests/unit/haptics/device/arm/arm_fixture.h"

#include <catch2/catch.hpp>

#include <limits>
#include <string>

using namespace fulcrum;
using namespace fulcrum::arm_test;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// What is wrong with a pendulum after `spoil`.
template <class Spoil>
std::string complain(Spoil spoil) {
    ArmModel model = make_pendulum(1.0, 0.5);
    spoil(model);
    const auto checked = validate(model);
    return checked ? std::string() : to_sentence(checked.error());
}

}  // namespace

TEST_CASE("arm model: arms that can be moved are accepted") {
    CHECK(validate(make_pendulum(1.0, 0.5)));
    CHECK(validate(make_barrett_wam()));
    CHECK(validate(make_free_wam()));
}

TEST_CASE("arm model: what is no arm is refused, and said in a sentence") {
    CHECK(complain([](ArmModel& m) { m.n = 0; }).find("0 joints") != std::string::npos);
    CHECK(complain([](ArmModel& m) { m.n = kMostJoints + 1; }).find("8 joints") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) { m.links[0].mass_kg = -1.0; }).find("link 1") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) { m.links[0].mass_kg = 0.0; }).find("neither mass") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) { m.links[0].alpha_rad = kNan; }).find("alpha_rad") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) { m.links[0].high_rad = -51.0; }).find("high_rad") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) { m.links[0].damping_Nms_per_rad = 0.0; }).find("damping") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) { m.links[0].centre_m.x() = kNan; }).find("centre") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) { m.links[0].inertia_kg_m2(0, 1) = 1.0; }).find("symmetric") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) {
              m.links[0].inertia_kg_m2(0, 0) = -1.0;
          }).find("negative eigenvalue") != std::string::npos);
    CHECK(complain([](ArmModel& m) { m.motors[0].max_torque_Nm = 0.0; }).find("motor 1") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) { m.transmission(0, 0) = 0.0; }).find("transmission") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) { m.transmission = JointMatrix(2, 2); }).find("transmission") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) { m.handle.orientation.coeffs().setZero(); }).find("handle") !=
          std::string::npos);
    CHECK(complain([](ArmModel& m) { m.gravity_B.y() = kNan; }).find("gravity") !=
          std::string::npos);
    // A rotor alone is inertia enough.
    CHECK(complain([](ArmModel& m) {
              m.links[0].mass_kg = 0.0;
              m.motors[0].rotor_inertia_kg_m2 = 0.1;
          }).empty());
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
