#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/voxel/pointshell.h"
#include "haptics/voxel/shell_tree.h"
#include "haptics/voxel/voxel_frame.h"
#include "haptics/voxel/voxelise.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using fulcrum::Vector3;
using fulcrum::VoxelFrame;
using namespace fulcrum;

namespace {

VoxelFrame make_frame() {
    VoxelFrame frame;
    frame.lower_O = {-1.0, 2.0, 0.5};
    frame.voxel_m = 0.25;
    frame.n_cells = {4, 8, 2};
    return frame;
}

constexpr double kRadius_m = 0.05;
constexpr double kPi = 3.14159265358979;

// The greatest distance from any of many places on the ball to its nearest point.
double find_widest_gap_m(const Pointshell& shell) {
    double widest_m = 0.0;
    const int n = 2000;
    for (int i = 0; i < n; ++i) {
        // Places on a spiral, evenly spread.
        const double z = 1.0 - (2.0 * i + 1.0) / n;
        const double turn = 2.39996322972865332 * i;
        const double r = std::sqrt(1.0 - z * z);
        const Vector3 place = kRadius_m * Vector3(r * std::cos(turn), r * std::sin(turn), z);
        double nearest_m = 1.0;
        for (std::size_t k = 0; k < shell.size(); ++k) {
            nearest_m = std::min(nearest_m, (shell.position_T(k) - place).norm());
        }
        widest_m = std::max(widest_m, nearest_m);
    }
    return widest_m;
}

Pointshell make_shell(int n_points) {
    return make_surface_pointshell(*make_bumpy_sphere(1.0, 12, 0.1, 6.0), n_points).value();
}

Vector3 place_in(const ShellPoints& points, std::size_t i) {
    return {points.x[i], points.y[i], points.z[i]};
}

}  // namespace

TEST_CASE(
    "voxel frame: a centre's cell is the cell itself, from lattice 0 to its number of cells") {
    const VoxelFrame frame = make_frame();
    for (std::int32_t x = -2; x < 6; ++x) {
        for (std::int32_t y = -2; y < 10; ++y) {
            for (std::int32_t z = -2; z < 4; ++z) {
                const VoxelFrame::Cell cell{x, y, z};
                REQUIRE(frame.find_cell(frame.centre_of(cell)) == cell);
                const bool inside = x >= 0 && x < 4 && y >= 0 && y < 8 && z >= 0 && z < 2;
                REQUIRE(frame.contains(cell) == inside);
            }
        }
    }
    CHECK(frame.to_lattice(frame.lower_O) == Vector3(0.0, 0.0, 0.0));
    CHECK(frame.to_lattice(frame.upper_O()) == Vector3(4.0, 8.0, 2.0));
    CHECK(frame.find_cell(frame.lower_O) == VoxelFrame::Cell{0, 0, 0});
    CHECK_FALSE(frame.contains(frame.find_cell(frame.upper_O())));
    CHECK(frame.find_cell(Vector3(-1.01, 2.0, 0.5)) == VoxelFrame::Cell{-1, 0, 0});
}

TEST_CASE("pointshell from voxels: the centres of the surface voxels, normals inwards") {
    const auto mesh = make_sphere(kRadius_m, 16).value();
    const double voxel_m = 0.004;
    const Pointshell shell = make_voxel_pointshell(mesh, voxel_m).value();
    const VoxelGrid grid = voxelise(mesh, {.voxel_m = voxel_m, .proximity_layers = 0}).value();
    CHECK(static_cast<std::ptrdiff_t>(shell.size()) ==
          std::count(grid.cells.begin(), grid.cells.end(), VoxelClass::surface));
    for (std::size_t i = 0; i < shell.size(); ++i) {
        const Vector3 p = shell.position_T(i);
        REQUIRE(grid.find_class(grid.frame.find_cell(p)) == VoxelClass::surface);
        REQUIRE((p - grid.frame.centre_of(grid.frame.find_cell(p))).norm() < 1.0e-8);
        REQUIRE(shell.normal_T(i).norm() == Approx(1.0).epsilon(1.0e-6));
        // A triangle's normal turns by its size, a voxel's mean by its diagonal.
        REQUIRE(shell.normal_T(i).dot(-p.normalized()) > std::cos(0.12));
    }
}

TEST_CASE("pointshell from voxels: a flat face's normals are its own, a thin plate's of one side") {
    const Pointshell box = make_voxel_pointshell(make_box({1.0, 1.0, 1.0}).value(), 0.07).value();
    int n_top = 0;
    for (std::size_t i = 0; i < box.size(); ++i) {
        const Vector3 p = box.position_T(i);
        if (p.y() > 0.45 && std::abs(p.x()) < 0.4 && std::abs(p.z()) < 0.4) {
            REQUIRE((box.normal_T(i) + Vector3::UnitY()).norm() < 1.0e-6);
            ++n_top;
        }
    }
    CHECK(n_top > 100);
    // Both sides of the plate lie in the same voxels and cancel.
    const Pointshell plate =
        make_voxel_pointshell(make_box({1.0, 1.0e-9, 1.0}).value(), 0.1).value();
    for (std::size_t i = 0; i < plate.size(); ++i) {
        REQUIRE(plate.normal_T(i).norm() == Approx(1.0).epsilon(1.0e-6));
    }
}

