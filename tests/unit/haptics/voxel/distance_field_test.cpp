#include "haptics/voxel/distance_field.h"

#include "haptics/base/processor.h"
#include "haptics/voxel/distance_field_batch.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/field_parts.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/refused.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;
using test::build_field;

namespace {

struct Fixture {
    TriangleMesh mesh;
    TriangleClusters clusters;
    DistanceField field;
};

Fixture make(const TriangleMesh& mesh, int n_along) {
    return {mesh, TriangleClusters(mesh), test::build_field(mesh, n_along)};
}

const Fixture& bumpy() {
    static const Fixture kBumpy = make(*make_bumpy_sphere(1.0, 16, 0.05, 12.0), 64);
    return kBumpy;
}

bool is_same(const DistanceField& a, const DistanceField& b) {
    const auto same_entry = [](const DistanceField::Entry& x, const DistanceField::Entry& y) {
        return x.brick == y.brick && x.centre_voxels == y.centre_voxels;
    };
    const auto same_brick = [](const DistanceField::Brick& x, const DistanceField::Brick& y) {
        return x.values == y.values;
    };
    return std::equal(a.table().begin(), a.table().end(), b.table().begin(), b.table().end(),
                      same_entry) &&
           std::equal(a.bricks().begin(), a.bricks().end(), b.bricks().begin(), b.bricks().end(),
                      same_brick);
}

}  // namespace

TEST_CASE("distance field: a ball's is its closed form within the bound of spheres") {
    // So fine a mesh lies within 2e-5 of the sphere.
    const Fixture ball = make(*make_sphere(1.0, 120), 128);
    const DistanceField& field = ball.field;
    const double s = field.frame().voxel_m;
    constexpr double kFacets_m = 4.0e-5;
    Random random(1);
    for (int i = 0; i < 5000; ++i) {
        const double r = 1.0 + 1.25 * s * random.uniform();  // all corners within the band
        const Vector3 n = random.direction();
        const DistanceSample sample = field.sample(r * n);
        const double bound = s * s / (4.0 * (r - s)) + 0.5 * field.step_m() + kFacets_m;
        CHECK(std::abs(sample.value_m - (r - 1.0)) < bound);
        // A slope of a trilinear cell is off by the bend over it.
        CHECK((sample.slope - n).norm() < 2.0 * s + 2.0 * kFacets_m / s);
    }
}

TEST_CASE("distance field: a box's is its closed form on all sides, to the steps of 16 bits") {
    const Fixture box = make(*make_box({1.0, 0.6, 0.8}), 64);
    const double s = box.field.frame().voxel_m;
    Random random(2);
    for (int i = 0; i < 3000; ++i) {
        // Over the middle of a face the field is linear.
        const Vector3 p(0.3 * random.uniform(), 0.3 + 1.9 * s * random.uniform(),
                        0.2 * random.uniform());
        const DistanceSample sample = box.field.sample(p);
        CHECK(std::abs(sample.value_m - (p.y() - 0.3)) < box.field.step_m());
        CHECK((sample.slope - Vector3::UnitY()).norm() < 1.0e-3);
    }
    CHECK(box.field.sample(Vector3::Zero()).value_m == Approx(-box.field.band_m()));
    CHECK(box.field.sample(Vector3::Zero()).slope.norm() == 0.0);
}

TEST_CASE("distance field: within the stated error of brute force, on a bumpy mesh") {
    const auto& [mesh, clusters, field] = bumpy();
    Random random(3);
    for (int i = 0; i < 5000; ++i) {
        const Vector3 p = (1.0 + 0.1 * random.uniform()) * random.direction();
        const double exact = clusters.find_distance(p);
        const double value = std::abs(field.sample(p).value_m);
        if (exact < field.band_m() - field.error_bound_m()) {
            CHECK(std::abs(value - exact) < field.error_bound_m());
        } else {
            CHECK(value > exact - field.error_bound_m() - 0.06);
        }
    }
}

TEST_CASE("distance field: continuous, and nowhere steeper than its slope bound") {
    const DistanceField& field = bumpy().field;
    CHECK(field.slope_bound() >= 1.0);
    CHECK(field.slope_bound() < 1.74);
    Random random(4);
    const double s = field.frame().voxel_m;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 p = (1.0 + 0.2 * random.uniform()) * random.direction();
        const Vector3 q =
            p + std::pow(10.0, -3.0 + 3.0 * random.uniform()) * s * random.direction();
        const double change = std::abs(field.sample(p).value_m - field.sample(q).value_m);
        CHECK(change <= field.slope_bound() * (p - q).norm() + 1.0e-12);
    }
}

