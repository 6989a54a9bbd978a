#include "haptics/geometry/bounding_tree.h"

#include "haptics/geometry/shape.h"
#include "tests/support/mesh_corners.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

namespace fulcrum {
namespace {

Box box_of(const TriangleMesh& mesh, std::int32_t triangle) {
    const auto [a, b, c] = corners_of(mesh, mesh.triangles()[static_cast<std::size_t>(triangle)]);
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

std::set<std::int32_t> find_in_box(const BoundingTree& tree, const Box& box) {
    std::set<std::int32_t> found;
    tree.for_each_in_box(box, [&](std::int32_t slot) {
        const bool is_new = found.insert(tree.order()[static_cast<std::size_t>(slot)]).second;
        REQUIRE(is_new);
    });
    return found;
}

TEST_CASE("bounding tree: every triangle has one slot, and memory is what the layout says") {
    for (const int n : {1, 2, 3, 5, 16, 17, 40}) {
        const auto mesh = make_plate(1.0, 2.0, n);
        const BoundingTree tree(*mesh);
        std::vector<std::int32_t> order(tree.order().begin(), tree.order().end());
        std::sort(order.begin(), order.end());
        REQUIRE(order.size() == mesh->triangles().size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            REQUIRE(order[i] == static_cast<std::int32_t>(i));
        }
        const Box everything{mesh->lower_B(), mesh->upper_B()};
        REQUIRE(find_in_box(tree, everything).size() == order.size());
    }
    const auto mesh =
        make_sphere(1.0, 40);  // 32000 triangles: 4000 + 500 + 63 + 8 + 1 nodes of 96 bytes
    const BoundingTree tree(*mesh);
    CHECK(tree.memory_bytes() == (4000 + 500 + 63 + 8 + 1) * 96 + 32000 * 4);
}

TEST_CASE("bounding tree: a box query misses no triangle and finds few others, at any scale") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const double scale : {1e-4, 1.0, 1e4}) {
        const auto mesh = make_bumpy_sphere(scale, 12, 0.1, 7.0);
        const BoundingTree tree(*mesh);
        std::size_t n_expected = 0;
        std::size_t n_found = 0;
        for (int round = 0; round < 300; ++round) {
            const Vector3 centre = 1.2 * scale * Vector3(unit(random), unit(random), unit(random));
            const Vector3 half =
                0.2 * scale * Vector3(unit(random), unit(random), unit(random)).cwiseAbs();
            const Box box{centre - half, centre + half};
            const std::set<std::int32_t> found = find_in_box(tree, box);
            n_found += found.size();
            for (std::int32_t i = 0; i < static_cast<std::int32_t>(mesh->triangles().size()); ++i) {
                if (box_of(*mesh, i).overlaps(box)) {
                    ++n_expected;
                    REQUIRE(found.count(i) == 1);
                }
            }
        }
        CHECK(n_found >= n_expected);
        CHECK(n_found <=
              n_expected +
                  n_expected / 100);  // 16-bit steps are a hundredth of a triangle or finer
    }
}

TEST_CASE("bounding tree: of nodes that are off nothing is visited, and nothing else is left out") {
    std::mt19937_64 random(8);
    std::normal_distribution<double> normal;
    for (const double scale : {1e-4, 1.0, 1e4}) {
        const auto mesh = make_bumpy_sphere(scale, 12, 0.1, 7.0);
        const BoundingTree tree(*mesh);
        const Box everything{mesh->lower_B(), mesh->upper_B()};
        std::size_t n_above = 0;
        std::size_t n_visited = 0;
        for (int round = 0; round < 100; ++round) {
            const Vector3 up = Vector3(normal(random), normal(random), normal(random)).normalized();
            const double height = scale * 0.3 * normal(random);
            std::set<std::int32_t> visited;
            tree.for_each_in_box(
                everything,
                [&](const Box& node) {
                    return up.dot(0.5 * (node.lower + node.upper)) +
                               up.cwiseAbs().dot(0.5 * (node.upper - node.lower)) <
                           height;
                },
                [&](std::int32_t slot) {
                    visited.insert(tree.order()[static_cast<std::size_t>(slot)]);
                });
            n_visited += visited.size();
            for (std::int32_t i = 0; i < static_cast<std::int32_t>(mesh->triangles().size()); ++i) {
                const auto [a, b, c] =
                    corners_of(*mesh, mesh->triangles()[static_cast<std::size_t>(i)]);
                if (std::max({up.dot(a), up.dot(b), up.dot(c)}) >= height) {
                    ++n_above;
                    REQUIRE(visited.count(i) == 1);
                }
            }
        }
        // A leaf at the plane holds some that are below it.
        CHECK(n_visited < n_above + n_above / 4);
    }
}

TEST_CASE("bounding tree: leaves searched for in pieces are those of one search") {
    const BoundingTree tree(*make_bumpy_sphere(1.0, 40, 0.1, 7.0));
    const auto as_set = [](std::span<const std::int32_t> leaves) {
        return std::set<std::int32_t>(leaves.begin(), leaves.end());
    };
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    BoundingTree::LeafSearch search;
    CHECK(search.is_over());
    int n_too_many = 0;
    int n_in_pieces = 0;
    for (int round = 0; round < 500; ++round) {
        const Vector3 centre = 1.1 * Vector3(unit(random), unit(random), unit(random));
        const Vector3 half = Vector3::Constant(0.25 * std::abs(unit(random)));
        const Box box{centre - half, centre + half};
        std::array<std::int32_t, 24> at_once{};
        std::array<std::int32_t, 24> in_pieces{};
        const auto n_at_once = tree.collect_leaves(box, at_once);
        search.begin(tree, box);
        int n_pieces = 1;
        for (; tree.go_on(search, 1 + round % 7, in_pieces); ++n_pieces) {
            REQUIRE_FALSE(search.is_over());
        }
        REQUIRE(search.is_over());
        n_in_pieces += n_pieces > 1 ? 1 : 0;
        if (!n_at_once) {
            REQUIRE(search.n_found() > in_pieces.size());
            ++n_too_many;
            continue;
        }
        REQUIRE(search.n_found() == *n_at_once);
        REQUIRE(as_set(std::span(in_pieces).first(*n_at_once)) ==
                as_set(std::span(at_once).first(*n_at_once)));
    }
    CHECK(n_too_many > 20);
    CHECK(n_in_pieces > 200);
    // However many leaves there is room for, the nodes above them are more than a search holds.
    std::array<std::int32_t, 4000> plenty{};
    CHECK_FALSE(BoundingTree(*make_sphere(1.0, 80))
                    .collect_leaves({Vector3::Constant(-1.0), Vector3::Constant(1.0)}, plenty));
    // Far from all triangles it is over at once.
    search.begin(tree, {Vector3::Constant(5.0), Vector3::Constant(6.0)});
    CHECK(search.is_over());
}

TEST_CASE(
    "bounding tree: leaves collected hold every triangle near, on a box's edge too; few others") {
    // From one leaf that is the root itself to four levels.
    for (const int frequency : {1, 2, 5, 40}) {
        const auto mesh = make_bumpy_sphere(1.0, frequency, 0.1, 7.0);
        const BoundingTree tree(*mesh);
        std::mt19937_64 random(6);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        std::size_t n_leaves = 0;
        std::size_t n_needed = 0;
        for (int round = 0; round < 300; ++round) {
            const Vector3 centre = Vector3(unit(random), unit(random), unit(random)).normalized();
            const Box box{centre - Vector3::Constant(0.05), centre + Vector3::Constant(0.05)};
            std::array<std::int32_t, 24> leaves{};
            const auto n = tree.collect_leaves(box, leaves);
            REQUIRE(n);
            std::set<std::int32_t> needed;
            tree.for_each_in_box(box, [&](std::int32_t slot) { needed.insert(slot / 8); });
            const std::set<std::int32_t> found(leaves.begin(),
                                               leaves.begin() + static_cast<std::ptrdiff_t>(*n));
            REQUIRE(std::includes(found.begin(), found.end(), needed.begin(), needed.end()));
            n_leaves += *n;
            n_needed += needed.size();
        }
        CHECK(n_needed > 200);
        CHECK(n_leaves < 2 * n_needed);
    }
    const auto mesh = make_plate(1.0, 1.0, 8);
    const BoundingTree tree(*mesh);
    for (const Vector3& vertex : mesh->vertices_B()) {
        std::size_t n_at_vertex = 0;
        for (std::int32_t i = 0; i < static_cast<std::int32_t>(mesh->triangles().size()); ++i) {
            n_at_vertex += box_of(*mesh, i).contains(vertex) ? 1 : 0;
        }
        REQUIRE(find_in_box(tree, {vertex, vertex}).size() >= n_at_vertex);
    }
}

TEST_CASE("bounding tree: along a segment no box that it meets is missed, from near and far") {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto mesh = make_bumpy_sphere(1.0, 10, 0.1, 7.0);
    const BoundingTree tree(*mesh);
    for (int round = 0; round < 1000; ++round) {
        const double far = std::pow(10.0, 4.0 + 4.0 * unit(random));
        const Vector3 direction = Vector3(unit(random), unit(random), unit(random)).normalized();
        const Vector3 through = 1.1 * Vector3(unit(random), unit(random), unit(random));
        const Vector3 from = through - far * direction;
        const Vector3 to = through + far * direction;
        std::set<std::int32_t> found;
        tree.for_each_along(from, to, [&](std::int32_t slot, double t_end) {
            found.insert(tree.order()[static_cast<std::size_t>(slot)]);
            return t_end;
        });
        for (std::int32_t i = 0; i < static_cast<std::int32_t>(mesh->triangles().size()); ++i) {
            const Box box = box_of(*mesh, i);
            // The centre of each box that holds a point of the segment near `through`.
            const double t = (0.5 * (box.lower + box.upper) - through).dot(direction);
            if (std::abs(t) < far && box.contains(through + t * direction)) {
                REQUIRE(found.count(i) == 1);
            }
        }
    }
}

TEST_CASE("bounding tree: a visitor that shortens the segment is spared what lies beyond") {
    const auto mesh = make_bumpy_sphere(1.0, 30, 0.05, 7.0);
    const BoundingTree tree(*mesh);
    const Vector3 from(0.1, 0.2, 3.0);
    const Vector3 to(0.1, 0.2, -3.0);
    int n_all = 0;
    int n_near = 0;
    tree.for_each_along(from, to, [&](std::int32_t, double t_end) {
        ++n_all;
        return t_end;
    });
    tree.for_each_along(from, to, [&](std::int32_t, double) {
        ++n_near;
        return 0.4;  // the near face lies at 1/3, the far one at 2/3
    });
    CHECK(n_near > 0);
    CHECK(2 * n_near <= n_all + 2);
}

}  // namespace
}  // namespace fulcrum