TEST_CASE("pointshell on the mesh: as many points as asked for, on the surface, normals inwards") {
    const auto mesh = make_box({0.2, 0.1, 0.3}).value();
    for (const int n : {1, 2, 13, 1000}) {
        const Pointshell shell = make_surface_pointshell(mesh, n).value();
        REQUIRE(shell.size() == static_cast<std::size_t>(n));
        for (std::size_t i = 0; i < shell.size(); ++i) {
            const Vector3 share =
                shell.position_T(i).cwiseAbs().cwiseQuotient(Vector3(0.1, 0.05, 0.15));
            Index face = 0;
            REQUIRE(share.maxCoeff(&face) == Approx(1.0).epsilon(1.0e-6));
            REQUIRE(shell.normal_T(i)[face] * shell.position_T(i)[face] < 0.0);
            REQUIRE(std::abs(shell.normal_T(i)[face]) == Approx(1.0).epsilon(1.0e-6));
        }
    }
}

TEST_CASE("pointshell on the mesh: each face has its share of the points") {
    const Pointshell shell =
        make_surface_pointshell(make_box({0.2, 0.1, 0.3}).value(), 11000).value();
    // Areas .03, .06, .02 of each of two sides: 0.22 in all.
    int on_x = 0;
    int on_y = 0;
    int on_z = 0;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        on_x += std::abs(shell.nx[i]) > 0.5F ? 1 : 0;
        on_y += std::abs(shell.ny[i]) > 0.5F ? 1 : 0;
        on_z += std::abs(shell.nz[i]) > 0.5F ? 1 : 0;
    }
    CHECK(on_x == Approx(3000).margin(4));
    CHECK(on_y == Approx(6000).margin(4));
    CHECK(on_z == Approx(2000).margin(4));
}

TEST_CASE(
    "pointshell on the mesh: evenly spread over few large triangles and over many small ones") {
    const int n = 1000;
    // A disc of a point's share of the area has this radius; a square lattice's widest gap is 1.25 of it.
    const double share_m = 2.0 * kRadius_m / std::sqrt(static_cast<double>(n));
    for (const int frequency : {2, 64}) {
        const auto mesh = make_sphere(kRadius_m, frequency).value();
        const Pointshell shell = make_surface_pointshell(mesh, n).value();
        // The coarse sphere's faces lie up to 12 % below the places asked about.
        const double beside_m = frequency == 2 ? 0.12 * kRadius_m : 0.0;
        CHECK(find_widest_gap_m(shell) < 2.6 * share_m + beside_m);
    }
}

TEST_CASE("pointshell: the same each time, and neighbours in the list are neighbours in space") {
    const auto mesh = make_sphere(kRadius_m, 32).value();
    const Pointshell shell = make_surface_pointshell(mesh, 4096).value();
    const Pointshell again = make_surface_pointshell(mesh, 4096).value();
    CHECK(shell.x_m == again.x_m);
    CHECK(shell.nz == again.nz);
    double sum_m = 0.0;
    for (std::size_t i = 1; i < shell.size(); ++i) {
        sum_m += (shell.position_T(i) - shell.position_T(i - 1)).norm();
    }
    // Spaced by 2 R sqrt(pi / n) where points lie as evenly as can be.
    CHECK(sum_m / 4095.0 < 2.5 * 2.0 * kRadius_m * std::sqrt(kPi / 4096.0));
}

TEST_CASE("pointshell: seen from another frame") {
    const Pointshell shell = make_surface_pointshell(make_box({0.2, 0.1, 0.3}).value(), 50).value();
    const Pose X_NT{{0.3, -0.2, 0.1}, compute_exp({0.4, 0.5, -0.6})};
    const Pointshell moved = make_moved(shell, X_NT);
    for (std::size_t i = 0; i < shell.size(); ++i) {
        REQUIRE((moved.position_T(i) - X_NT * shell.position_T(i)).norm() < 1.0e-7);
        REQUIRE((moved.normal_T(i) - X_NT.orientation * shell.normal_T(i)).norm() < 1.0e-6);
    }
}

TEST_CASE("pointshell: counts and voxels out of range are refused") {
    const auto mesh = make_box({0.2, 0.1, 0.3}).value();
    CHECK_FALSE(make_surface_pointshell(mesh, 0));
    CHECK_FALSE(make_surface_pointshell(mesh, -5));
    CHECK_FALSE(make_surface_pointshell(mesh, kMostShellPoints + 1));
    CHECK_FALSE(make_voxel_pointshell(mesh, 0.0));
    CHECK_FALSE(make_voxel_pointshell(mesh, 0.0001));
}

TEST_CASE("pointshell on the mesh: it tells how far it has come, and stops where it is told to") {
    const TriangleMesh mesh = *make_sphere(kRadius_m, 20);
    constexpr int kPoints = 100000;
    std::vector<double> told;
    const auto whole = make_surface_pointshell(mesh, kPoints, [&](double share) {
        told.push_back(share);
        return true;
    });
    REQUIRE(whole);
    CHECK(whole->x_m == make_surface_pointshell(mesh, kPoints)->x_m);
    CHECK(std::is_sorted(told.begin(), told.end()));
    CHECK(told.size() > 20);
    CHECK(told.back() == 1.0);
    for (const double most : {0.0, 0.4, 0.9}) {
        double last = 0.0;
        const auto stopped = make_surface_pointshell(mesh, kPoints, [&](double share) {
            last = share;
            return share <= most;
        });
        REQUIRE_FALSE(stopped);
        CHECK(last > most);
        CHECK(stopped.error().message == "the points were stopped before they were made");
    }
}

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
    CHECK(is_refused(ShellTree::build(shell), "point 17"));
}
