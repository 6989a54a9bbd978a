#include "haptics/voxel/pointshell.h"

#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/voxel/voxelise.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace fulcrum;

namespace {

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

}  // namespace

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
