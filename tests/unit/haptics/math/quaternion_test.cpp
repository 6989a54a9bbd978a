#include "haptics/math/quaternion.h"

#include "haptics/math/plain_eigen.h"
#include "haptics/math/rotation.h"
#include "haptics/math/to_eigen.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kRounding = 4.0e-15;  // some ten operations on numbers of about 1
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

TEST_CASE("quaternion: what it computes is what another library does") {
    for_each_draw(1, [](const Quaternion& q, const Quaternion& p, const Vector3& v) {
        const Eigen::Quaterniond jq = to_judge(q);
        const Eigen::Quaterniond jp = to_judge(p);
        CHECK(find_difference(q * p, jq * jp) < kRounding);
        CHECK(find_difference(q.conjugate(), jq.conjugate()) == 0.0);
        CHECK(find_difference(q.inverse(), jq.inverse()) < kRounding);
        CHECK(std::abs(q.dot(p) - jq.dot(jp)) < kRounding);
        CHECK(std::abs(q.angularDistance(p) - jq.angularDistance(jp)) < 4.0 * kRounding);
        CHECK((to_eigen(q * v) - jq * to_eigen(v)).norm() < 4.0 * kRounding * (1.0 + v.norm()));
        CHECK((to_eigen(q.toRotationMatrix()) - jq.toRotationMatrix()).norm() < kRounding);
        const Quaternion back(q.toRotationMatrix());
        CHECK(find_difference(back, Eigen::Quaterniond(jq.toRotationMatrix())) < kRounding);
        for (const double share : {0.0, 0.2, 0.5, 1.0}) {
            CHECK(find_difference(q.slerp(share, p), jq.slerp(share, jp)) < 10.0 * kRounding);
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
        const double rounding = 4.0 * kRounding * (1.0 + v.norm());
        CHECK((q * v - q.toRotationMatrix() * v).norm() < rounding);
        CHECK((q * p * v - q * (p * v)).norm() < rounding);
        CHECK(((q * p).toRotationMatrix() - q.toRotationMatrix() * p.toRotationMatrix()).norm() <
              4.0 * kRounding);
        CHECK((q.inverse() * (q * v) - v).norm() < rounding);
        CHECK(std::abs((q * v).norm() - v.norm()) < rounding);
        CHECK(std::abs(q.toRotationMatrix().determinant() - 1.0) < kRounding);
        CHECK(find_turn_difference(Quaternion(q.toRotationMatrix()), q) < kRounding);
    });
    // x, y or z is the largest number.
    for (int axis = 0; axis < 3; ++axis) {
        for (const double angle : {0.9 * kPi, kPi, -0.95 * kPi}) {
            const Quaternion q(AngleAxis(angle, Vector3::Unit(axis)));
            CHECK(find_turn_difference(Quaternion(q.toRotationMatrix()), q) < kRounding);
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
        CHECK(find_difference(Quaternion(turn), Eigen::Quaterniond(judge)) < kRounding);
        CHECK((to_eigen(turn.toRotationMatrix()) - judge.toRotationMatrix()).norm() < kRounding);
        CHECK((to_eigen(turn * axis) - to_eigen(axis)).norm() < kRounding);
        const AngleAxis back{Quaternion(turn)};
        CHECK(back.angle() >= 0.0);
        CHECK(back.angle() <= kPi);
        CHECK(find_turn_difference(Quaternion(back), Quaternion(turn)) < kRounding);
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
        CHECK(find_turn_difference(compute_exp(compute_log(q)), q) < kRounding);
        const double angle = 3.0 * random.uniform();
        const Vector3 axis = random.direction();
        CHECK(find_turn_difference(compute_exp(angle * axis), Quaternion(AngleAxis(angle, axis))) <
              kRounding);
        CHECK(std::abs(compute_log(q).norm() - q.angularDistance(Quaternion::Identity())) <
              4.0 * kRounding);
    }
}

TEST_CASE("quaternion: slerp begins here, ends there, and goes the shorter way at an even rate") {
    for_each_draw(5, [](const Quaternion& q, const Quaternion& p, const Vector3&) {
        const double whole = q.angularDistance(p);
        CHECK(find_turn_difference(q.slerp(0.0, p), q) < kRounding);
        CHECK(find_turn_difference(q.slerp(1.0, p), p) < kRounding);
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
    CHECK(find_turn_difference(q.slerp(0.4, q), q) < kRounding);
    const Quaternion near(AngleAxis(0.3 + 1.0e-9, Vector3::UnitY()));
    CHECK(q.slerp(0.25, near).angularDistance(q) == Approx(0.25e-9).epsilon(1.0e-5));
}

TEST_CASE("quaternion: the shortest turn from one direction to another, half a turn as well") {
    Random random(6);
    for (int round = 0; round < kRounds; ++round) {
        const Vector3 a = random.vector();
        const Vector3 b = random.vector();
        const Quaternion q = Quaternion::FromTwoVectors(a, b);
        const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
        // A turn by nearly half is known to rounding over what is left of it.
        const double rounding = 4.0 * kRounding / std::max(kPi - angle, 1.0e-3);
        CHECK((q * a.normalized() - b.normalized()).norm() < rounding);
        CHECK(AngleAxis(q).angle() == Approx(angle).margin(rounding));
        for (const Vector3& back : {Vector3(-a), Vector3(-2.0 * a)}) {
            const Quaternion half = Quaternion::FromTwoVectors(a, back);
            CHECK((half * a - -a).norm() < kRounding * (1.0 + 10.0 * a.norm()));
            CHECK(std::abs(half.norm() - 1.0) < kRounding);
        }
        CHECK(find_turn_difference(Quaternion::FromTwoVectors(a, 3.0 * a), Quaternion::Identity()) <
              kRounding);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const Vector3 a = Vector3::Unit(axis);
        CHECK(Quaternion::FromTwoVectors(a, -a) * a == -a);
        CHECK(Quaternion::FromTwoVectors(a, a) == Quaternion::Identity());
    }
}

TEST_CASE("quaternion: nothing has no direction and no inverse, and what is none stays none") {
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
    CHECK(twice.normalized().norm() == Approx(1.0).epsilon(kRounding));
}

}  // namespace fulcrum
