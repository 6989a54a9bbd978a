#include "haptics/math/orientation.h"
#include "haptics/math/plain_eigen.h"
#include "haptics/math/quaternion.h"
#include "haptics/math/rotation.h"
#include "haptics/math/to_eigen.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
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

constexpr double kTurnRounding = 4.0e-15;  // some ten operations on numbers of about 1
constexpr double kPi = std::numbers::pi;
constexpr int kRounds = 500;

Eigen::Quaterniond to_judge(const Quaternion& q) {
    return {q.w(), q.x(), q.y(), q.z()};
}
double find_difference(const Quaternion& q, const Eigen::Quaterniond& judge) {
    return (to_eigen(q.coeffs()) - judge.coeffs()).norm();
}
// Any rotation.
Quaternion draw(Random& random) {
    return Quaternion(random.matrix<Vector4>()).normalized();
}
// Any two rotations and a vector, again and again.
template <class Law>
void for_each_draw(unsigned seed, const Law& law) {
    Random random(seed);
    for (int round = 0; round < kRounds; ++round) {
        const Quaternion q = draw(random);
        const Quaternion p = draw(random);
        law(q, p, random.vector());
    }
}
// q and -q turn alike.
double find_turn_difference(const Quaternion& a, const Quaternion& b) {
    return std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
}

}  // namespace

TEST_CASE("rotation: exponential and logarithm undo each other, small turns too, and add up") {
    const Quaternion quarter = compute_exp(Vector3(0.0, 0.5 * std::numbers::pi, 0.0));
    CHECK((quarter * Vector3::UnitZ() - Vector3::UnitX()).norm() < kRounding);
    CHECK(rc::check([] {
        const Vector3 phi = *any_rotation_vector();
        const Quaternion q = compute_exp(phi);
        RC_ASSERT(std::abs(q.coeffs().norm() - 1.0) < kRounding);
        RC_ASSERT((compute_log(q) - phi).norm() < 1e-9);
        Quaternion negative = q;
        negative.coeffs() *= -1.0;
        RC_ASSERT((compute_log(negative) - phi).norm() < 1e-9);
    }));
    CHECK(compute_exp(Vector3::Zero()).w() == 1.0);
    CHECK(compute_log(Quaternion::Identity()).norm() == 0.0);
    for (const double angle_rad : {1e-12, 1e-9, 0.99e-4, 1.01e-4}) {
        const Vector3 phi(0.0, 0.0, angle_rad);
        CHECK(compute_log(compute_exp(phi)).z() == Approx(angle_rad).epsilon(1e-12));
    }
    const Vector3 axis = Vector3(1.0, 2.0, -2.0) / 3.0;
    const Quaternion both = compute_exp(0.4 * axis) * compute_exp(0.7 * axis);
    CHECK((compute_log(both) - 1.1 * axis).norm() < kRounding);
}

