#include "haptics/geometry/shape.h"
#include "haptics/levels/hull_pair.h"
#include "haptics/levels/level_pairs.h"
#include "haptics/math/rotation.h"
#include "tests/support/gear.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <rapidcheck.h>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kRounding_m = 1.0e-8;  // of the search, in hulls a metre large

std::vector<Vector3> make_box_corners(const Vector3& half) {
    std::vector<Vector3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? half.x() : -half.x(),
                             (i & 2) != 0 ? half.y() : -half.y(),
                             (i & 4) != 0 ? half.z() : -half.z());
    }
    return corners;
}

HullPair find_pair(const std::vector<Vector3>& first, const std::vector<Vector3>& second,
                   const Pose& X) {
    return find_hull_pair({.points = first}, {.points = second}, X.orientation.toRotationMatrix(),
                          X.position, Vector3::UnitX());
}

Vector3 draw_vector(double size) {
    const auto number = [size] { return 1.0e-4 * size * *rc::gen::inRange(-10000, 10001); };
    return {number(), number(), number()};
}

std::vector<Vector3> draw_points(int n) {
    std::vector<Vector3> points;
    for (int i = 0; i < n; ++i) {
        points.push_back(draw_vector(1.0));
    }
    return points;
}

constexpr double kNear_m = 1.0e-4;
constexpr double kHalf_m = 0.05;
constexpr double kThrough_m = 1.0e-3;

// A square that looks along `along` x `across`, and beside its edge at +`across` a strip that goes down behind it: so a
// surface that goes on round a corner there.
std::shared_ptr<const ContactLevels> make_square(const Vector3& along, const Vector3& across) {
    const auto at = [&](double u, double v, double down) -> Vector3 {
        return kHalf_m * (u * along + v * across - down * along.cross(across));
    };
    const TriangleMesh mesh =
        TriangleMesh::build({at(-1.0, -1.0, 0.0), at(1.0, -1.0, 0.0), at(1.0, 1.0, 0.0),
                             at(-1.0, 1.0, 0.0), at(1.0, 1.0, 0.2), at(-1.0, 1.0, 0.2)},
                            {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}})
            .value();
    return ContactLevels::create(mesh, {.within_m = kNear_m}).value();
}

}  // namespace

TEST_CASE("hull pair: boxes apart as corner, edge and face say; flat hulls, segments, points too") {
    const std::vector<Vector3> box = make_box_corners({0.5, 0.5, 0.5});
    const HullPair face = find_pair(box, box, Pose::at({2.0, 0.3, 0.1}));
    CHECK(face.gap_m == Approx(1.0).epsilon(1e-9));
    CHECK((face.normal - Vector3::UnitX()).norm() < 1.0e-9);
    const HullPair edge = find_pair(box, box, Pose::at({2.0, 2.0, 0.1}));
    CHECK(edge.gap_m == Approx(std::sqrt(2.0)).epsilon(1e-9));
    const HullPair corner = find_pair(box, box, Pose::at({2.0, 2.0, -2.0}));
    CHECK(corner.gap_m == Approx(std::sqrt(3.0)).epsilon(1e-9));
    CHECK((corner.on_first - Vector3(0.5, 0.5, -0.5)).norm() < kRounding_m);
    CHECK((corner.on_second - Vector3(1.5, 1.5, -1.5)).norm() < kRounding_m);
    const HullPair inside = find_pair(box, box, Pose::at({0.9, 0.0, 0.0}));
    CHECK(inside.gap_m == 0.0);
    const std::vector<Vector3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<Vector3> point{Vector3::Zero()};
    const std::vector<Vector3> segment{{-1, 0, 0}, {1, 0, 0}};
    CHECK(find_pair(square, square, Pose::at({0.2, 0.3, 0.25})).gap_m == Approx(0.25));
    CHECK(find_pair(square, point, Pose::at({0.5, 0.5, -2.0})).gap_m == Approx(2.0));
    CHECK(find_pair(square, segment, Pose::at({0.5, 3.0, 0.0})).gap_m == Approx(2.0));
    CHECK(find_pair(point, point, Pose::at({0.0, 0.0, 0.0})).gap_m == 0.0);
    CHECK(find_pair(square, square, Pose::at({2.0, 0.0, 0.0})).gap_m == Approx(1.0));
}

