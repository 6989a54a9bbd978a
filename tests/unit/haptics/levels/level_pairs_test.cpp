#include "haptics/levels/level_pairs.h"

#include "haptics/continuous/nearest_features.h"
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/level_parts.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <rapidcheck.h>
#include <vector>

using namespace fulcrum;
using test::find_push;
using test::kRounding_m;
using test::Levels;
using test::make_lumps;
using test::make_pairs;

namespace {

constexpr double kWithin_m = 0.05;
constexpr double kNeighbour_m = 2.0 * kRounding_m;  // where a neighbour's patch tells of a border

Levels make_levels(const TriangleMesh& mesh, double within_m = kWithin_m) {
    return test::make_levels(mesh, within_m);
}

double find_gap_of_spheres(const Triangle& a, const Triangle& b) {
    const auto radius_m = [](const Triangle& t) {
        return std::max((t[1] - t[0]).norm(), (t[2] - t[0]).norm());
    };
    return (a[0] - b[0]).norm() - radius_m(a) - radius_m(b);
}

// Every triangle with every other.
double find_distance(const TriangleMesh& object, const TriangleMesh& tool, const Pose& X_OT) {
    std::vector<Vector3> moved;
    for (const Vector3& vertex : tool.vertices_B()) {
        moved.push_back(X_OT * vertex);
    }
    const auto at = [](const std::vector<Vector3>& places, const TriangleCorners& t) {
        return Triangle{places[static_cast<std::size_t>(t[0])],
                        places[static_cast<std::size_t>(t[1])],
                        places[static_cast<std::size_t>(t[2])]};
    };
    double least_m = std::numeric_limits<double>::infinity();
    for (const TriangleCorners& a : object.triangles()) {
        for (const TriangleCorners& b : tool.triangles()) {
            const Triangle first = at(object.vertices_B(), a);
            const Triangle second = at(moved, b);
            if (find_gap_of_spheres(first, second) > least_m) {
                continue;
            }
            least_m = do_cross(first, second)
                          ? 0.0
                          : std::min(least_m, find_nearest_features(first, second).distance_m);
        }
    }
    return least_m;
}

Vector3 draw_vector(double size) {
    const auto number = [size] { return 1.0e-4 * size * *rc::gen::inRange(-10000, 10001); };
    return {number(), number(), number()};
}

double find_deepest_m(const LevelPairs& pairs) {
    double most_m = -1.0;
    for (const LevelContact& contact : pairs.contacts()) {
        most_m = std::max(most_m, contact.depth_m);
    }
    return most_m;
}

// Bodies of 0.1 m some way apart.
Pose draw_pose_apart(double from_m, double to_m) {
    const Vector3 way = (draw_vector(1.0) + Vector3(0.0, 0.0, 1.0e-3)).normalized();
    const double far_m = from_m + (to_m - from_m) * 1.0e-4 * *rc::gen::inRange(0, 10001);
    return {far_m * way, compute_exp(draw_vector(3.0))};
}

}  // namespace

TEST_CASE("level pairs: two balls are apart, or in each other, as two balls are") {
    constexpr double kRadius_m = 0.1;
    const Levels ball = make_levels(make_sphere(kRadius_m, 24).value(), 5.0e-3);
    const auto pairs = make_pairs(ball, ball);
    const double facets_m = 2.0 * (1.0 - std::cos(0.5 / 24)) * kRadius_m + 1.0e-4;
    for (const double gap_m : {4.0e-3, 1.0e-3, -1.0e-3, -5.0e-3}) {
        const Vector3 way = Vector3(0.3, 0.8, -0.4).normalized();
        pairs->find({(2.0 * kRadius_m + gap_m) * way, compute_exp(Vector3(0.3, -0.2, 1.0))},
                    5.0e-3);
        REQUIRE(pairs->contacts().size() >= 1);
        const LevelContact& contact =
            *std::ranges::max_element(pairs->contacts(), {}, &LevelContact::depth_m);
        CHECK(std::abs(contact.depth_m + gap_m) < facets_m);
        CHECK(contact.normal_O.dot(way) > 0.99);
        CHECK((contact.point_O - (kRadius_m + gap_m) * way).norm() < 0.012);
    }
    pairs->find(Pose::at({0.21, 0.0, 0.0}), 5.0e-3);
    CHECK(pairs->contacts().empty());
}

