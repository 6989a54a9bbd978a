#include "haptics/dynamics/mesh_inertia.h"
#include "haptics/voxel/shape_bytes.h"
#include "haptics/voxel/shape_fit.h"
#include "haptics/voxel/voxelise.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/field_parts.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/kept_bytes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace fulcrum;

namespace {

using test::Mended;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

TriangleMesh ball() {
    return make_sphere(1.0, 3).value();
}

Digest key_of(ShapeKind kind) {
    return compute_shape_key(kind, ball(), std::vector<double>{1.0, 2.0});
}

const DistanceField& field() {
    static const DistanceField kField = test::build_field(ball(), 24);
    return kField;
}

const Digest kFieldKey = key_of(ShapeKind::distance_field);
const Digest kGridKey = key_of(ShapeKind::voxel_grid);
const Digest kShellKey = key_of(ShapeKind::pointshell);

bool is_field(std::span<const std::byte> bytes) {
    return decode_distance_field(bytes, kFieldKey).has_value();
}
bool is_grid(std::span<const std::byte> bytes) {
    return decode_voxel_grid(bytes, kGridKey).has_value();
}
bool is_shell(std::span<const std::byte> bytes) {
    return decode_pointshell(bytes, kShellKey).has_value();
}

// A box without one of its triangles: a membrane closes the hole, and F jumps there from one end of the band to the other.
TriangleMesh open_box() {
    return test::take_first(make_box({1.0, 0.7, 0.8}).value(), -1);
}

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

TEST_CASE("shape bytes: a distance field comes back the same in every question") {
    const Bytes bytes = encode(field(), kFieldKey);
    const auto back = decode_distance_field(bytes, kFieldKey);
    REQUIRE(back);
    CHECK(encode(*back, kFieldKey) == bytes);
    CHECK(count_bytes(field()) == bytes.size());
    CHECK(back->slope_bound() == field().slope_bound());
    CHECK(back->counts().n_bricks == field().counts().n_bricks);
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const Vector3 p = 1.6 * random.in_cube();
        REQUIRE(back->sample(p).value_m == field().sample(p).value_m);
        REQUIRE(back->bound_distance_m(p) == field().bound_distance_m(p));
        REQUIRE(back->sample_depth(p).depth_m == field().sample_depth(p).depth_m);
        REQUIRE(back->find_free_radius_m(p) == field().find_free_radius_m(p));
    }
}

TEST_CASE("shape bytes: a frame lies in the bytes axis by axis, and comes back so") {
    const TriangleMesh box = make_box({1.0, 2.0, 3.0}).value();
    VoxelFrame frame = make_field_frame(box, 48, 5.0).value();
    frame.lower_O -= frame.voxel_m * Vector3(0.1, 0.2, 0.3);
    REQUIRE(frame.n_cells[0] < frame.n_cells[1]);
    REQUIRE(frame.n_cells[1] < frame.n_cells[2]);
    const DistanceField made =
        DistanceField::build(box, frame, {.band_voxels = 3.0, .sheet_voxels = 1.25}).value();
    const Bytes bytes = encode(made, kFieldKey);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        CHECK(test::number_at<double>(bytes, test::kPayloadAt + 8 * axis) ==
              frame.lower_O[static_cast<Index>(axis)]);
        CHECK(test::number_at<std::int32_t>(bytes, test::kPayloadAt + 32 + 4 * axis) ==
              frame.n_cells[axis]);
    }
    CHECK(test::number_at<double>(bytes, test::kPayloadAt + 24) == frame.voxel_m);
    const auto back = decode_distance_field(bytes, kFieldKey);
    REQUIRE(back);
    CHECK(back->frame().lower_O == frame.lower_O);
    CHECK(back->frame().voxel_m == frame.voxel_m);
    CHECK(back->frame().n_cells == frame.n_cells);
    CHECK(back->band_m() == 3.0 * frame.voxel_m);
    CHECK(back->sheet_m() == 1.25 * frame.voxel_m);
    CHECK(back->ball_centre_O() == made.ball_centre_O());
    CHECK(back->ball_radius_m() == made.ball_radius_m());
}