TEST_CASE("distance field: its slope is the derivative of its value") {
    const DistanceField& field = bumpy().field;
    const double s = field.frame().voxel_m;
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const Vector3 lattice =
            field.frame().to_lattice((1.0 + 0.05 * random.uniform()) * random.direction());
        // Within a cell, so that no face is crossed.
        const Vector3 p =
            field.frame().lower_O +
            s * (lattice.cwiseFloor() + Vector3::Constant(0.5 + 0.4 * random.uniform()));
        for (int axis = 0; axis < 3; ++axis) {
            const Vector3 step = 1.0e-3 * s * Vector3::Unit(axis);
            const double slope =
                (field.sample(p + step).value_m - field.sample(p - step).value_m) / (2.0e-3 * s);
            CHECK(slope == Approx(field.sample(p).slope[axis]).margin(1.0e-9));
        }
    }
}

TEST_CASE(
    "distance field: bounds are below the distance, near, far, inside and outside the block") {
    const auto& [mesh, clusters, field] = bumpy();
    Random random(6);
    for (int i = 0; i < 3000; ++i) {
        const Vector3 p = 4.0 * std::abs(random.uniform()) * random.in_cube();
        const double exact = clusters.find_distance(p);
        const double bound = field.bound_distance_m(p);
        CHECK(std::abs(bound) <= exact);
        if (bound != 0.0 && std::abs(p.norm() - 1.0) > 0.06) {
            CHECK((bound < 0.0) == (p.norm() < 1.0));
        }
        // Far off it is known to a few parts in a hundred and a brick.
        CHECK(std::abs(bound) > 0.9 * exact - 14.0 * field.frame().voxel_m);
    }
}

TEST_CASE("distance field: everything within the free radius is free") {
    const DistanceField& field = bumpy().field;
    Random random(7);
    int n_free = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 p = (1.2 + 0.4 * random.uniform()) * random.direction();
        const double radius = field.find_free_radius_m(p);
        if (radius > 0.0) {
            ++n_free;
            CHECK(field.sample(p + radius * random.direction()).value_m > 0.0);
        }
        CHECK((radius == 0.0 || field.sample(p).value_m > 0.0));
    }
    CHECK(n_free > 10000);
    CHECK(field.find_free_radius_m(Vector3::Zero()) == 0.0);
}

TEST_CASE("distance field: deeper than the band the depth goes on, and the way out with it") {
    // 120 voxels along each edge, so that there is much that is deeper than 3.
    const Fixture box = make(*make_box({1.0, 1.0, 1.0}), 128);
    const double s = box.field.frame().voxel_m;
    Random random(12);
    double deepest_voxels = 0.0;
    for (int i = 0; i < 3000; ++i) {
        const Vector3 p = 0.5 * random.in_cube();
        // Depths by face, largest coordinate first; where two are within 16 voxels the coarse depth is flatter.
        Vector3 beside = p.cwiseAbs();
        int axis = 0;
        beside.maxCoeff(&axis);
        const double depth_m = 0.5 - beside[axis];
        beside[axis] = 0.0;
        const DepthSample sample = box.field.sample_depth(p);
        CHECK(sample.depth_m <= depth_m + 0.01 * s);
        if (0.5 - beside.maxCoeff() - depth_m > 16.0 * s && depth_m > 0.01 * s) {
            const Vector3 out = (p[axis] > 0.0 ? 1.0 : -1.0) * Vector3::Unit(axis);
            // Centres outside are known to 3 % of some voxels.
            CHECK(sample.depth_m == Approx(depth_m).margin(0.1 * s));
            CHECK((sample.way_out - out).norm() < 0.03);
            deepest_voxels = std::max(deepest_voxels, depth_m / s);
        }
    }
    CHECK(deepest_voxels > 30.0);
    CHECK(box.field.sample_depth({0.6, 0.0, 0.0}).depth_m == 0.0);
    CHECK(box.field.sample_depth({0.6, 0.0, 0.0}).way_out == Vector3::Zero());
}

TEST_CASE("distance field: the way out is the depth's slope, and the depth is continuous") {
    const Fixture& ball = bumpy();
    const double s = ball.field.frame().voxel_m;
    Random random(13);
    constexpr double kWay_m = 1.0e-6;
    int n_deep = 0;
    int n_off = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 p = 1.05 * random.in_cube();
        const Vector3 way = kWay_m * random.direction();
        const DepthSample here = ball.field.sample_depth(p);
        const DepthSample there = ball.field.sample_depth(p + way);
        const double change_m = there.depth_m - here.depth_m;
        // The band's last quarter is the steepest: 1 + 4 K/b, and K is small there but between close walls.
        CHECK(std::abs(change_m) < 4.0 * kWay_m);
        if (here.depth_m > 0.0 && there.depth_m > 0.0) {
            // Off only where a face between cells lies between both.
            n_off += std::abs(change_m + here.way_out.dot(way)) > 1.0e-2 * kWay_m ? 1 : 0;
            n_deep += here.depth_m > 4.0 * s ? 1 : 0;
        }
    }
    CHECK(n_deep > 3000);
    CHECK(n_off < 20);
}

