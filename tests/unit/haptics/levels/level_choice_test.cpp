#include "haptics/geometry/shape.h"
#include "haptics/levels/contact_levels.h"
#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/level_parts.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

// Every triangle below a node lies within `outside_m` of its hull: corners say it, for a distance to what is convex is greatest there.
void check_bounds(const TriangleMesh& mesh, const ContactLevels& levels) {
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(levels.nodes().size()); ++i) {
        const HullView hull = levels.hull(i);
        for (const std::int32_t triangle : levels.triangles_of(i)) {
            for (const std::int32_t corner : mesh.triangles()[static_cast<std::size_t>(triangle)]) {
                const Vector3& place = mesh.vertices_B()[static_cast<std::size_t>(corner)];
                REQUIRE(find_nearest_in_hull(hull, place).gap_m <= levels.node(i).outside_m);
            }
        }
    }
}

// A tree: every node but the root is one node's child, and has its parent's triangles between its children.
void check_tree(const TriangleMesh& mesh, const ContactLevels& levels) {
    std::vector<int> n_parents(levels.nodes().size(), 0);
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(levels.nodes().size()); ++i) {
        const LevelNode& node = levels.node(i);
        std::size_t n_below = 0;
        for (std::int32_t child = node.first_child; child < node.first_child + node.n_children;
             ++child) {
            REQUIRE(child > i);
            ++n_parents[static_cast<std::size_t>(child)];
            n_below += levels.triangles_of(child).size();
            CHECK(levels.node(child).level < node.level);
        }
        CHECK(node.outside_m < 1.0e-6 * levels.size_m());
        CHECK((node.n_children == 0 || n_below == levels.triangles_of(i).size()));
        CHECK((node.n_children == 0) == (node.level == 0));
    }
    CHECK(n_parents.front() == 0);
    CHECK(std::all_of(n_parents.begin() + 1, n_parents.end(), [](int n) { return n == 1; }));
    std::vector<std::int32_t> all(levels.triangles_of(0).begin(), levels.triangles_of(0).end());
    std::ranges::sort(all);
    REQUIRE(all.size() == mesh.triangles().size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(all[i] == static_cast<std::int32_t>(i));
    }
}

// A clock that is read once a piece of work: then so many microseconds are so many pieces.
double ticks_s = 0.0;
double count_a_tick_s() noexcept {
    ticks_s += 1.0e-6;
    return ticks_s;
}

// 10 mm deep, where thousands of pairs of pieces are looked at.
struct DeepLumps {
    static constexpr double kNear_m = 1.0e-3;
    Levels levels = make_lumps(kNear_m);
    Pose X_OT{{0.002, 0.09, 0.0}, compute_exp(Vector3(0.2, 0.4, 0.1))};
    [[nodiscard]] std::unique_ptr<LevelPairs> ask_within(double budget_us) const {
        return make_pairs(levels, levels, {.budget_us = budget_us, .now_s = &count_a_tick_s});
    }
};

}  // namespace

TEST_CASE("contact levels: hulls hold all below tightly, and what is convex is one node, exact") {
    for (const TriangleMesh& mesh :
         {make_bumpy_sphere(0.1, 10, 0.05, 30.0).value(), make_torus(0.1, 0.03, 24, 12).value(),
          make_sphere(0.1, 8).value(), make_box({0.1, 0.2, 0.3}).value(),
          make_plate(0.2, 0.2, 6).value(),
          TriangleMesh::build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}).value()}) {
        const Levels levels = make_levels(mesh);
        check_tree(mesh, *levels);
        check_bounds(mesh, *levels);
    }
    const Levels levels = make_levels(make_sphere(0.1, 12).value());
    REQUIRE(levels->nodes().size() == 1);
    CHECK(levels->node(0).detail_m3 == 0.0);
    CHECK(levels->node(0).deviation_m == 0.0);
    CHECK(levels->node(0).normal_B.norm() == 0.0);
    CHECK(levels->size_m() == Approx(0.1 * std::sqrt(3.0)).epsilon(0.02));
    CHECK(levels->reach_m() == Approx(0.1).epsilon(0.001));
}