TEST_CASE("shape bytes: voxels and pointshells come back the same") {
    const VoxelGrid grid = voxelise(ball(), {.voxel_m = 0.1}).value();
    const Bytes voxels = encode(grid, kGridKey);
    const auto grid_back = decode_voxel_grid(voxels, kGridKey);
    REQUIRE(grid_back);
    CHECK(grid_back->cells == grid.cells);
    CHECK(grid_back->frame.n_cells == grid.frame.n_cells);
    CHECK(grid_back->frame.lower_O == grid.frame.lower_O);
    CHECK(grid_back->frame.voxel_m == grid.frame.voxel_m);
    CHECK(voxels.size() < grid.cells.size());
    CHECK(voxels.size() == count_bytes(grid));
    const Pointshell shell = make_surface_pointshell(ball(), 500).value();
    CHECK(encode(shell, kShellKey).size() == count_bytes(shell));
    const auto shell_back = decode_pointshell(encode(shell, kShellKey), kShellKey);
    REQUIRE(shell_back);
    CHECK(shell_back->x_m == shell.x_m);
    CHECK(shell_back->nz == shell.nz);
}

TEST_CASE("shape bytes: the field of an open mesh comes back as well, and no steeper one") {
    for (const double sheet_voxels : {0.0, 1.5}) {
        const DistanceField made =
            DistanceField::build(open_box(), make_field_frame(open_box(), 48, 5.0).value(),
                                 {.band_voxels = 3.0, .sheet_voxels = sheet_voxels})
                .value();
        REQUIRE(made.counts().n_open_edges == 3);
        CHECK((made.slope_bound() > 2.0) == (sheet_voxels == 0.0));
        const Bytes bytes = encode(made, kFieldKey);
        const auto back = decode_distance_field(bytes, kFieldKey);
        REQUIRE(back);
        CHECK(back->slope_bound() == made.slope_bound());
        // 2 sqrt(3) b / s, with 1 % for 16 bits; without a membrane sqrt(3).
        const double most = (sheet_voxels == 0.0 ? 6.0 : 1.0) * std::sqrt(3.0);
        const Mended mended(bytes, is_field);
        CHECK(mended.takes_at(52, most));
        mended.check_refused_at(52, 1.02 * most);
    }
}

TEST_CASE("shape bytes: what a mesh encloses comes back the same; what no body has is refused") {
    const MeasuredSolid solid{compute_solid_moments(open_box()), true};
    const Digest key = compute_shape_key(ShapeKind::solid_moments, open_box(), {});
    const Bytes bytes = encode(solid, key);
    CHECK(bytes.size() == count_bytes(solid));
    const auto back = decode_measured_solid(bytes, key);
    REQUIRE(back);
    CHECK(back->moments.volume_m3 == solid.moments.volume_m3);
    CHECK(back->moments.centre_B == solid.moments.centre_B);
    CHECK(back->moments.second_m5 == solid.moments.second_m5);
    CHECK(back->by_samples);
    const auto takes = [&](std::span<const std::byte> some) {
        return decode_measured_solid(some, key).has_value();
    };
    const Mended mended(bytes, takes);
    mended.check_refused_at(0, kNan, 0.0, -1.0, 1.0e300);  // volume
    mended.check_refused_at(16, kNan, 1.0e300);
    mended.check_refused_at(32, kNan, -1.0);  // spread by less than nothing along x
    mended.check_refused_at(40, 100.0);       // other by x and y than by y and x
    mended.check_refused_at(104, std::uint8_t{2});
    CHECK(mended.takes_at(104, std::uint8_t{0}));
    test::check_sealed(bytes, takes);
}

TEST_CASE("shape bytes: what is cut off, longer, or changed in any place is refused") {
    const Pointshell shell = make_surface_pointshell(ball(), 3).value();
    const Bytes bytes = encode(shell, kShellKey);
    test::check_sealed(bytes, is_shell);
    // A version, a kind and a key that are not those asked for, with checksums put right.
    CHECK_FALSE(is_shell(test::with_mended(bytes, 8, kShapeVersion + 1)));
    CHECK_FALSE(decode_voxel_grid(bytes, kShellKey));
    const auto refused = decode_pointshell(bytes, kGridKey);
    REQUIRE_FALSE(refused);
    CHECK(to_sentence(refused.error()) ==
          "the kept shape is that of another mesh; it is made again.");
}