TEST_CASE("distance field: what is thinner than a brick, or one brick long, has its depths too") {
    const Fixture thin = make(*make_box({1.0, 0.02, 0.3}), 64);
    for (const double y : {0.0, 0.004, 0.009}) {
        CHECK(thin.field.sample_depth({0.1, y, 0.0}).depth_m ==
              -thin.field.sample({0.1, y, 0.0}).value_m);
    }
}

TEST_CASE("distance field settings: the frame holds mesh and band; what holes lead to is told") {
    for (const Vector3& edges : {Vector3(1.0, 1.0, 1.0), Vector3(3.0, 0.1, 0.7)}) {
        const TriangleMesh box = *make_box(edges);
        const VoxelFrame frame = make_field_frame(box, 80).value();
        CHECK(*std::max_element(frame.n_cells.begin(), frame.n_cells.end()) == 80);
        for (const std::int32_t n : frame.n_cells) {
            CHECK(n % 8 == 0);
        }
        CHECK(DistanceField::build(box, frame).has_value());
    }
    const TriangleMesh ball = *make_sphere(1.0, 4);
    CHECK_FALSE(build_field(ball, 32).tell_holes());
    const TriangleMesh open = test::take_first(ball, -1);
    const auto told = build_field(open, 32).tell_holes();
    REQUIRE(told);
    CHECK(to_sentence(*told) ==
          "the mesh has 3 open edges: its holes are felt as if skins closed them, and a tool that "
          "looks only at what is near may pass through these; close the holes, or build the field "
          "as a sheet (sheet_voxels).");
    CHECK_FALSE(build_field(open, 32, {.sheet_voxels = 2.0}).tell_holes());
}

TEST_CASE("distance field settings: what cannot be built is refused with a reason") {
    const TriangleMesh ball = *make_sphere(1.0, 4);
    const VoxelFrame good = make_field_frame(ball, 64).value();
    CHECK_FALSE(make_field_frame(ball, 60));
    CHECK_FALSE(make_field_frame(ball, 8));
    CHECK_FALSE(make_field_frame(ball, 4096));
    CHECK_FALSE(make_field_frame(ball, 16, 8.0));

    VoxelFrame odd = good;
    odd.n_cells[1] = 63;
    CHECK_FALSE(DistanceField::build(ball, odd));
    VoxelFrame flat = good;
    flat.voxel_m = 0.0;
    CHECK_FALSE(DistanceField::build(ball, flat));
    VoxelFrame aside = good;
    aside.lower_O.x() += 4.0 * good.voxel_m;
    CHECK(is_refused(DistanceField::build(ball, aside), "from the mesh; take a larger block"));

    check_refused(
        DistanceFieldSettings{},
        {[](auto& s) { s.band_voxels = 1.0; }, [](auto& s) { s.band_voxels = std::nan(""); },
         [](auto& s) { s.n_threads = 0; }, [](auto& s) { s.sheet_voxels = 0.5; },
         [](auto& s) { s.sheet_voxels = 3.5; },  // more than the band
         [](auto& s) { s.sheet_voxels = std::nan(""); }});
    CHECK(validate(DistanceFieldSettings{.sheet_voxels = 3.0}));
    // A sheet is that much larger than its mesh.
    CHECK_FALSE(DistanceField::build(ball, good, {.sheet_voxels = 2.0}));
    CHECK(build_field(ball, 64, {.sheet_voxels = 2.0}).sheet_m() > 0.0);
    CHECK_FALSE(DistanceField::build(ball, good, {.n_threads = 0}));
}

TEST_CASE(
    "distance field build: the same bits on one thread and on several, and progress is told") {
    const TriangleMesh mesh = *make_bumpy_sphere(1.0, 30, 0.05, 12.0);
    const VoxelFrame frame = make_field_frame(mesh, 256).value();
    double told = 0.0;
    const DistanceField one =
        DistanceField::build(mesh, frame, {.n_threads = 1}, [&](double share) {
            CHECK(share >= told);
            told = share;
            return true;
        }).value();
    CHECK(told == 1.0);
    CHECK(is_same(one, DistanceField::build(mesh, frame, {.n_threads = 3}).value()));
}