TEST_CASE("rotation: the left Jacobian is the derivative, and series and closed forms meet") {
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

TEST_CASE("orientation: a right-handed corner is positive, its mirror negative, a flat one zero") {
    const Vector3 o = Vector3::Zero();
    CHECK(orientation(o, Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()) == 1);
    CHECK(orientation(o, Vector3::UnitY(), Vector3::UnitX(), Vector3::UnitZ()) == -1);
    CHECK(orientation(o, Vector3::UnitX(), Vector3::UnitY(), Vector3(3.0, -2.0, 0.0)) == 0);
}

TEST_CASE("orientation: exact where rounding is not: one step of a coordinate decides") {
    // On the plane x + y + z = 1 in numbers that are no multiples of each other, moved by one unit in the last place.
    const Vector3 a(0.1, 0.2, 0.7);
    const Vector3 b(0.5, 0.25, 0.25);
    const Vector3 c(0.125, 0.75, 0.125);
    const Vector3 middle = (a + b + c) / 3.0;
    int n_positive = 0;
    int n_negative = 0;
    for (int steps = -40; steps <= 40; ++steps) {
        Vector3 d = middle;
        for (int i = 0; i < std::abs(steps); ++i) {
            d.z() = std::nextafter(d.z(), steps > 0 ? 2.0 : -2.0);
        }
        const int sign = orientation_exact(a, b, c, d);
        // The sign follows d through the plane: it can change only once.
        if (n_positive > 0) {
            REQUIRE(sign == 1);
        }
        n_positive += sign > 0 ? 1 : 0;
        n_negative += sign < 0 ? 1 : 0;
    }
    CHECK(n_positive > 30);
    CHECK(n_negative > 30);
}

TEST_CASE("orientation: agrees with integers on a small grid, for any order of the points") {
    std::mt19937_64 random(5);
    std::uniform_int_distribution<int> coordinate(-3, 3);
    const double far = 1048576.0 + 1.0 / 1024.0;  // rounds products, not differences
    for (int round = 0; round < 20000; ++round) {
        std::array<Matrix<std::int64_t, 3, 1>, 4> exact;
        std::array<Vector3, 4> points;
        for (std::size_t i = 0; i < 4; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                const int value = coordinate(random);
                exact[i][axis] = value;
                points[i][axis] = value * std::ldexp(1.0, -30) + far;
            }
        }
        const Matrix<std::int64_t, 3, 1> u = exact[1] - exact[0];
        const Matrix<std::int64_t, 3, 1> v = exact[2] - exact[0];
        const Matrix<std::int64_t, 3, 1> w = exact[3] - exact[0];
        const std::int64_t determinant = u[0] * (v[1] * w[2] - v[2] * w[1]) +
                                         u[1] * (v[2] * w[0] - v[0] * w[2]) +
                                         u[2] * (v[0] * w[1] - v[1] * w[0]);
        const int expected = determinant > 0 ? 1 : (determinant < 0 ? -1 : 0);
        REQUIRE(orientation(points[0], points[1], points[2], points[3]) == expected);
        REQUIRE(orientation_exact(points[0], points[1], points[2], points[3]) == expected);
        REQUIRE(orientation(points[1], points[0], points[2], points[3]) == -expected);
        REQUIRE(orientation(points[3], points[0], points[1], points[2]) == -expected);
        REQUIRE(orientation(points[2], points[3], points[0], points[1]) == expected);
    }
}

TEST_CASE("orientation: the quick answer is the exact one for points coplanar to within rounding") {
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto point = [&] { return Vector3(unit(random), unit(random), unit(random)); };
    for (int round = 0; round < 20000; ++round) {
        const double scale = std::pow(10.0, 6.0 * unit(random));
        const Vector3 a = scale * point();
        const Vector3 b = scale * point();
        const Vector3 c = scale * point();
        const Vector3 d = a + unit(random) * (b - a) + unit(random) * (c - a) +
                          scale * std::pow(10.0, -16.0 + 2.0 * unit(random)) * point();
        REQUIRE(orientation(a, b, c, d) == orientation_exact(a, b, c, d));
    }
}

TEST_CASE("quaternion: what it computes is what another library does") {
    for_each_draw(1, [](const Quaternion& q, const Quaternion& p, const Vector3& v) {
        const Eigen::Quaterniond jq = to_judge(q);
        const Eigen::Quaterniond jp = to_judge(p);
        CHECK(find_difference(q * p, jq * jp) < kTurnRounding);
        CHECK(find_difference(q.conjugate(), jq.conjugate()) == 0.0);
        CHECK(find_difference(q.inverse(), jq.inverse()) < kTurnRounding);
        CHECK(std::abs(q.dot(p) - jq.dot(jp)) < kTurnRounding);
        CHECK(std::abs(q.angularDistance(p) - jq.angularDistance(jp)) < 4.0 * kTurnRounding);
        CHECK((to_eigen(q * v) - jq * to_eigen(v)).norm() < 4.0 * kTurnRounding * (1.0 + v.norm()));
        CHECK((to_eigen(q.toRotationMatrix()) - jq.toRotationMatrix()).norm() < kTurnRounding);
        const Quaternion back(q.toRotationMatrix());
        CHECK(find_difference(back, Eigen::Quaterniond(jq.toRotationMatrix())) < kTurnRounding);
        for (const double share : {0.0, 0.2, 0.5, 1.0}) {
            CHECK(find_difference(q.slerp(share, p), jq.slerp(share, jp)) < 10.0 * kTurnRounding);
        }
        Quaternion product = q;
        product *= p;
        CHECK(product == q * p);
        CHECK(q.isApprox(p, 0.8) == jq.isApprox(jp, 0.8));
        CHECK(q.cast<float>().coeffs() == q.coeffs().cast<float>());
    });
}