TEST_CASE("level pairs: a box that stands on a plate touches with its corners") {
    const Levels plate = make_levels(make_box({0.3, 0.02, 0.3}).value(), 1.0e-3);
    const Levels box = make_levels(make_box({0.04, 0.04, 0.04}).value(), 1.0e-3);
    const auto pairs = make_pairs(plate, box);
    for (const double gap_m : {0.5e-3, 0.1e-3, -0.2e-3}) {
        for (const double tilt : {0.0, 1.0e-3}) {
            pairs->find({{0.01, 0.03 + gap_m, 0.02}, compute_exp(Vector3(tilt, 0.0, 0.0))}, 1.0e-3);
            Vector3 least = Vector3::Constant(1.0);
            Vector3 most = Vector3::Constant(-1.0);
            for (const LevelContact& contact : pairs->contacts()) {
                CHECK(contact.normal_O.y() > 0.999);
                CHECK(std::abs(contact.depth_m + gap_m) < 2.1e-5 + 1.0e-9);
                CHECK(std::abs(contact.point_O.y() - 0.01 + contact.depth_m) <
                      (gap_m > 0.0 ? 1.0e-6 : 4.1e-5));
                least = least.cwiseMin(contact.point_O);
                most = most.cwiseMax(contact.point_O);
            }
            // All four corners, so a torque is held.
            CHECK(pairs->contacts().size() >= 4);
            CHECK(most.x() - least.x() > 0.039);
            CHECK(most.z() - least.z() > 0.039);
        }
    }
}

TEST_CASE("level pairs: without a tolerance the distance is that of all triangles") {
    const std::vector<TriangleMesh> meshes{make_bumpy_sphere(0.05, 4, 0.2, 30.0).value(),
                                           make_torus(0.05, 0.015, 14, 9).value(),
                                           make_box({0.08, 0.03, 0.05}).value()};
    std::vector<Levels> levels;
    for (const TriangleMesh& mesh : meshes) {
        levels.push_back(make_levels(mesh));
    }
    int n_near = 0;
    CHECK(rc::check([&] {
        const auto i = static_cast<std::size_t>(*rc::gen::inRange(0, 3));
        const auto k = static_cast<std::size_t>(*rc::gen::inRange(0, 3));
        const Pose X_OT = draw_pose_apart(0.07, 0.14);
        const double exact_m = find_distance(meshes[i], meshes[k], X_OT);
        const auto pairs = make_pairs(levels[i], levels[k]);
        const LevelAnswer answer = pairs->find(X_OT, kWithin_m);
        RC_ASSERT(!answer.is_cut);
        if (exact_m > kWithin_m + kRounding_m) {
            RC_ASSERT(pairs->contacts().empty());
        } else if (exact_m > 0.0) {
            ++n_near;
            RC_ASSERT(!pairs->contacts().empty());
            RC_ASSERT(std::abs(answer.nearest_m - exact_m) < kRounding_m);
            double least_m = kWithin_m;
            for (const LevelContact& contact : pairs->contacts()) {
                least_m = std::min(least_m, std::abs(contact.depth_m));
            }
            RC_ASSERT(std::abs(least_m - exact_m) < kRounding_m);
        }
    }));
    CHECK(n_near > 5);
}

TEST_CASE(
    "level pairs: with a tolerance what is told is too near by no more than it says, and never too "
    "far") {
    const TriangleMesh mesh = make_bumpy_sphere(0.05, 6, 0.06, 60.0).value();
    const Levels levels = make_levels(mesh);
    int n_near = 0;
    int n_coarser = 0;
    CHECK(rc::check([&] {
        const double tolerance_m = 1.0e-5 * *rc::gen::inRange(1, 3000);
        const auto pairs = make_pairs(levels, levels, {.tolerance_m = tolerance_m});
        const Pose X_OT = draw_pose_apart(0.105, 0.14);
        const double exact_m = find_distance(mesh, mesh, X_OT);
        const LevelAnswer answer = pairs->find(X_OT, kWithin_m);
        RC_ASSERT(answer.error_m <= tolerance_m);
        RC_ASSERT(answer.n_coarser + answer.n_left == 0);
        double most_m = 0.0;
        for (const LevelContact& contact : pairs->contacts()) {
            RC_ASSERT(contact.error_m <= tolerance_m);
            most_m = std::max(most_m, contact.error_m);
        }
        RC_ASSERT(answer.error_m == most_m);
        if (exact_m > kWithin_m + tolerance_m + kRounding_m) {
            RC_ASSERT(pairs->contacts().empty());
        } else if (exact_m < kWithin_m - kRounding_m) {
            ++n_near;
            n_coarser += answer.error_m > 0.0 ? 1 : 0;
            RC_ASSERT(!pairs->contacts().empty());
            RC_ASSERT(answer.nearest_m < exact_m + kNeighbour_m);
            RC_ASSERT(answer.nearest_m > exact_m - answer.error_m - kRounding_m);
        }
    }));
    CHECK(n_near > 5);
    CHECK(n_coarser > 2);
}

