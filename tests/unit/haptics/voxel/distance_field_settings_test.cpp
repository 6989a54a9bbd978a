#include "tests/support/edited_meshes.h"
#include "tests/support/field_parts.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;
using test::build_field;

TEST_CASE("distance field settings: the frame holds the mesh with its band, for all shapes") {
    for (const Vector3& edges : {Vector3(1.0, 1.0, 1.0), Vector3(3.0, 0.1, 0.7)}) {
        const TriangleMesh box = *make_box(edges);
        const VoxelFrame frame = DistanceField::make_frame(box, 80).value();
        CHECK(*std::max_element(frame.n_cells.begin(), frame.n_cells.end()) == 80);
        for (const std::int32_t n : frame.n_cells) {
            CHECK(n % 8 == 0);
        }
        CHECK(DistanceField::build(box, frame).has_value());
    }
}

TEST_CASE("distance field settings: what cannot be built is refused with a reason") {
    const TriangleMesh ball = *make_sphere(1.0, 4);
    const VoxelFrame good = DistanceField::make_frame(ball, 64).value();
    CHECK_FALSE(DistanceField::make_frame(ball, 60));
    CHECK_FALSE(DistanceField::make_frame(ball, 8));
    CHECK_FALSE(DistanceField::make_frame(ball, 4096));
    CHECK_FALSE(DistanceField::make_frame(ball, 16, 8.0));

    VoxelFrame odd = good;
    odd.n_cells[1] = 63;
    CHECK_FALSE(DistanceField::build(ball, odd));
    VoxelFrame flat = good;
    flat.voxel_m = 0.0;
    CHECK_FALSE(DistanceField::build(ball, flat));
    VoxelFrame aside = good;
    aside.lower_O.x() += 4.0 * good.voxel_m;
    CHECK(
        test::is_refused(DistanceField::build(ball, aside), "from the mesh; take a larger block"));

    test::check_refused(
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

TEST_CASE("distance field settings: who loads a mesh with holes is told what they lead to") {
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
