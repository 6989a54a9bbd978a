#include "haptics/geometry/obb_tree.h"

#include "haptics/geometry/shape.h"
#include "tests/support/mesh_corners.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>
#include <set>

namespace fulcrum {
namespace {

constexpr double kSingle = 1.0e-6;  // what single precision leaves of lengths about 1

OrientedBox make_unit_box() {
    OrientedBox box;
    box.axes = {{{1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {0.0F, 0.0F, 1.0F}}};
    box.half_size = {1.0F, 2.0F, 3.0F};
    return box;
}

bool are_met(const OrientedBox& box, const Vector3& from, const Vector3& to) {
    return overlaps(box, to_centred(from, to));
}

std::vector<std::int32_t> count_to(std::size_t n, std::int32_t first = 0) {
    std::vector<std::int32_t> all(n);
    std::iota(all.begin(), all.end(), first);
    return all;
}
// A box's half sides, from the shortest on.
std::array<double, 3> find_sizes(const ObbForest& forest, std::int32_t root) {
    auto sizes = forest.box(root).half_size;
    std::sort(sizes.begin(), sizes.end());
    return {sizes[0], sizes[1], sizes[2]};
}

TEST_CASE("obb tree: each of the six axes of the segment's test keeps a segment away") {
    const OrientedBox box = make_unit_box();
    const double hair = 1.0e-9;
    const auto along = [](int axis, double at) { return Vector3(at * Vector3::Unit(axis)); };
    // The box's own axes: a segment that ends a hair before a face, or in it.
    for (int axis = 0; axis < 3; ++axis) {
        const double size = axis + 1.0;
        for (const double side : {-1.0, 1.0}) {
            CHECK_FALSE(are_met(box, along(axis, side * 5.0), along(axis, side * (size + hair))));
            CHECK(are_met(box, along(axis, side * 5.0), along(axis, side * (size - hair))));
        }
    }
    // The cross products: a segment that passes an edge, across it, within or outside of the corner of the outline.
    for (int axis = 0; axis < 3; ++axis) {
        const int j = (axis + 1) % 3;
        const int k = (axis + 2) % 3;
        const Vector3 corner = along(j, j + 1.0) + along(k, k + 1.0);
        const Vector3 way = along(j, 1.0) - along(k, 1.0);
        const Vector3 out = along(j, hair) + along(k, hair);
        CHECK_FALSE(are_met(box, corner + out - 0.9 * way, corner + out + 0.9 * way));
        CHECK(are_met(box, corner - out - 0.9 * way, corner - out + 0.9 * way));
    }
}

TEST_CASE("obb tree: the segment's test agrees with a search along the segment, for turned boxes") {
    Random random(6);
    int n_met = 0;
    int n_apart = 0;
    for (int i = 0; i < 4000; ++i) {
        OrientedBox box = make_unit_box();
        const Matrix3 turn = random.turn(3.0).toRotationMatrix();
        const Vector3 centre = random.in_cube();
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 3; ++column) {
                box.axes[row][column] =
                    static_cast<float>(turn(static_cast<Index>(row), static_cast<Index>(column)));
            }
            box.centre[row] = static_cast<float>(centre[static_cast<Index>(row)]);
        }
        const Vector3 from = 5.0 * random.in_cube();
        const Vector3 to = 5.0 * random.in_cube();
        // The least of max_i |m_i| / t_i along it, a convex function, by thirds.
        const auto reach = [&](double t) {
            const Vector3 p = turn * (from + t * (to - from) - centre);
            return p.cwiseAbs().cwiseQuotient(Vector3(1.0, 2.0, 3.0)).maxCoeff();
        };
        double low = 0.0;
        double high = 1.0;
        for (int round = 0; round < 100; ++round) {
            const double a = (2.0 * low + high) / 3.0;
            const double b = (low + 2.0 * high) / 3.0;
            (reach(a) < reach(b) ? high : low) = reach(a) < reach(b) ? b : a;
        }
        const double least = reach(0.5 * (low + high));
        if (std::abs(least - 1.0) > 10.0 * kSingle) {
            REQUIRE(are_met(box, from, to) == (least < 1.0));
            (least < 1.0 ? n_met : n_apart) += 1;
        }
    }
    CHECK(n_met > 500);
    CHECK(n_apart > 500);
}

TEST_CASE("obb tree: a box has the axes along which the surface spreads, and holds all of it") {
    // A slab of 4 x 2 x 0.5, turned and moved.
    Random random(8);
    const auto slab = make_box(Vector3(4.0, 2.0, 0.5));
    const Matrix3 turn = random.turn(3.0).toRotationMatrix();
    std::vector<Vector3> vertices = slab->vertices_B();
    for (Vector3& vertex : vertices) {
        vertex = turn * vertex + Vector3(10.0, -20.0, 5.0);
    }
    ObbForest forest(vertices, slab->triangles(), 1000);
    const std::int32_t root = forest.add(count_to(slab->triangles().size()));
    const auto sizes = find_sizes(forest, root);
    CHECK(sizes[0] == Approx(0.25).margin(1e-5));
    CHECK(sizes[1] == Approx(1.0).margin(1e-5));
    CHECK(sizes[2] == Approx(2.0).margin(1e-5));
    for (const Vector3& vertex : vertices) {
        CHECK(are_met(forest.box(root), vertex, vertex));
    }
}

TEST_CASE("obb tree: a box as it is kept, in single precision, holds every corner") {
    const auto mesh = make_bumpy_sphere(1.0, 12, 0.05, 9.0);
    ObbForest forest(mesh->vertices_B(), mesh->triangles(), 1);
    double worst = -1.0;
    for (std::int32_t first = 0; first + 8 <= 2880; ++first) {
        const auto some = count_to(1 + static_cast<std::size_t>(first % 8), first);
        const OrientedBox box = forest.box(forest.add(some));
        for (const std::int32_t triangle : some) {
            for (const Vector3& corner :
                 corners_of(*mesh, mesh->triangles()[static_cast<std::size_t>(triangle)])) {
                const Vector3 place = box.to_frame(corner);
                for (std::size_t i = 0; i < 3; ++i) {
                    worst = std::max(worst, std::abs(place[static_cast<Index>(i)]) -
                                                static_cast<double>(box.half_size[i]));
                }
            }
        }
    }
    CHECK(worst <= 0.0);
    CHECK(worst > -1.0e-6);
}

TEST_CASE("obb tree: the covariance is that of the surface, not of its corners or triangles") {
    // Halves of a plate of 2 x 1, one of them in many triangles: the axes must not lean towards it.
    const auto fine = make_plate(1.0, 1.0, 8);
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles = fine->triangles();
    for (const Vector3& vertex : fine->vertices_B()) {
        vertices.emplace_back(vertex + Vector3(0.5, 0.0, 0.5));
    }
    const auto first = static_cast<std::int32_t>(vertices.size());
    for (const double z : {0.0, 1.0}) {
        vertices.emplace_back(-1.0, 0.0, z);
        vertices.emplace_back(0.0, 0.0, z);
    }
    triangles.push_back({first, first + 2, first + 3});
    triangles.push_back({first, first + 3, first + 1});
    ObbForest forest(vertices, triangles, 1000);
    const auto sizes = find_sizes(forest, forest.add(count_to(triangles.size())));
    CHECK(sizes[0] == Approx(0.0).margin(1e-6));
    CHECK(sizes[1] == Approx(0.5).margin(1e-6));
    CHECK(sizes[2] == Approx(1.0).margin(1e-6));
}

TEST_CASE("obb tree: every triangle that a segment touches is visited, once, and few others") {
    const auto mesh = make_bumpy_sphere(1.0, 20, 0.05, 9.0);
    ObbForest forest(mesh->vertices_B(), mesh->triangles(), 2);
    const std::int32_t root = forest.add(count_to(mesh->triangles().size()));
    Random random(10);
    std::size_t n_visited = 0;
    for (int i = 0; i < 500; ++i) {
        const auto& t = mesh->triangles()[random.integer() % mesh->triangles().size()];
        const auto [a, b, c] = corners_of(*mesh, t);
        const Vector3 centre = (a + b + c) / 3.0;
        const Vector3 way = 0.05 * random.in_cube();
        std::set<std::int32_t> found;
        forest.for_each_met(root, to_centred(centre - way, centre + way),
                            [&](std::int32_t triangle) { REQUIRE(found.insert(triangle).second); });
        n_visited += found.size();
        const auto index = static_cast<std::int32_t>(&t - mesh->triangles().data());
        REQUIRE(found.count(index) == 1);
    }
    CHECK(n_visited < 500 * 30);
}

TEST_CASE("obb tree: triangles that all have one centre are halved by number") {
    const std::vector<Vector3> vertices{{1.0, 0.0, 0.0}, {-0.5, 0.8, 0.0}, {-0.5, -0.8, 0.0}};
    const std::vector<TriangleCorners> triangles(100, {0, 1, 2});
    ObbForest forest(vertices, triangles, 1);
    const std::int32_t root = forest.add(count_to(triangles.size()));
    int n_visited = 0;
    forest.for_each_met(root, to_centred(Vector3(0.0, 0.0, 1.0), Vector3(0.0, 0.0, -1.0)),
                        [&](std::int32_t) { ++n_visited; });
    CHECK(n_visited == 100);
}

}  // namespace
}  // namespace fulcrum
