#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

#include <numbers>
#include <rapidcheck.h>

using namespace fulcrum;

namespace {

constexpr double kRounding = 1e-12;  // a few operations on numbers near 1

rc::Gen<Vector3> any_rotation_vector() {
    return rc::gen::map(rc::gen::tuple(rc::gen::inRange(-1000, 1001), rc::gen::inRange(-1000, 1001),
                                       rc::gen::inRange(-1000, 1001), rc::gen::inRange(0, 3100)),
                        [](const std::tuple<int, int, int, int>& t) {
                            const Vector3 axis(std::get<0>(t), std::get<1>(t), std::get<2>(t));
                            return axis.norm() > 0.0
                                       ? Vector3(axis.normalized() * (std::get<3>(t) * 0.001))
                                       : Vector3(Vector3::Zero());
                        });
}

}  // namespace

TEST_CASE("rotation: the exponential of a quarter turn about y takes z to x") {
    const Quaternion q = compute_exp(Vector3(0.0, 0.5 * std::numbers::pi, 0.0));
    CHECK((q * Vector3::UnitZ() - Vector3::UnitX()).norm() < kRounding);
}

TEST_CASE("rotation: the logarithm undoes the exponential below a half turn") {
    CHECK(rc::check([] {
        const Vector3 phi = *any_rotation_vector();
        const Quaternion q = compute_exp(phi);
        RC_ASSERT(std::abs(q.coeffs().norm() - 1.0) < kRounding);
        RC_ASSERT((compute_log(q) - phi).norm() < 1e-9);
        Quaternion negative = q;
        negative.coeffs() *= -1.0;
        RC_ASSERT((compute_log(negative) - phi).norm() < 1e-9);
    }));
}

TEST_CASE("rotation: small and zero turns lose no digit") {
    CHECK(compute_exp(Vector3::Zero()).w() == 1.0);
    CHECK(compute_log(Quaternion::Identity()).norm() == 0.0);
    for (const double angle_rad : {1e-12, 1e-9, 0.99e-4, 1.01e-4}) {
        const Vector3 phi(0.0, 0.0, angle_rad);
        CHECK(compute_log(compute_exp(phi)).z() == Approx(angle_rad).epsilon(1e-12));
    }
}

TEST_CASE("rotation: turns about one axis add up") {
    const Vector3 axis = Vector3(1.0, 2.0, -2.0) / 3.0;
    const Quaternion both = compute_exp(0.4 * axis) * compute_exp(0.7 * axis);
    CHECK((compute_log(both) - 1.1 * axis).norm() < kRounding);
}

TEST_CASE("rotation: the left Jacobian is the derivative of the exponential") {
    for (const Vector3& phi :
         {Vector3(0.0, 0.0, 0.0), Vector3(2e-4, -3e-4, 1e-4), Vector3(0.6e-3, 0.6e-3, 0.6e-3),
          Vector3(0.3, -0.7, 0.4), Vector3(-2.0, 1.0, 1.5), Vector3(3.0, 3.0, -3.0)}) {
        const Matrix3 jacobian = compute_left_jacobian(phi);
        for (int i = 0; i < 3; ++i) {
            const Vector3 d = 1e-6 * Vector3::Unit(i);
            const Vector3 difference =
                compute_log(compute_exp(phi + d) * compute_exp(phi - d).conjugate()) / 2e-6;
            CHECK((difference - jacobian.col(i)).norm() < 1e-8);
        }
    }
}

TEST_CASE("rotation: the right Jacobian's inverse is the derivative of the logarithm") {
    for (const Vector3& phi :
         {Vector3(0.0, 0.0, 0.0), Vector3(2e-4, -3e-4, 1e-4), Vector3(0.6e-3, 0.6e-3, 0.6e-3),
          Vector3(0.3, -0.7, 0.4), Vector3(-1.8, 1.0, 1.5), Vector3(0.0, 3.1, 0.0)}) {
        const Matrix3 inverse = compute_right_jacobian_inverse(phi);
        CHECK((inverse * compute_left_jacobian(-phi) - Matrix3::Identity()).norm() < 1e-10);
        for (int i = 0; i < 3; ++i) {
            const Vector3 d = 1e-6 * Vector3::Unit(i);
            const Vector3 difference = (compute_log(compute_exp(phi) * compute_exp(d)) -
                                        compute_log(compute_exp(phi) * compute_exp(-d))) /
                                       2e-6;
            CHECK((difference - inverse.col(i)).norm() < 1e-7);
        }
    }
}

TEST_CASE("rotation: the Jacobians' series and closed forms meet where they take turns") {
    const Vector3 axis = Vector3(1.0, -2.0, 2.0) / 3.0;
    const Vector3 below = 0.999999 * kJacobianSeries_rad * axis;
    const Vector3 above = 1.000001 * kJacobianSeries_rad * axis;
    CHECK((compute_left_jacobian(below) - compute_left_jacobian(above)).norm() < 1e-8);
    CHECK((compute_right_jacobian_inverse(below) - compute_right_jacobian_inverse(above)).norm() <
          1e-8);
    CHECK((compute_skew(Vector3(1.0, 2.0, 3.0)) * Vector3(-2.0, 0.5, 4.0) -
           Vector3(1.0, 2.0, 3.0).cross(Vector3(-2.0, 0.5, 4.0)))
              .norm() == 0.0);
}