TEST_CASE("contact levels: the support area of a ball is that of its cap") {
    // A plane pressed by d has a circle of 2 pi R d, and 240 triangles of it stay below the most that are counted.
    constexpr double kRadius_m = 0.1;
    constexpr double kWithin_m = 2.0e-3;
    const Levels levels = make_levels(make_sphere(kRadius_m, 24).value(), kWithin_m);
    const double exact_m2 = 2.0 * std::numbers::pi * kRadius_m * kWithin_m;
    CHECK(levels->node(0).support_m2 == Approx(exact_m2).epsilon(0.25));
}

TEST_CASE(
    "contact levels: upwards there are fewer pieces, of less resolution and more detail lost") {
    const Levels levels = make_levels(make_bumpy_sphere(0.1, 20, 0.02, 60.0).value());
    CHECK(levels->n_levels() >= 6);
    std::vector<int> count(64, 0);
    std::vector<double> detail(64, 0.0);
    for (const LevelNode& node : levels->nodes()) {
        ++count[static_cast<std::size_t>(node.level)];
        if (!node.is_bound_only) {
            CHECK(node.detail_m3 ==
                  Approx(node.n_children == 0
                             ? 0.0
                             : node.deviation_m / std::pow(node.resolution_per_m, 2.0)));
            CHECK(node.support_m2 > 0.0);
        }
        for (std::int32_t i = 0; i < node.n_children; ++i) {
            CHECK(levels->node(node.first_child + i).resolution_per_m >= node.resolution_per_m);
        }
    }
    CHECK(count[0] == levels->n_pieces());
    CHECK(count[1] < count[0]);
    CHECK(count[3] < count[1]);
    // Detail of 2 mm over some 10 mm is lost no sooner than edges are as long.
    for (const LevelNode& node : levels->nodes()) {
        if (!node.is_bound_only && node.n_children > 0 && node.resolution_per_m > 200.0) {
            CHECK(node.deviation_m < 2.5e-3);
        }
    }
}

TEST_CASE(
    "contact levels: a hull stands out of a hollow by its sagitta, of what is convex not at all") {
    // A ball's surface turned inwards: what is in front of it is inside, and a hull's nearest to the middle stands out most.
    constexpr double kRadius_m = 0.1;
    const Levels levels =
        make_levels(make_inverted(make_sphere(kRadius_m, 10).value()).value(), 1.0e-3);
    const double facet_m = kRadius_m * (1.0 - std::cos(0.5 / 10.0 * std::numbers::pi / 2.0)) * 2.0;
    int n_standing = 0;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(levels->nodes().size()); ++i) {
        const LevelNode& node = levels->node(i);
        if (node.is_bound_only || node.n_children == 0) {
            CHECK(node.deviation_m == 0.0);
            continue;
        }
        const HullPair middle = find_nearest_in_hull(levels->hull(i), Vector3::Zero());
        const double sagitta_m = kRadius_m - middle.gap_m;
        CAPTURE(i, sagitta_m, node.deviation_m);
        CHECK(node.deviation_m < sagitta_m + 1.0e-9);
        if (sagitta_m > 4.0 * facet_m && sagitta_m < 0.02) {
            ++n_standing;
            CHECK(node.deviation_m > 0.6 * sagitta_m - facet_m);
        }
    }
    CHECK(n_standing > 10);
}

TEST_CASE("contact levels: a mesh gives the same levels each time") {
    const TriangleMesh mesh = make_bumpy_sphere(0.1, 10, 0.05, 30.0).value();
    const Levels one = make_levels(mesh);
    const Levels other = make_levels(mesh);
    REQUIRE(one->nodes().size() == other->nodes().size());
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(one->nodes().size()); ++i) {
        CHECK(one->node(i).deviation_m == other->node(i).deviation_m);
        CHECK(one->node(i).detail_m3 == other->node(i).detail_m3);
        CHECK(std::ranges::equal(one->hull(i).points, other->hull(i).points));
    }
    CHECK(one->memory_bytes() < 1000 * mesh.triangles().size());
}

