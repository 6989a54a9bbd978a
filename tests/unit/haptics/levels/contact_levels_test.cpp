#include "haptics/levels/contact_levels.h"

#include "haptics/geometry/shape.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace fulcrum;

namespace {

using Levels = std::shared_ptr<const ContactLevels>;

Levels make_levels(const TriangleMesh& mesh, double within_m = 1.0e-3) {
    return ContactLevels::create(mesh, {.within_m = within_m}).value();
}

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

}  // namespace

TEST_CASE("contact levels: hulls hold all triangles below tightly, of every shape") {
    for (const TriangleMesh& mesh :
         {make_bumpy_sphere(0.1, 10, 0.05, 30.0).value(), make_torus(0.1, 0.03, 24, 12).value(),
          make_sphere(0.1, 8).value(), make_box({0.1, 0.2, 0.3}).value(),
          make_plate(0.2, 0.2, 6).value(),
          TriangleMesh::build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}).value()}) {
        const Levels levels = make_levels(mesh);
        check_tree(mesh, *levels);
        check_bounds(mesh, *levels);
    }
}

TEST_CASE("contact levels: what is convex is one node, exact") {
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
    for (const double within_m : {0.0, -1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
        CHECK(test::is_refused(ContactLevels::create(mesh, {.within_m = within_m}), "within_m"));
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
    CHECK(test::is_refused(stopped, "stopped"));
}