TEST_CASE("level pairs: the source's condition alone takes patches that stand out by more") {
    constexpr double kNear_m = 5.0e-3;
    constexpr double kTolerance_m = 2.0e-3;
    const Levels levels = make_lumps(kNear_m);
    const Pose X_OT = test::kLumpsApart;
    const auto exact = make_pairs(levels, levels);
    const double nearest_m = exact->find(X_OT, kNear_m).nearest_m;
    const auto ours = make_pairs(levels, levels, {.tolerance_m = kTolerance_m});
    const auto theirs =
        make_pairs(levels, levels, {.tolerance_m = kTolerance_m, .is_as_source = true});
    const LevelAnswer careful = ours->find(X_OT, kNear_m);
    const LevelAnswer as_source = theirs->find(X_OT, kNear_m);
    CHECK(careful.error_m <= kTolerance_m);
    CHECK(as_source.error_m > kTolerance_m);
    CHECK(as_source.n_patches < careful.n_patches);
    CHECK(careful.nearest_m >= nearest_m - kTolerance_m - kRounding_m);
    CHECK(as_source.nearest_m < nearest_m + kRounding_m);
}

TEST_CASE("level pairs: what is kept from the last question changes no answer") {
    const TriangleMesh mesh = make_bumpy_sphere(0.05, 12, 0.06, 60.0).value();
    const Levels levels = make_levels(mesh, 5.0e-3);
    const auto kept = make_pairs(levels, levels);
    const auto again = make_pairs(levels, levels);
    const auto anew = make_pairs(levels, levels);
    const auto sum_of = [](const LevelPairs& pairs) {
        Vector3 sum = Vector3::Zero();
        for (const LevelContact& contact : pairs.contacts()) {
            sum += contact.point_O + contact.depth_m * contact.normal_O;
        }
        return sum;
    };
    int n_kept = 0;
    int n_anew = 0;
    int n_near = 0;
    for (int i = 0; i < 400; ++i) {
        const double t = 0.01 * i;
        const Pose X_OT{{0.02 * std::sin(3.0 * t), 0.1045 + 0.0025 * std::sin(7.0 * t), 0.01 * t},
                        compute_exp(Vector3(0.3 * t, std::sin(t), 0.2))};
        anew->clear();
        const LevelAnswer of_kept = kept->find(X_OT, 5.0e-3);
        const LevelAnswer of_anew = anew->find(X_OT, 5.0e-3);
        n_kept += of_kept.n_looked_at;
        n_anew += of_anew.n_looked_at;
        CHECK(std::abs(std::min(of_kept.nearest_m, 1.0) - std::min(of_anew.nearest_m, 1.0)) <
              1.0e-9);
        // The same way, the same bits.
        const LevelAnswer of_again = again->find(X_OT, 5.0e-3);
        CHECK(of_again.n_looked_at == of_kept.n_looked_at);
        CHECK(sum_of(*again) == sum_of(*kept));
        if (of_anew.nearest_m == 0.0) {
            continue;  // where within each other hulls were found to meet may differ
        }
        REQUIRE(kept->contacts().size() == anew->contacts().size());
        n_near += kept->contacts().empty() ? 0 : 1;
        CHECK((sum_of(*kept) - sum_of(*anew)).norm() < 1.0e-6);
    }
    CHECK(n_near > 50);
    CHECK(2 * n_kept < n_anew);
}

TEST_CASE("level pairs: what turns without going anywhere comes near by as much as its reach") {
    constexpr double kNear_m = 5.0e-3;
    const Levels block = make_levels(make_box({0.02, 0.02, 0.02}).value(), kNear_m);
    const Levels bar = make_levels(make_box({0.2, 0.01, 0.01}).value(), kNear_m);
    const auto kept = make_pairs(block, bar);
    const auto anew = make_pairs(block, bar);
    int n_near = 0;
    for (int i = 0; i <= 120; ++i) {
        // The bar's end comes to the block.
        const Pose X_OT{{-0.11, 0.0, 0.0}, compute_exp(Vector3(0.0, 0.0, 1.2 - 0.01 * i))};
        anew->clear();
        const LevelAnswer of_kept = kept->find(X_OT, kNear_m);
        const LevelAnswer of_anew = anew->find(X_OT, kNear_m);
        CAPTURE(i);
        REQUIRE(std::min(of_kept.nearest_m, 1.0) ==
                Approx(std::min(of_anew.nearest_m, 1.0)).margin(1.0e-9));
        n_near += anew->contacts().empty() ? 0 : 1;
    }
    CHECK(n_near > 5);
    CHECK(n_near < 60);
}