TEST_CASE("contact levels: what is wrong with a mesh is told, and a broken one has levels too") {
    const TriangleMesh ball = make_sphere(0.1, 6).value();
    const TriangleMesh mesh = test::make_broken(ball);
    const Levels levels = make_levels(mesh);
    check_tree(mesh, *levels);
    check_bounds(mesh, *levels);
    CHECK_FALSE(levels->report().is_sound());
    CHECK(to_sentence(levels->report()).find("edge") != std::string::npos);
    CHECK(make_levels(ball)->report().is_sound());
}

TEST_CASE("contact levels: what cannot be is refused, and an order to stop is heard") {
    const TriangleMesh mesh = make_bumpy_sphere(0.1, 20, 0.05, 30.0).value();
    for (const double within_m : {0.0, -1.0, 2.0, kNan}) {
        CHECK(is_refused(ContactLevels::create(mesh, {.within_m = within_m}), "within_m"));
    }
    double share = 0.0;
    const auto told = ContactLevels::create(mesh, {}, [&share](double done) {
        CHECK(done >= share);
        share = done;
        return true;
    });
    REQUIRE(told);
    const auto stopped = ContactLevels::create(make_bumpy_sphere(0.1, 60, 0.05, 100.0).value(), {},
                                               [](double done) { return done < 0.25; });
    CHECK(is_refused(stopped, "stopped"));
}

// A budget of time is kept however deep it is, and what it leaves is told: by a clock that counts.

TEST_CASE(
    "level pairs: however deep, the budget is kept but for one way down, and what is left is "
    "told") {
    const DeepLumps deep;
    const auto exact = make_pairs(deep.levels, deep.levels);
    const LevelAnswer whole = exact->find(deep.X_OT, DeepLumps::kNear_m);
    REQUIRE(whole.n_looked_at > 2000);
    CHECK(whole.n_left + whole.n_coarser == 0);
    CHECK(whole.left_m == 0.0);
    // A way down ends after each node of either tree; at its end there are a patch and the clock.
    const int one_way = 2 * 2 * deep.levels->n_levels() + 8;
    for (const double budget_us : {20.0, 50.0, 100.0, 200.0, 500.0}) {
        const auto pairs = deep.ask_within(budget_us);
        int n_before = 0;
        for (int i = 0; i < 30; ++i) {
            const double before_s = ticks_s;
            const LevelAnswer answer = pairs->find(deep.X_OT, DeepLumps::kNear_m);
            const double took_us = 1.0e6 * (ticks_s - before_s);
            CAPTURE(budget_us, i, took_us, answer.n_patches, answer.n_left);
            // Two more to begin and to end.
            CHECK(took_us <= budget_us + one_way + 2);
            // No more work than readings of the clock: so time is what the clock says.
            CHECK(answer.n_looked_at <= took_us + one_way);
            // The first questions know nothing, and their ways down may end where nothing is.
            CHECK((answer.n_patches > 0 || i < 10));
            CHECK(answer.n_left + answer.n_coarser > 0);
            CHECK(answer.left_m > 0.0);
            CHECK(answer.left_m < 0.1);
            CHECK(answer.error_m <= DeepLumps::kNear_m);
            for (const LevelContact& contact : pairs->contacts()) {
                CHECK(contact.point_O.allFinite());
                CHECK(contact.normal_O.norm() == Approx(1.0));
            }
            n_before = answer.n_patches;
        }
        CHECK(n_before >= budget_us / 100.0);
    }
}

TEST_CASE("level pairs: within a budget it is pushed out as without, the more time the better") {
    const DeepLumps deep;
    const auto exact = make_pairs(deep.levels, deep.levels);
    exact->find(deep.X_OT, DeepLumps::kNear_m);
    const Vector3 way = find_push(*exact).normalized();
    double last_worst = 0.0;
    for (const double budget_us : {200.0, 800.0, 3200.0}) {
        const auto pairs = deep.ask_within(budget_us);
        double worst = 1.0;
        for (int i = 0; i < 20; ++i) {
            pairs->find(deep.X_OT, DeepLumps::kNear_m);
            if (i >= 10) {
                worst = std::min(worst, find_push(*pairs).normalized().dot(way));
            }
        }
        CAPTURE(budget_us);
        CHECK(worst > 0.9);
        last_worst = worst;
    }
    CHECK(last_worst > 0.99);
}

