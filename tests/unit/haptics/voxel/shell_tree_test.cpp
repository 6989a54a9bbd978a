#include "haptics/voxel/shell_tree.h"

#include "haptics/geometry/shape.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <limits>
#include <numeric>

using namespace fulcrum;

namespace {

Pointshell make_shell(int n_points) {
    return make_surface_pointshell(*make_bumpy_sphere(1.0, 12, 0.1, 6.0), n_points).value();
}

Vector3 place_in(const ShellPoints& points, std::size_t i) {
    return {points.x[i], points.y[i], points.z[i]};
}

}  // namespace

TEST_CASE("shell tree: holds every point once, with its normal") {
    for (const int n : {1, 31, 32, 33, 256, 257, 5000}) {
        const Pointshell shell = make_shell(n);
        const ShellTree tree = ShellTree::build(shell).value();
        std::vector<std::int32_t> order = tree.order();
        CHECK(tree.n_points() == static_cast<std::size_t>(n));
        for (std::size_t i = 0; i < order.size(); ++i) {
            const ShellPoints leaf = tree.points(0, i / kLeafPoints);
            const auto from = static_cast<std::size_t>(order[i]);
            REQUIRE(leaf.x[i % kLeafPoints] == shell.x_m[from]);
            REQUIRE(leaf.nz[i % kLeafPoints] == shell.nz[from]);
        }
        std::sort(order.begin(), order.end());
        std::vector<std::int32_t> all(order.size());
        std::iota(all.begin(), all.end(), 0);
        CHECK(order == all);
        std::size_t counted = 0;
        for (std::size_t leaf = 0; leaf < tree.n_leaves(); ++leaf) {
            counted += tree.count_in(0, leaf);
        }
        CHECK(counted == order.size());
    }
}

TEST_CASE("shell tree: each node's ball holds its points, and not much more") {
    const ShellTree tree = ShellTree::build(make_shell(20000)).value();
    CHECK(tree.n_levels() == 4);
    CHECK(tree.level(tree.n_levels() - 1).size() == 1);
    std::size_t span = 1;  // leaves a node
    for (std::size_t l = 0; l < tree.n_levels(); ++l, span *= 8) {
        const std::size_t n_nodes = (tree.n_leaves() + span - 1) / span;
        for (std::size_t node = 0; node < 8 * tree.level(l).size(); ++node) {
            const EightBalls& balls = tree.level(l)[node / 8];
            const std::size_t i = node % 8;
            if (node >= n_nodes) {
                CHECK(balls.radius[i] < -1.0e20F);
                continue;
            }
            const Vector3 centre(balls.x[i], balls.y[i], balls.z[i]);
            double farthest = 0.0;
            for (std::size_t leaf = node * span;
                 leaf < std::min(tree.n_leaves(), (node + 1) * span); ++leaf) {
                for (std::size_t j = 0; j < tree.count_in(0, leaf); ++j) {
                    farthest =
                        std::max(farthest, (place_in(tree.points(0, leaf), j) - centre).norm());
                }
            }
            CHECK(farthest <= static_cast<double>(balls.radius[i]));
            CHECK(farthest > 0.99 * static_cast<double>(balls.radius[i]));
        }
    }
}

TEST_CASE("shell tree: leaves are small patches of the surface") {
    const ShellTree tree = ShellTree::build(make_shell(32768)).value();
    double sum_m = 0.0;
    for (const EightBalls& balls : tree.level(0)) {
        for (const float radius : balls.radius) {
            sum_m += static_cast<double>(radius);
        }
    }
    // A disc of a 1024th of a sphere has a radius of a 16th.
    CHECK(sum_m / static_cast<double>(tree.n_leaves()) < 1.6 / 16.0);
}

TEST_CASE("shell tree: thinned out, a leaf's points are of the leaves it stands for") {
    const ShellTree tree = ShellTree::build(make_shell(5000)).value();
    for (std::size_t m = 1; m < tree.n_thinnings(); ++m) {
        std::size_t n = 0;
        for (std::size_t leaf = 0; n < (tree.n_points() + (1U << m) - 1) >> m; ++leaf) {
            const ShellPoints points = tree.points(m, leaf);
            const std::size_t count = tree.count_in(m, leaf);
            for (std::size_t i = 0; i < count; ++i) {
                const std::size_t first = (leaf * kLeafPoints + i) << m;
                bool found = false;
                for (std::size_t slot = first; slot < std::min(tree.n_points(), first + (1UL << m));
                     ++slot) {
                    const ShellPoints from = tree.points(0, slot / kLeafPoints);
                    found = found || place_in(from, slot % kLeafPoints) == place_in(points, i);
                }
                REQUIRE(found);
            }
            n += count;
        }
        CHECK(n == (tree.n_points() + (1U << m) - 1) >> m);
    }
}

TEST_CASE("shell tree: a shell without points or with none that are numbers is refused") {
    CHECK_FALSE(ShellTree::build({}));
    Pointshell shell = make_shell(40);
    shell.y_m[17] = std::numeric_limits<float>::quiet_NaN();
    CHECK(test::is_refused(ShellTree::build(shell), "point 17"));
}