TEST_CASE("hull pair: bounds hold the distance between, and the points are so far apart") {
    CHECK(rc::check([] {
        const std::vector<Vector3> first = draw_points(12);
        const std::vector<Vector3> second = draw_points(12);
        const Pose X{draw_vector(3.0), compute_exp(draw_vector(3.0))};
        const HullPair pair = find_pair(first, second, X);
        RC_ASSERT(pair.least_m <= pair.gap_m);
        RC_ASSERT(pair.gap_m - pair.least_m <= kRounding_m);
        if (pair.gap_m > 0.0) {
            RC_ASSERT(std::abs((pair.on_second - pair.on_first).norm() - pair.gap_m) < kRounding_m);
            // Nothing of either lies between the two planes across the way.
            for (const Vector3& point : first) {
                RC_ASSERT(pair.normal.dot(point - pair.on_first) < 1.0e-6);
            }
            for (const Vector3& point : second) {
                RC_ASSERT(pair.normal.dot(X * point - pair.on_second) > -1.0e-6);
            }
        }
    }));
}

TEST_CASE(
    "hull pair: asked for a bound it ends with a true one; a point inside is at no distance") {
    CHECK(rc::check([] {
        const std::vector<Vector3> first = draw_points(8);
        const std::vector<Vector3> second = draw_points(8);
        const Pose X{draw_vector(4.0), compute_exp(draw_vector(3.0))};
        const Matrix3 turn = X.orientation.toRotationMatrix();
        const double exact_m = find_pair(first, second, X).gap_m;
        const HullPair early = find_hull_pair({.points = first}, {.points = second}, turn,
                                              X.position, Vector3::UnitY(), 0.3);
        RC_ASSERT(early.least_m <= exact_m + kRounding_m);
        RC_ASSERT(early.is_far == (exact_m > 0.3) || std::abs(exact_m - 0.3) < kRounding_m);
    }));
    const std::vector<Vector3> box = make_box_corners({0.5, 1.0, 2.0});
    CHECK(find_nearest_in_hull({.points = box}, {0.1, 0.2, 0.3}).gap_m == 0.0);
    const HullPair outside = find_nearest_in_hull({.points = box}, {0.1, 3.0, 0.3});
    CHECK(outside.gap_m == Approx(2.0));
    CHECK((outside.on_first - Vector3(0.1, 1.0, 0.3)).norm() < kRounding_m);
    CHECK(find_nearest_in_hull({.points = box}, box.front()).gap_m < kRounding_m);
}

// A long beam's side as it is rounded: corners in a plane but for a billionth, rows of them almost on a line.
TEST_CASE("hull pair: corners of long, flat hulls are at no distance from them") {
    Random random(11);
    for (int round = 0; round < 300; ++round) {
        std::vector<Vector3> hull;
        const double wide_m = std::pow(10.0, -1.0 - 3.0 * std::abs(random.uniform()));
        for (int i = 0; i < 40; ++i) {
            const double x = 0.5 * random.uniform();
            // On a long arc, or anywhere below it.
            const double z = i % 2 == 0 ? wide_m * (1.0 - 4.0 * x * x) : wide_m * random.uniform();
            hull.emplace_back(x, 1.0e-9 * random.uniform(), z);
        }
        for (const Vector3& corner : hull) {
            REQUIRE(find_nearest_in_hull({.points = hull}, corner).gap_m < kRounding_m);
        }
        // As far as it is above them, asked from anywhere.
        const Vector3 above = hull[0] + Vector3(0.0, 0.01, 0.0);
        CHECK(find_nearest_in_hull({.points = hull}, above).gap_m ==
              Approx(0.01).margin(kRounding_m));
    }
}