TEST_CASE(
    "level pairs: a budget that is enough gives the whole answer, and no more than a tolerance") {
    constexpr double kNear_m = 5.0e-3;
    const Levels levels = make_lumps(kNear_m);
    const Pose X_OT = test::kLumpsApart;
    const auto exact = make_pairs(levels, levels);
    const double nearest_m = exact->find(X_OT, kNear_m).nearest_m;
    const auto most = make_pairs(levels, levels, {.budget_us = 1.0e6});
    const LevelAnswer fine = most->find(X_OT, kNear_m);
    CHECK(fine.error_m == 0.0);
    CHECK(fine.n_left + fine.n_coarser == 0);
    CHECK(!fine.is_late);
    CHECK(fine.nearest_m == Approx(nearest_m).margin(kRounding_m));
    CHECK(most->contacts().size() == exact->contacts().size());
    // Not finer than the tolerance, however much time there is.
    const auto held = make_pairs(levels, levels, {.tolerance_m = 1.2e-2, .budget_us = 1.0e6});
    CHECK(held->find(X_OT, kNear_m).error_m > 0.0);
    // No time at all: late, and one way down is gone all the same.
    const auto least = make_pairs(levels, levels, {.budget_us = 1.0e-3});
    const LevelAnswer hasty = least->find(X_OT, kNear_m);
    CHECK(hasty.is_late);
    CHECK(hasty.n_left + hasty.n_coarser > 0);
    CHECK(hasty.n_patches <= 1);
    CHECK(hasty.n_looked_at <= 4 * levels->n_levels());
}

TEST_CASE("level pairs: in free space nothing is told, whatever the budget") {
    const Levels levels = make_levels(make_bumpy_sphere(0.05, 12, 0.06, 60.0).value(), 1.0e-3);
    for (const double budget_us : {1.0e-3, 20.0, 1.0e6}) {
        const auto pairs = make_pairs(levels, levels, {.budget_us = budget_us});
        for (int i = 0; i < 50; ++i) {
            const LevelAnswer answer = pairs->find(
                {{0.002 * i, 0.107, 0.0}, compute_exp(Vector3(0.1 * i, 0.2, 0.0))}, 1.0e-3);
            CHECK(pairs->contacts().empty());
            CHECK(std::isinf(answer.nearest_m));
        }
    }
}

TEST_CASE("level pairs: what a budget cut short is found again as soon as there is time") {
    constexpr double kNear_m = 5.0e-3;
    const Levels levels = make_levels(make_bumpy_sphere(0.05, 12, 0.06, 60.0).value(), kNear_m);
    const auto exact = make_pairs(levels, levels);
    const auto hurried = make_pairs(levels, levels, {.now_s = &count_a_tick_s});
    int n_near = 0;
    for (int i = 0; i < 3000; ++i) {
        // To and fro along the object, always near it somewhere.
        const double along = 0.3 * std::sin(0.08 * i);
        const double far_m = 0.1035 + 0.0008 * std::sin(0.56 * i);
        const Pose X_OT{far_m * Vector3(std::sin(along), std::cos(along), 0.0),
                        compute_exp(Vector3(0.0, 0.0, 0.3 * along))};
        const bool has_time = i % 10 == 9;
        hurried->set_budget_us(has_time ? 0.0 : 1.0 + i % 1000);
        const LevelAnswer answer = hurried->find(X_OT, kNear_m);
        if (!has_time) {
            continue;
        }
        const LevelAnswer whole = exact->find(X_OT, kNear_m);
        CAPTURE(i, whole.nearest_m, answer.nearest_m);
        REQUIRE(hurried->contacts().empty() == exact->contacts().empty());
        REQUIRE(std::min(answer.nearest_m, 1.0) ==
                Approx(std::min(whole.nearest_m, 1.0)).margin(kRounding_m));
        n_near += exact->contacts().empty() ? 0 : 1;
    }
    CHECK(n_near > 200);
}
