#include "haptics/math/turned_slopes.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

TEST_CASE("turned slopes: along other axes they give the same change of the wrench") {
    Random random(3);
    for (int i = 0; i < 20; ++i) {
        const Matrix3 R = random.turn(3.0).toRotationMatrix();
        const auto slopes_B = random.matrix<Matrix6>();
        const Vector3 way_B = random.vector();
        const Vector3 turn_B = random.vector();
        Vector6 change_B;
        change_B << way_B, turn_B;
        Vector6 change_W;
        change_W << R * way_B, R * turn_B;
        const Vector6 wrench_B = slopes_B * change_B;
        const Vector6 wrench_W = compute_turned(slopes_B, R) * change_W;
        CHECK((wrench_W.head<3>() - R * wrench_B.head<3>()).norm() < 1.0e-12);
        CHECK((wrench_W.tail<3>() - R * wrench_B.tail<3>()).norm() < 1.0e-12);
    }
}

TEST_CASE("turned slopes: a wrench fixed in the body turns with it, and shifts leave it") {
    const Wrench wrench{{1.0, -2.0, 0.5}, {0.3, 0.7, -1.1}};
    Matrix6 slopes = Matrix6::Ones();
    add_turning(wrench, slopes);
    const Vector3 turn(2.0e-6, -1.0e-6, 3.0e-6);
    const Quaternion q = compute_exp(turn);
    const Matrix6 added = slopes - Matrix6::Ones();
    CHECK(added.leftCols<3>() == Matrix6::Zero().leftCols<3>());
    CHECK((added.topRightCorner<3, 3>() * turn - (q * wrench.force - wrench.force)).norm() <
          1.0e-10);
    CHECK((added.bottomRightCorner<3, 3>() * turn - (q * wrench.torque - wrench.torque)).norm() <
          1.0e-10);
}

}  // namespace
}  // namespace fulcrum
