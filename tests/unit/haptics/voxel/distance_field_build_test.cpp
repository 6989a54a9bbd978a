#include "tests/support/edited_meshes.h"
#include "tests/support/field_parts.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/refused.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using test::build_field;

namespace {

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

TEST_CASE(
    "distance field build: the same bits on one thread and on several, and progress is told") {
    const TriangleMesh mesh = *make_bumpy_sphere(1.0, 30, 0.05, 12.0);
    const VoxelFrame frame = DistanceField::make_frame(mesh, 256).value();
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
    const VoxelFrame frame = DistanceField::make_frame(mesh, 128).value();
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

TEST_CASE("distance field build: what would take minutes is refused, with voxels that do") {
    const TriangleMesh heap = *make_heap(4000, 1);
    const VoxelFrame frame = DistanceField::make_frame(heap, 256).value();
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
}

TEST_CASE("distance field build: memory is that of the surface, not of the block") {
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