TEST_CASE("distance field build: it stops at whatever share it is told to, and says so") {
    const TriangleMesh mesh = *make_sphere(1.0, 20);
    const VoxelFrame frame = make_field_frame(mesh, 128).value();
    for (const double most : {0.0, 0.5}) {
        double told = 0.0;
        const auto stopped = DistanceField::build(mesh, frame, {}, [&](double share) {
            told = share;
            return share < most;
        });
        REQUIRE_FALSE(stopped);
        CHECK(told >= most);
        CHECK(told < 1.0);
        CHECK(stopped.error().message.find("stopped") != std::string::npos);
    }
}

TEST_CASE("distance field build: what takes minutes is refused, memory is that of the surface") {
    const TriangleMesh heap = *make_heap(4000, 1);
    const VoxelFrame frame = make_field_frame(heap, 256).value();
    const auto refused = DistanceField::build(heap, frame);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message ==
          "its 4000 triangles cross each other, or are open, so much that to find its inside would "
          "take minutes");
    // What is said is more than the voxel that was tried, and a few hundred of such triangles are made.
    const std::string& advice = refused.error().what_to_do;
    const double voxel_m = std::stod(advice.substr(advice.find("voxels") + 7));
    CHECK(voxel_m > 2.0 * frame.voxel_m);
    CHECK(voxel_m < 64.0 * frame.voxel_m);
    CHECK(build_field(*make_heap(100, 1), 32).counts().n_open_edges == 300);
    const DistanceField field = build_field(*make_sphere(1.0, 20), 128);
    CHECK(field.counts().n_open_edges == 0);
    CHECK(field.counts().n_bricks < 16 * 16 * 16 / 2);
    CHECK(field.memory_bytes() < 2UL * 3 * 128 * 128 * 128 / 5);
    CHECK(field.bricks().size() == static_cast<std::size_t>(field.counts().n_bricks) + 2);
}

TEST_CASE("distance field build: doubled, loose and turned triangles have a ball's inside") {
    const TriangleMesh ball = *make_sphere(1.0, 16);
    const DistanceField field = build_field(make_messy(ball, 0.0).value(), 64);
    CHECK(field.counts().n_open_edges > 0);
    Random random(8);
    for (int i = 0; i < 2000; ++i) {
        const double r = 1.0 + 0.3 * random.uniform();
        const double value = field.sample(r * random.direction()).value_m;
        if (std::abs(r - 1.0) > 0.02) {
            CHECK((value < 0.0) == (r < 1.0));
        }
    }
}

TEST_CASE("distance field build: a thin wall has an inside of its own") {
    const double thickness_m = 0.02;
    const TriangleMesh wall = *make_box({1.0, thickness_m, 1.0});
    const DistanceField field = build_field(wall, 128);
    CHECK(field.frame().voxel_m > 0.4 * thickness_m);
    CHECK(field.sample({0.1, 0.0, 0.2}).value_m < 0.0);
    CHECK(field.sample({0.1, 0.011, 0.2}).value_m > 0.0);
    CHECK(field.sample({0.1, -0.011, 0.2}).value_m > 0.0);
}

TEST_CASE("distance field build: a sheet is |distance| less its half thickness, on both sides") {
    // A hollow ball: as a solid it is full, as a sheet it is a skin.
    const TriangleMesh ball = *make_sphere(1.0, 60);
    const DistanceField sheet = build_field(ball, 64, {.sheet_voxels = 2.0});
    const double s = sheet.frame().voxel_m;
    CHECK(sheet.sheet_m() == Approx(2.0 * s));
    Random random(21);
    for (int i = 0; i < 5000; ++i) {
        const Vector3 p = 1.1 * random.in_cube();
        const double d = std::abs(p.norm() - 1.0) - 2.0 * s;
        const double value = sheet.sample(p).value_m;
        CHECK(std::abs(value - std::min(d, 3.0 * s)) < sheet.error_bound_m() + 2.0e-4);
        // What is said to be free is free, and bounds are bounds.
        CHECK((value <= 0.0 ||
               sheet.sample(p + sheet.find_free_radius_m(p) * random.direction()).value_m > 0.0));
        const double bound = sheet.bound_distance_m(p);
        CHECK((bound >= 0.0 ? bound <= std::max(d, 0.0) + 2.0e-4
                            : bound >= std::min(d, 0.0) - 2.0e-4));
        CHECK(sheet.sample_depth(p).depth_m == Approx(std::max(-value, 0.0)));
    }
}

TEST_CASE("distance field kernels: the widest that the processor has are taken") {
    const auto all = all_field_kernels();
    REQUIRE(all[0] != nullptr);
    CHECK((all[1] != nullptr) == has_avx2());
    CHECK((all[2] != nullptr) == has_avx512());
    CHECK(best_field_kernels().name == name_kernels());
    CHECK(&best_field_kernels() == (has_avx512() ? all[2] : has_avx2() ? all[1] : all[0]));
}
