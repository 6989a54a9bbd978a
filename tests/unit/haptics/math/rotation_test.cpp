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