TEST_CASE("quaternion: it turns as its matrix does, and products turn one after the other") {
    for_each_draw(2, [](const Quaternion& q, const Quaternion& p, const Vector3& v) {
        const double rounding = 4.0 * kTurnRounding * (1.0 + v.norm());
        CHECK((q * v - q.toRotationMatrix() * v).norm() < rounding);
        CHECK((q * p * v - q * (p * v)).norm() < rounding);
        CHECK(((q * p).toRotationMatrix() - q.toRotationMatrix() * p.toRotationMatrix()).norm() <
              4.0 * kTurnRounding);
        CHECK((q.inverse() * (q * v) - v).norm() < rounding);
        CHECK(std::abs((q * v).norm() - v.norm()) < rounding);
        CHECK(std::abs(q.toRotationMatrix().determinant() - 1.0) < kTurnRounding);
        CHECK(find_turn_difference(Quaternion(q.toRotationMatrix()), q) < kTurnRounding);
    });
    // x, y or z is the largest number.
    for (int axis = 0; axis < 3; ++axis) {
        for (const double angle : {0.9 * kPi, kPi, -0.95 * kPi}) {
            const Quaternion q(AngleAxis(angle, Vector3::Unit(axis)));
            CHECK(find_turn_difference(Quaternion(q.toRotationMatrix()), q) < kTurnRounding);
        }
    }
    CHECK(Quaternion::Identity() * Vector3(1.0, 2.0, 3.0) == Vector3(1.0, 2.0, 3.0));
    CHECK(Quaternion(0.5, 0.5, 0.5, 0.5) * Vector3::UnitX() == Vector3::UnitY());
    CHECK(Quaternion(0.5, 0.5, 0.5, 0.5).toRotationMatrix() * Vector3::UnitX() == Vector3::UnitY());
}

TEST_CASE("quaternion: w, x, y, z stand where they are read, and can be written there") {
    Quaternion q(1.0, 2.0, 3.0, 4.0);
    CHECK(q.coeffs() == Vector4(2.0, 3.0, 4.0, 1.0));
    CHECK(Quaternion(Vector4(2.0, 3.0, 4.0, 1.0)) == q);
    CHECK(q.squaredNorm() == 30.0);
    CHECK(q.norm() == std::sqrt(30.0));
    q.vec() = Vector3(7.0, 8.0, 9.0);
    q.w() = 6.0;
    q.x() *= 2.0;
    CHECK(q.coeffs() == Vector4(14.0, 8.0, 9.0, 6.0));
    CHECK(std::as_const(q).vec() == Vector3(14.0, 8.0, 9.0));
    CHECK(q.setIdentity() == Quaternion(1.0, 0.0, 0.0, 0.0));
    CHECK_FALSE(q == Quaternion(1.0, 0.0, 0.0, 1.0e-9));
    static_assert(sizeof(Quaternion) == 4 * sizeof(double));
}

TEST_CASE("quaternion: an angle about an axis and back, the shorter way") {
    Random random(3);
    for (int round = 0; round < kRounds; ++round) {
        const double angle = 2.0 * kPi * random.uniform();
        const Vector3 axis = random.direction();
        const AngleAxis turn(angle, axis);
        const Eigen::AngleAxisd judge(angle, to_eigen(axis));
        CHECK(find_difference(Quaternion(turn), Eigen::Quaterniond(judge)) < kTurnRounding);
        CHECK((to_eigen(turn.toRotationMatrix()) - judge.toRotationMatrix()).norm() <
              kTurnRounding);
        CHECK((to_eigen(turn * axis) - to_eigen(axis)).norm() < kTurnRounding);
        const AngleAxis back{Quaternion(turn)};
        CHECK(back.angle() >= 0.0);
        CHECK(back.angle() <= kPi);
        CHECK(find_turn_difference(Quaternion(back), Quaternion(turn)) < kTurnRounding);
        const AngleAxis other(random.uniform(), random.direction());
        const Quaternion q = draw(random);
        CHECK(turn * other == Quaternion(turn) * Quaternion(other));
        CHECK(turn * q == Quaternion(turn) * q);
        CHECK(q * turn == q * Quaternion(turn));
    }
    CHECK(AngleAxis(Quaternion::Identity()).angle() == 0.0);
    CHECK(AngleAxis(Quaternion::Identity()).axis() == Vector3::UnitX());
    CHECK(AngleAxis(Quaternion(-1.0, 0.0, 0.0, 0.0)).angle() == 0.0);
    CHECK(AngleAxis(Quaternion(0.0, 0.0, -1.0, 0.0)).angle() == Approx(kPi));
    CHECK(AngleAxis(Quaternion(0.0, 0.0, -1.0, 0.0)).axis() == -Vector3::UnitY());
}

