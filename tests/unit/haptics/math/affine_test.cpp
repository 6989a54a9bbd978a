#include "haptics/math/affine.h"

#include "haptics/math/plain_eigen.h"
#include "haptics/math/to_eigen.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

namespace fulcrum {
namespace {

constexpr double kRounding = 1.0e-13;  // some hundred operations on numbers of about 1

double find_difference(const Affine& ours, const Eigen::Affine3d& judge) {
    return (to_eigen(ours.matrix()) - judge.matrix()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("affine: turning, scaling and moving act on a point before all that was done so far") {
    Random random(1);
    for (int round = 0; round < 100; ++round) {
        Affine map;
        Eigen::Affine3d judge = Eigen::Affine3d::Identity();
        for (int step = 0; step < 8; ++step) {
            const Quaternion turn = random.turn(3.0);
            const Vector3 by = random.in_cube();
            const double factor = 1.0 + 0.5 * random.uniform();
            const auto which = random.integer() % 4;
            if (which == 0) {
                map.rotate(turn);
                judge.rotate(Eigen::Quaterniond(turn.w(), turn.x(), turn.y(), turn.z()));
            } else if (which == 1) {
                map.scale(Vector3::Ones() + 0.5 * by);
                judge.scale((to_eigen(Vector3::Ones()) + 0.5 * to_eigen(by)).eval());
            } else if (which == 2) {
                map.scale(factor);
                judge.scale(factor);
            } else {
                map.translate(by);
                judge.translate(to_eigen(by));
            }
            CHECK(find_difference(map, judge) < kRounding);
        }
        const Vector3 p = random.vector();
        CHECK((to_eigen(map * p) - judge * to_eigen(p)).norm() < kRounding * (1.0 + p.norm()));
        CHECK((map * p - (map.linear() * p + map.translation())).norm() == 0.0);
        const Vector4 mapped = map.matrix() * (Vector4() << p, 1.0).finished();
        CHECK((mapped.head<3>() - map * p).norm() < kRounding * (1.0 + p.norm()));
        CHECK(mapped.w() == 1.0);
    }
}

TEST_CASE("affine: one that does nothing, one that only moves, one that only turns") {
    const Vector3 p(1.0, -2.0, 3.0);
    CHECK(Affine() * p == p);
    CHECK(Affine::Identity().matrix() == Matrix4::Identity());
    CHECK(Affine::at({4.0, 5.0, 6.0}) * p == Vector3(5.0, 3.0, 9.0));
    CHECK(Affine::at({4.0, 5.0, 6.0}).translation() == Vector3(4.0, 5.0, 6.0));
    const AngleAxis turn(0.7, Vector3(2.0, -1.0, 2.0) / 3.0);
    CHECK(Affine(turn).linear() == turn.toRotationMatrix());
    CHECK(Affine(turn).translation() == Vector3::Zero());
    // Moved last, it is moved along the turned axes.
    Affine both(turn);
    both.translate(Vector3::UnitX());
    CHECK(both.translation() == turn.toRotationMatrix().col(0).eval());
}

}  // namespace fulcrum
