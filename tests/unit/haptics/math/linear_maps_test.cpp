#include "haptics/math/affine.h"
#include "haptics/math/length.h"
#include "haptics/math/plain_eigen.h"
#include "haptics/math/split_mix.h"
#include "haptics/math/to_eigen.h"
#include "haptics/math/turned_slopes.h"
#include "haptics/math/wrench_jacobian.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>
#include <random>

using namespace fulcrum;

namespace {

constexpr double kRounding = 1.0e-13;  // some hundred operations on numbers of about 1

double find_difference(const Affine& ours, const Eigen::Affine3d& judge) {
    return (to_eigen(ours.matrix()) - judge.matrix()).cwiseAbs().maxCoeff();
}

struct Added {
    Wrench wrench{};
    WrenchJacobian slopes{};
};

double find_largest_difference(const Added& a, const Added& b) {
    return std::max(
        {(a.wrench.force - b.wrench.force).norm(), (a.wrench.torque - b.wrench.torque).norm(),
         (a.slopes.pose - b.slopes.pose).norm(), (a.slopes.velocity - b.slopes.velocity).norm()});
}

// As a force of which all three axes are told.
void add_at_length(const Vector3& arm, const Vector3& spin, const Vector3& normal,
                   const NormalPush& push, Added& added) {
    const Matrix3 along = normal * normal.transpose();
    add_point_force(
        arm, spin,
        {push.push_N * normal, -push.by_depth_N_per_m * along, -push.by_sinking_Ns_per_m * along},
        added.wrench, added.slopes);
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

TEST_CASE(
    "length: Pythagoras, direction of length 1; at either end of double, of nothing and NaN") {
    CHECK(compute_length(Vector3(2.0, 3.0, 6.0)) == 7.0);
    CHECK(compute_length(Vector4(1.0, 1.0, 1.0, 1.0)) == 2.0);
    CHECK(compute_direction(Vector3(0.0, -3.0, 4.0)) == Vector3(0.0, -0.6, 0.8));
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const Vector3 v(any(random), any(random), any(random));
        REQUIRE(compute_length(v) == Approx(std::hypot(v.x(), v.y(), v.z())).epsilon(4e-16));
        REQUIRE((compute_length(v) * compute_direction(v) - v).norm() <= 4e-16 * v.norm());
    }
    const Vector3 v(2.0, 3.0, 6.0);
    for (const double scale : {1e-307, 1e-200, 1e-141, 1e-139, 1e139, 1e141, 1e200, 1e307}) {
        CAPTURE(scale);
        CHECK(compute_length(Vector3(scale * v)) == Approx(7.0 * scale).epsilon(4e-16));
        CHECK((compute_direction(Vector3(scale * v)) - v / 7.0).norm() <= 4e-16);
    }
    // Even the smallest number there is has a direction.
    const double least = std::numeric_limits<double>::denorm_min();
    CHECK(compute_length(Vector3(0.0, least, 0.0)) == least);
    CHECK(compute_direction(Vector3(0.0, -least, 0.0)) == Vector3(0.0, -1.0, 0.0));
    CHECK(compute_length(Vector3(0.0, 0.0, 0.0)) == 0.0);
    CHECK(compute_direction(Vector3(0.0, 0.0, 0.0)) == Vector3(0.0, 0.0, 0.0));
    CHECK(compute_length(Vector3(1.0, -kInfinity, 0.0)) == kInfinity);
    CHECK(compute_direction(Vector3(1.0, -kInfinity, 0.0)) == Vector3(1.0, -kInfinity, 0.0));
    for (int i = 0; i < 3; ++i) {
        Vector3 spoilt(1.0, kInfinity, 0.0);
        spoilt[i] = kNan;
        CHECK(std::isnan(compute_length(spoilt)));
        CHECK_FALSE(compute_direction(spoilt).allFinite());
    }
}

TEST_CASE("length: the same bits wherever the vector lies") {
    // Every place that a double may have in 64 bytes; the largest number last, so that the order of summing counts.
    alignas(64) std::array<std::byte, 64 + sizeof(Vector3)> room{};
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(0.1, 1.0);
    for (int i = 0; i < 2000; ++i) {
        const Vector3 v(any(random), any(random), any(random));
        const double length = compute_length(v);
        const Vector3 direction = compute_direction(v);
        for (std::size_t at = 0; at < 64; at += alignof(Vector3)) {
            const auto* moved = new (&room[at]) Vector3(v);
            REQUIRE(std::bit_cast<std::uint64_t>(compute_length(*moved)) ==
                    std::bit_cast<std::uint64_t>(length));
            REQUIRE(compute_direction(*moved) == direction);
        }
    }
}

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

TEST_CASE(
    "normal push: it adds what a force of any direction adds, and turns nothing at the origin") {
    Random random(11);
    for (int i = 0; i < 200; ++i) {
        const Vector3 arm = random.vector();
        const Vector3 spin = random.vector();
        const Vector3 normal = random.vector().normalized();
        const NormalPush push{random.uniform(), random.uniform(),
                              i % 2 == 0 ? 0.0 : random.uniform()};
        // On top of what stands there already.
        Added short_way;
        short_way.slopes.pose.setConstant(0.25);
        short_way.slopes.velocity.setConstant(-0.5);
        Added long_way = short_way;
        add_normal_push(arm, spin, normal, push, short_way.wrench, short_way.slopes);
        add_at_length(arm, spin, normal, push, long_way);
        CHECK(find_largest_difference(short_way, long_way) < 1.0e-13);
    }
    Added added;
    add_normal_push(Vector3::Zero(), {1.0, 2.0, 3.0}, Vector3::UnitY(), {2.0, 5.0, 0.5},
                    added.wrench, added.slopes);
    Matrix6 by_place = Matrix6::Zero();
    by_place(1, 1) = -5.0;
    CHECK(added.wrench.torque == Vector3(0.0, 0.0, 0.0));
    CHECK(added.slopes.pose == by_place);
    CHECK(added.slopes.velocity == Matrix6(0.1 * by_place));
}

TEST_CASE("split mix: its authors' numbers, any of them without those before, in [0, 1)") {
    // java.util.SplittableRandom and prng.di.unimi.it/splitmix64.c, seed 1234567.
    SplitMix random(1234567);
    for (const std::uint64_t expected :
         {6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U,
          16408922859458223821U}) {
        CHECK(random.draw() == expected);
    }
    random = SplitMix(42);
    for (std::uint64_t n = 1; n <= 1000; ++n) {
        const double chance = random.draw_chance();
        REQUIRE(chance == to_chance(compute_split_mix(42 + n * kSplitMixGamma)));
        REQUIRE(chance >= 0.0);
        REQUIRE(chance < 1.0);
    }
    CHECK(to_chance(~std::uint64_t{0}) < 1.0);
}