TEST_CASE("quaternion: it is the exponential of its logarithm, and of an angle along an axis") {
    Random random(4);
    for (int round = 0; round < kRounds; ++round) {
        const Quaternion q = draw(random);
        CHECK(find_turn_difference(compute_exp(compute_log(q)), q) < kTurnRounding);
        const double angle = 3.0 * random.uniform();
        const Vector3 axis = random.direction();
        CHECK(find_turn_difference(compute_exp(angle * axis), Quaternion(AngleAxis(angle, axis))) <
              kTurnRounding);
        CHECK(std::abs(compute_log(q).norm() - q.angularDistance(Quaternion::Identity())) <
              4.0 * kTurnRounding);
    }
}

TEST_CASE("quaternion: slerp begins here, ends there, and goes the shorter way at an even rate") {
    for_each_draw(5, [](const Quaternion& q, const Quaternion& p, const Vector3&) {
        const double whole = q.angularDistance(p);
        CHECK(find_turn_difference(q.slerp(0.0, p), q) < kTurnRounding);
        CHECK(find_turn_difference(q.slerp(1.0, p), p) < kTurnRounding);
        for (const double share : {0.1, 0.5, 0.8}) {
            const Quaternion between = q.slerp(share, p);
            // Near half a turn an angle is known to the root of rounding's share alone.
            CHECK(std::abs(between.norm() - 1.0) < 1.0e-12);
            CHECK(q.angularDistance(between) == Approx(share * whole).margin(1.0e-12));
            CHECK(between.angularDistance(p) == Approx((1.0 - share) * whole).margin(1.0e-12));
            // q and -q are one turn: the way is the same.
            const Quaternion opposite(-p.coeffs());
            CHECK(find_turn_difference(q.slerp(share, opposite), between) < 1.0e-12);
        }
    });
    // From what is the same, and what is nearly so.
    const Quaternion q(AngleAxis(0.3, Vector3::UnitY()));
    CHECK(find_turn_difference(q.slerp(0.4, q), q) < kTurnRounding);
    const Quaternion near(AngleAxis(0.3 + 1.0e-9, Vector3::UnitY()));
    CHECK(q.slerp(0.25, near).angularDistance(q) == Approx(0.25e-9).epsilon(1.0e-5));
}

TEST_CASE("quaternion: the shortest turn between directions; what is none stays none") {
    Random random(6);
    for (int round = 0; round < kRounds; ++round) {
        const Vector3 a = random.vector();
        const Vector3 b = random.vector();
        const Quaternion q = Quaternion::FromTwoVectors(a, b);
        const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
        // A turn by nearly half is known to rounding over what is left of it.
        const double rounding = 4.0 * kTurnRounding / std::max(kPi - angle, 1.0e-3);
        CHECK((q * a.normalized() - b.normalized()).norm() < rounding);
        CHECK(AngleAxis(q).angle() == Approx(angle).margin(rounding));
        for (const Vector3& back : {Vector3(-a), Vector3(-2.0 * a)}) {
            const Quaternion half = Quaternion::FromTwoVectors(a, back);
            CHECK((half * a - -a).norm() < kTurnRounding * (1.0 + 10.0 * a.norm()));
            CHECK(std::abs(half.norm() - 1.0) < kTurnRounding);
        }
        CHECK(find_turn_difference(Quaternion::FromTwoVectors(a, 3.0 * a), Quaternion::Identity()) <
              kTurnRounding);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const Vector3 a = Vector3::Unit(axis);
        CHECK(Quaternion::FromTwoVectors(a, -a) * a == -a);
        CHECK(Quaternion::FromTwoVectors(a, a) == Quaternion::Identity());
    }
    const Quaternion zero(0.0, 0.0, 0.0, 0.0);
    CHECK(zero.normalized() == zero);
    CHECK(zero.inverse() == zero);
    Quaternion spoilt(1.0, 0.0, std::nan(""), 0.0);
    CHECK_FALSE(spoilt.normalized().coeffs().allFinite());
    spoilt.normalize();
    CHECK_FALSE(spoilt.coeffs().allFinite());
    CHECK_FALSE((Quaternion::Identity() * spoilt).coeffs().allFinite());
    const Quaternion twice(2.0, 0.0, 0.0, 2.0);
    CHECK((twice * twice.inverse()).isApprox(Quaternion::Identity()));
    CHECK(twice.normalized().norm() == Approx(1.0).epsilon(kTurnRounding));
}