TEST_CASE("hull pair: where hulls meet, four points of their difference hold the origin") {
    const std::vector<Vector3> box = make_box_corners({0.5, 0.3, 0.4});
    Random random(7);
    int n_held = 0;
    for (int i = 0; i < 2000; ++i) {
        const Pose X{0.7 * random.in_cube(), compute_exp(2.0 * random.in_cube())};
        const HullPair found = find_pair(box, box, X);
        if (!found.is_held) {
            continue;
        }
        ++n_held;
        REQUIRE(found.gap_m == 0.0);
        Matrix3 edges;
        for (std::size_t k = 0; k < 3; ++k) {
            edges.col(static_cast<Index>(k)) = found.held[k + 1] - found.held[0];
        }
        const Vector3 shares = edges.inverse() * -found.held[0];
        REQUIRE(shares.minCoeff() > -1.0e-9);
        REQUIRE(shares.sum() < 1.0 + 1.0e-9);
        // Each is a corner of the one less a corner of the other.
        for (const Vector3& way : found.held) {
            double nearest_m = 1.0;
            for (const Vector3& a : box) {
                for (const Vector3& b : box) {
                    nearest_m = std::min(nearest_m, (X * b - a - way).norm());
                }
            }
            REQUIRE(nearest_m < 1.0e-12);
        }
    }
    CHECK(n_held > 500);
    CHECK_FALSE(find_pair(box, box, Pose::at({2.0, 0.0, 0.0})).is_held);
}

// Which way out two pieces are told, and when no contact is theirs.

TEST_CASE("pair contacts: a way out is told that both look along, up to four times the shortest") {
    // The object lies and looks up, the tool stands on it, leaning back a little, and looks along x; its lower edge is 1 mm through, near the
    // object's border at -x.
    const auto lying = make_square(Vector3::UnitZ(), Vector3::UnitX());
    const auto standing = make_square(-Vector3::UnitZ(), Vector3::UnitY());
    REQUIRE(lying->n_pieces() == 2);
    REQUIRE(standing->n_pieces() == 2);
    const auto pairs = LevelPairs::create(lying, standing).value();
    constexpr double kLean_rad = 0.05;
    const auto is_told_at = [&](double from_border_m) {
        pairs->clear();
        const Vector3 lower_edge(-kHalf_m + from_border_m, -kThrough_m, 0.0);
        const Quaternion turn = compute_exp(Vector3(0.0, 0.0, kLean_rad));
        (void)pairs->find({lower_edge + turn * Vector3(0.0, kHalf_m, 0.0), turn}, kNear_m);
        return std::ranges::any_of(pairs->contacts(), [](const LevelContact& contact) {
            return contact.normal_O.x() < -0.5 && contact.normal_O.y() > 0.5;
        });
    };
    // Between both looks it is some (way to the border + 1 mm) / sqrt 2.
    CHECK(is_told_at(1.5 * kThrough_m));
    CHECK(is_told_at(4.0 * kThrough_m));
    CHECK_FALSE(is_told_at(8.0 * kThrough_m));
    CHECK_FALSE(is_told_at(20.0 * kThrough_m));
}

TEST_CASE(
    "pair contacts: what stands in a hole, apart from its wall, is inside of nothing that reaches "
    "there from the body's outer side") {
    const auto make_levels = [](const TriangleMesh& mesh) {
        return ContactLevels::create(mesh, {.within_m = 1.0e-3}).value();
    };
    // 0.25 to 0.3 mm between them where they are nearest.
    const auto bush = make_levels(make_bush(0.02, 0.0115, 0.03, 35).value());
    const auto peg = make_levels(make_peg(0.01, 0.06, 72).value());
    constexpr double kOff_m = 1.2e-3;
    const double tolerance_m = GENERATE(0.0, 2.0e-4, 8.0e-4);
    const bool is_peg_tool = GENERATE(true, false);
    CAPTURE(tolerance_m, is_peg_tool);
    const auto pairs = LevelPairs::create(is_peg_tool ? bush : peg, is_peg_tool ? peg : bush,
                                          {.tolerance_m = tolerance_m})
                           .value();
    for (int i = 0; i < 50; ++i) {
        const double round = 0.02 * std::numbers::pi * i;
        (void)pairs->find(Pose::at(kOff_m * Vector3(std::cos(round), std::sin(round), 0.0)),
                          1.0e-3);
        bool are_apart = !pairs->contacts().empty();
        for (const LevelContact& contact : pairs->contacts()) {
            are_apart = are_apart && contact.depth_m < contact.error_m;
        }
        INFO("direction " << i);
        CHECK(are_apart);
    }
}
