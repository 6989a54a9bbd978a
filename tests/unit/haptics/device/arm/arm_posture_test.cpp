#include "haptics/device/arm/arm_posture.h"

#include "haptics/math/rotation.h"
#include "tests/unit/haptics/device/arm/arm_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;
using namespace fulcrum::arm_test;

TEST_CASE("arm posture: two links in a plane are where sines and cosines put them") {
    ArmModel model = make_pendulum(1.0, 0.5);
    model.n = 2;
    model.links[1] = model.links[0];
    model.links[1].a_m = 0.3;
    model.transmission = JointMatrix::Identity(2, 2);
    const JointVector q = make_joints({0.4, -1.1});
    const ArmPosture posture = posture_of(model, q);
    const Vector3 expected(0.5 * std::cos(0.4) + 0.3 * std::cos(-0.7),
                           0.5 * std::sin(0.4) + 0.3 * std::sin(-0.7), 0.0);
    CHECK((posture.handle_B.position - expected).norm() < 1e-15);
    CHECK(posture.handle_B.orientation.angularDistance(compute_exp(Vector3(0.0, 0.0, -0.7))) <
          1e-12);
    CHECK(posture.jacobian_B(0, 0) == Approx(-expected.y()));
    CHECK(posture.jacobian_B(1, 1) == Approx(0.3 * std::cos(-0.7)));
}

TEST_CASE("arm posture: the Jacobian is the handle's derivative, by differences") {
    std::mt19937 random(1);
    const ArmModel wam = make_barrett_wam();
    constexpr double kStep_rad = 1e-6;  // truncation 1e-12, rounding 1e-10
    for (int k = 0; k < 100; ++k) {
        const JointVector q = draw(random, 7, 2.5);
        const ArmPosture posture = posture_of(wam, q);
        for (int i = 0; i < 7; ++i) {
            JointVector on = q;
            on(i) += kStep_rad;
            JointVector back = q;
            back(i) -= kStep_rad;
            const ArmPosture ahead = posture_of(wam, on);
            const ArmPosture behind = posture_of(wam, back);
            const Vector3 linear =
                (ahead.handle_B.position - behind.handle_B.position) / (2.0 * kStep_rad);
            const Vector3 turning =
                compute_log(ahead.handle_B.orientation * behind.handle_B.orientation.conjugate()) /
                (2.0 * kStep_rad);
            REQUIRE((posture.jacobian_B.col(i).head<3>() - linear).norm() < 1e-9);
            REQUIRE((posture.jacobian_B.col(i).tail<3>() - turning).norm() < 1e-9);
        }
    }
}

TEST_CASE("arm posture: every link's frame is a rotation, whatever the angles") {
    std::mt19937 random(2);
    const ArmModel wam = make_barrett_wam();
    for (int k = 0; k < 100; ++k) {
        const ArmPosture posture = posture_of(wam, draw(random, 7, 50.0));
        for (const Matrix3& turn : posture.turn_B) {
            REQUIRE((turn * turn.transpose() - Matrix3::Identity()).norm() < 1e-13);
            REQUIRE(turn.determinant() == Approx(1.0));
        }
    }
}