TEST_CASE(
    "shape bytes: a distance field that no build makes is refused, its checksum right or not") {
    const Mended mended(encode(field(), kFieldKey), is_field);
    // Frame: lower corner, voxel, cells.
    mended.check_refused_at(24, 0.0, -1.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        mended.check_refused_at(8 * axis, kNan, kInfinity, -1.0e300);
        const std::int32_t n = field().frame().n_cells[axis];
        mended.check_refused_at(32 + 4 * axis, 0, -8, n - 8, n + 1, n + 8, 2147483640);
    }
    // Band, slope, counts, ball, sheet, number of bricks.
    mended.check_refused_at(44, kNan);
    mended.check_refused_at(52, 2.0, 0.0, 0.999, kNan);
    mended.check_refused_at(60, std::int64_t{-1}, field().counts().n_bricks + 1);
    mended.check_refused_at(76, kNan);
    mended.check_refused_at(100, -1.0);
    mended.check_refused_at(108, kNan, 0.4);
    mended.check_refused_at(116, std::uint64_t{1} << 60U, std::uint64_t{1});
    // Entries: a brick that is not there, a distance that is no number or larger than the block.
    mended.check_refused_at(124, -1, 1000000);
    mended.check_refused_at(128, std::numeric_limits<float>::infinity(), 1000.0F, -1000.0F);
    // Bricks: +b, -b, a value below all.
    const auto [nx, ny, nz] = field().n_bricks();
    const std::size_t bricks_at = 124 + 8 * (static_cast<std::size_t>(nx * ny * nz) + 1);
    constexpr std::size_t kBrick = sizeof(DistanceField::Brick);
    mended.check_refused_at(bricks_at - 8, 1);
    mended.check_refused_at(bricks_at, std::int16_t{0});
    mended.check_refused_at(bricks_at + kBrick, std::int16_t{0});
    mended.check_refused_at(bricks_at + 2 * kBrick, std::int16_t{-32768});
    // A corner is outside, the middle inside; nothing is farther from the mesh than the block is long, and the entry says no more.
    const std::size_t depths_at = bricks_at + field().bricks().size() * kBrick;
    const std::size_t n = field().depths().size();
    const std::size_t inner = static_cast<std::size_t>(((nz / 2) * ny + ny / 2) * nx + nx / 2);
    REQUIRE(field().depths()[0] < 0.0F);
    REQUIRE(field().depths()[inner] > 0.0F);
    mended.check_refused_at(depths_at, kNone, std::numeric_limits<float>::infinity(), 0.0F);
    mended.check_refused_at(depths_at + 4 * inner, 1000.0F, 0.5F * field().depths()[inner], -1.0F);
    mended.check_refused_at(depths_at + 4 * (n - 1), kNone);
    // And what is within its range is taken.
    CHECK(mended.takes_at(bricks_at + 2 * kBrick, std::int16_t{5}));
}

TEST_CASE("shape bytes: voxels that fill too little or too much are refused") {
    VoxelGrid grid;
    grid.frame.n_cells = {2, 2, 2};
    grid.cells.assign(8, VoxelClass::free);
    const Mended mended(encode(grid, kGridKey), is_grid);
    mended.check_refused_at(44, 0U, 7U << 2U, 9U << 2U, 0xFFFFFFFFU);  // a run's length
    mended.check_refused_at(32, 513, -2);
    mended.check_refused_at(24, 0.0);
    mended.check_refused_at(0, 1.0e300);
}

TEST_CASE("shape bytes: bad points and normals are refused; a key is that of mesh and settings") {
    const Pointshell whole = make_surface_pointshell(ball(), 2).value();
    const auto refuses = [&](std::vector<float> Pointshell::*values, float value) {
        Pointshell shell = whole;
        (shell.*values)[1] = value;
        return !is_shell(encode(shell, kShellKey));
    };
    CHECK_FALSE(refuses(&Pointshell::x_m, 0.25F));
    CHECK(refuses(&Pointshell::x_m, kNone));
    CHECK(refuses(&Pointshell::z_m, 1.0e30F));
    CHECK(refuses(&Pointshell::ny, kNone));
    CHECK(refuses(&Pointshell::nx, whole.nx[1] + 0.01F));
    Pointshell zero = whole;
    zero.nx[0] = zero.ny[0] = zero.nz[0] = 0.0F;
    CHECK_FALSE(is_shell(encode(zero, kShellKey)));
    CHECK_FALSE(is_shell(encode(Pointshell{}, kShellKey)));
    const TriangleMesh mesh = ball();
    const std::vector<double> settings{1.0, 2.0};
    const Digest key = compute_shape_key(ShapeKind::pointshell, mesh, settings);
    CHECK(key == kShellKey);
    CHECK(key != kGridKey);
    CHECK(key != compute_shape_key(ShapeKind::pointshell, mesh, std::vector<double>{1.0, 2.5}));
    CHECK(key != compute_shape_key(ShapeKind::pointshell, mesh, std::vector<double>{1.0}));
    std::vector<Vector3> vertices = mesh.vertices_B();
    vertices[7].z() += 1.0e-12;
    CHECK(key != compute_shape_key(ShapeKind::pointshell,
                                   TriangleMesh::build(vertices, mesh.triangles()).value(),
                                   settings));
    CHECK(key != compute_shape_key(ShapeKind::pointshell, make_inverted(mesh).value(), settings));
}

TEST_CASE("shape fit: what is made of a mesh can be that of it, and of another mesh cannot") {
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