TEST_CASE(
    "level pairs: coarser is less work and fewer contacts, none of them farther than what is "
    "nearest") {
    constexpr double kNear_m = 5.0e-3;
    const Levels levels = make_lumps(kNear_m);
    const Pose X_OT = test::kLumpsApart;
    int last = 1 << 30;
    std::size_t last_contacts = 1 << 30;
    const auto exact = make_pairs(levels, levels);
    const double nearest_m = exact->find(X_OT, kNear_m).nearest_m;
    REQUIRE(nearest_m > 0.0);
    for (const double tolerance_m : {0.0, 3.0e-4, 1.0e-3}) {
        const auto pairs = make_pairs(levels, levels, {.tolerance_m = tolerance_m});
        const LevelAnswer answer = pairs->find(X_OT, kNear_m);
        CHECK(!pairs->contacts().empty());
        CHECK(pairs->contacts().size() < last_contacts);
        CHECK(answer.n_looked_at < last);
        CHECK(answer.nearest_m < nearest_m + kRounding_m);
        CHECK(answer.nearest_m > nearest_m - tolerance_m - kRounding_m);
        last = answer.n_looked_at;
        last_contacts = pairs->contacts().size();
    }
}

TEST_CASE("level pairs: where it is deep inside, a tolerance lets nothing through") {
    const Levels levels = make_lumps(1.0e-3);
    const auto exact = make_pairs(levels, levels);
    for (const double tolerance_m : {1.0e-3, 0.04}) {
        const auto coarse = make_pairs(levels, levels, {.tolerance_m = tolerance_m});
        for (int i = 0; i < 40; ++i) {
            const Pose X_OT{{0.0, 0.1 - 1.0e-4 * i, 0.0}, compute_exp(Vector3(0.2, 0.02 * i, 0.1))};
            exact->find(X_OT, 1.0e-3);
            coarse->find(X_OT, 1.0e-3);
            REQUIRE(find_deepest_m(*exact) > 0.0);
            CHECK(find_deepest_m(*coarse) > 0.0);
            CHECK(find_push(*coarse).y() > 0.0);
        }
    }
}

TEST_CASE("level pairs: where there is no room for all pairs, it says so and goes on") {
    const Levels levels = make_levels(make_bumpy_sphere(0.05, 12, 0.06, 60.0).value(), 2.0e-3);
    const auto pairs = make_pairs(levels, levels, {.most_pairs = 64});
    for (int i = 0; i < 20; ++i) {
        const LevelAnswer answer =
            pairs->find({{0.0, 0.098, 0.001 * i}, Quaternion::Identity()}, 2.0e-3);
        CHECK(answer.is_cut);
        CHECK(answer.n_kept <= 64);
    }
}

TEST_CASE("level pairs: broken meshes and poses that are none do no harm") {
    const TriangleMesh mesh = test::make_broken(make_sphere(0.05, 6).value());
    const Levels levels = make_levels(mesh);
    const auto pairs = make_pairs(levels, levels);
    // Pieces are flat, so the distance is that of the triangles.
    const Pose X_OT{{0.08, 0.06, 0.04}, compute_exp(Vector3(0.2, 0.4, 0.1))};
    CHECK(std::abs(pairs->find(X_OT, kWithin_m).nearest_m - find_distance(mesh, mesh, X_OT)) <
          kRounding_m);
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const Pose& wrong : {Pose::at({none, 0.0, 0.0}), Pose::at({0.0, 1.0 / 0.0, 0.0}),
                              Pose{Vector3::Zero(), Quaternion(none, 0.0, 0.0, 1.0)}}) {
        const LevelAnswer answer = pairs->find(wrong, kWithin_m);
        CHECK(pairs->contacts().empty());
        CHECK(std::isinf(answer.nearest_m));
    }
    CHECK(std::abs(pairs->find(X_OT, kWithin_m).nearest_m - find_distance(mesh, mesh, X_OT)) <
          kRounding_m);
}

TEST_CASE("level pairs: what cannot be is refused in a sentence") {
    const Levels ball = make_levels(make_sphere(0.05, 4).value());
    const Levels other = make_levels(make_sphere(0.05, 4).value(), 1.0e-3);
    CHECK_FALSE(LevelPairs::create(nullptr, ball));
    CHECK_FALSE(LevelPairs::create(ball, nullptr));
    CHECK(test::is_refused(LevelPairs::create(ball, other), "within_m"));
    test::check_refused(
        LevelPairSettings{},
        [&](const LevelPairSettings& settings) {
            return LevelPairs::create(ball, ball, settings).has_value();
        },
        {[](auto& s) { s.tolerance_m = -1.0; }, [](auto& s) { s.tolerance_m = std::nan(""); },
         [](auto& s) { s.budget_us = std::nan(""); }, [](auto& s) { s.budget_us = 1.0e7; },
         [](auto& s) { s.spread_m = 0.0; }, [](auto& s) { s.most_pairs = 1; },
         [](auto& s) { s.most_contacts = 0; }});
}
