#include "haptics/voxel/shape_fit.h"

#include "haptics/dynamics/mesh_inertia.h"
#include "haptics/voxel/voxelise.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/field_parts.h"
#include "tests/support/hard_meshes.h"

#include <catch2/catch.hpp>

#include <array>
#include <vector>

using namespace fulcrum;

namespace {

// Closed, open, of loose and turned triangles, crossing itself, thin, far away.
std::vector<TriangleMesh> list_meshes() {
    const TriangleMesh ball = *make_sphere(1.0, 12);
    return {ball,
            test::take_away(ball, [](const Vector3& middle) { return middle.y() > 0.7; }),
            *make_messy(ball, 0.0),
            *make_heap(40, 2),
            *make_box({1.0, 0.02, 1.0}),
            test::shift(*make_box({0.3, 0.2, 0.1}), {700.0, -50.0, 3.0}),
            *make_hollow(*make_box({1.0, 1.0, 1.0}), *make_box({0.5, 0.5, 0.5}))};
}

VoxelGrid voxels_of(const TriangleMesh& mesh, int offset_layers = 1) {
    return voxelise(mesh, {.voxel_m = compute_voxel_m(mesh, 24), .offset_layers = offset_layers})
        .value();
}

DistanceField field_of(const TriangleMesh& mesh, double sheet_voxels = 0.0) {
    return test::build_field(mesh, 32, {.band_voxels = 4.0, .sheet_voxels = sheet_voxels});
}

}  // namespace

TEST_CASE("shape fit: what is made of a mesh can be that of it, whatever the mesh") {
    for (const TriangleMesh& mesh : list_meshes()) {
        CAPTURE(mesh.triangles().size(), mesh.lower_B().x());
        CHECK(can_be_of(field_of(mesh), mesh));
        CHECK(can_be_of(field_of(mesh, 2.0), mesh));
        for (const int layers : {0, 1, 3}) {
            CHECK(can_be_of(voxels_of(mesh, layers), mesh));
        }
        for (const int n_points : {1, 2, 1000}) {
            CHECK(can_be_of(make_surface_pointshell(mesh, n_points).value(), mesh));
        }
        if (const auto solid = measure_solid(mesh)) {
            CHECK(can_be_of(*solid, mesh));
        }
    }
}

TEST_CASE("shape fit: what is made of another mesh cannot, where its size or its place tells") {
    const TriangleMesh ball = *make_sphere(1.0, 12);
    for (const TriangleMesh& other :
         {*make_sphere(0.7, 12), *make_sphere(1.4, 12), test::shift(ball, {0.4, 0.0, 0.0})}) {
        CHECK_FALSE(can_be_of(field_of(other), ball));
        CHECK_FALSE(can_be_of(field_of(other, 2.0), ball));
        CHECK_FALSE(can_be_of(*measure_solid(other), ball));
    }
    CHECK_FALSE(can_be_of(voxels_of(*make_sphere(0.7, 12)), ball));
    CHECK_FALSE(can_be_of(make_surface_pointshell(*make_sphere(1.4, 12), 500).value(), ball));
}

TEST_CASE("shape fit: voxels that nothing can be felt of, and a rim that is not free, do not fit") {
    const TriangleMesh ball = *make_sphere(1.0, 12);
    const VoxelGrid good = voxels_of(ball);
    REQUIRE(can_be_of(good, ball));
    VoxelGrid silent = good;
    for (VoxelClass& kind : silent.cells) {
        kind = kind == VoxelClass::surface ? VoxelClass::interior : kind;
    }
    CHECK_FALSE(can_be_of(silent, ball));
    for (const VoxelFrame::Cell& cell :
         {VoxelFrame::Cell{0, 5, 7},
          VoxelFrame::Cell{good.frame.n_cells[0] - 1, good.frame.n_cells[1] - 1, 9}}) {
        VoxelGrid rim = good;
        rim.cells[rim.index_of(cell)] = VoxelClass::surface;
        CHECK_FALSE(can_be_of(rim, ball));
    }
    VoxelGrid gone = good;
    std::fill(gone.cells.begin(), gone.cells.end(), VoxelClass::free);
    gone.cells[gone.index_of({7, 7, 7})] = VoxelClass::surface;
    CHECK_FALSE(can_be_of(gone, ball));
}

TEST_CASE("shape fit: points outside the mesh's box, or all in one place, do not fit") {
    const TriangleMesh ball = *make_sphere(1.0, 12);
    Pointshell shell = make_surface_pointshell(ball, 200).value();
    shell.y_m[77] = 1.1F;
    CHECK_FALSE(can_be_of(shell, ball));
    Pointshell heap;
    for (int i = 0; i < 200; ++i) {
        heap.add({0.1, 0.2, 0.3}, Vector3::UnitX());
    }
    CHECK_FALSE(can_be_of(heap, ball));
}

TEST_CASE("shape fit: moments that no solid in the mesh's box can have do not fit") {
    const TriangleMesh ball = *make_sphere(1.0, 12);
    for (const TriangleMesh& mesh : {ball, *make_messy(ball, 0.0)}) {
        const MeasuredSolid good = measure_solid(mesh).value();
        REQUIRE(can_be_of(good, mesh));
        const auto fits = [&](auto change) {
            MeasuredSolid changed = good;
            change(changed.moments);
            return can_be_of(changed, mesh);
        };
        CHECK(fits([](SolidMoments&) {}));
        CHECK_FALSE(fits([](SolidMoments& m) { m.volume_m3 *= 4.0; }));
        CHECK_FALSE(fits([](SolidMoments& m) { m.volume_m3 = 1.0e-9; }));
        CHECK_FALSE(fits([](SolidMoments& m) { m.centre_B.z() = 1.5; }));
        CHECK_FALSE(fits([](SolidMoments& m) { m.second_m5 *= 100.0; }));
        CHECK_FALSE(fits([](SolidMoments& m) { m.second_m5(1, 1) = 1.0e-6; }));
    }
}
