#include "haptics/voxel/shape_bytes.h"

#include "haptics/geometry/shape.h"
#include "haptics/voxel/voxelise.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <limits>

namespace fulcrum {
namespace {

constexpr std::size_t kPayloadAt = 56;

TriangleMesh ball() {
    return make_sphere(1.0, 3).value();
}

Digest key_of(ShapeKind kind) {
    return compute_shape_key(kind, ball(), std::vector<double>{1.0, 2.0});
}

const DistanceField& field() {
    static const DistanceField kField =
        DistanceField::build(ball(), DistanceField::make_frame(ball(), 24).value()).value();
    return kField;
}

const Digest kFieldKey = key_of(ShapeKind::distance_field);
const Digest kGridKey = key_of(ShapeKind::voxel_grid);
const Digest kShellKey = key_of(ShapeKind::pointshell);

// Bytes that somebody changed and whose checksum was put right.
Bytes mend(Bytes bytes) {
    const std::size_t end = bytes.size() - sizeof(Digest);
    const Digest checksum = compute_sha256(std::span(bytes).first(end));
    std::memcpy(bytes.data() + end, checksum.data(), sizeof checksum);
    return bytes;
}

template <class T>
Bytes with(const Bytes& bytes, std::size_t at, T value) {
    Bytes changed = bytes;
    std::memcpy(changed.data() + at, &value, sizeof value);
    return mend(std::move(changed));
}

TEST_CASE("shape bytes: a distance field comes back the same in every question") {
    const Bytes bytes = encode(field(), kFieldKey);
    const auto back = decode_distance_field(bytes, kFieldKey);
    REQUIRE(back);
    CHECK(encode(*back, kFieldKey) == bytes);
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
    const Pointshell shell = make_surface_pointshell(ball(), 500).value();
    const auto shell_back = decode_pointshell(encode(shell, kShellKey), kShellKey);
    REQUIRE(shell_back);
    CHECK(shell_back->x_m == shell.x_m);
    CHECK(shell_back->nz == shell.nz);
}

TEST_CASE("shape bytes: what is cut off, longer, or changed in any place is refused") {
    const Pointshell shell = make_surface_pointshell(ball(), 3).value();
    const Bytes bytes = encode(shell, kShellKey);
    for (std::size_t n = 0; n < bytes.size(); ++n) {
        REQUIRE_FALSE(decode_pointshell(std::span(bytes).first(n), kShellKey));
        Bytes flipped = bytes;
        flipped[n] ^= std::byte{16};
        REQUIRE_FALSE(decode_pointshell(flipped, kShellKey));
    }
    Bytes longer = bytes;
    longer.push_back(std::byte{0});
    CHECK_FALSE(decode_pointshell(longer, kShellKey));
    // A version, a kind and a key that are not those asked for, with checksums put right.
    CHECK_FALSE(decode_pointshell(with(bytes, 8, kShapeVersion + 1), kShellKey));
    CHECK_FALSE(decode_voxel_grid(bytes, kShellKey));
    CHECK_FALSE(decode_pointshell(bytes, kGridKey));
    const auto refused = decode_pointshell(bytes, kGridKey);
    CHECK(to_sentence(refused.error()) ==
          "the kept shape is that of another mesh; it is made again.");
}

TEST_CASE(
    "shape bytes: a distance field that no build makes is refused, its checksum right or not") {
    const Bytes bytes = encode(field(), kFieldKey);
    const auto refuses = [&](std::size_t at, auto value) {
        return !decode_distance_field(with(bytes, kPayloadAt + at, value), kFieldKey);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    // Frame: lower corner, voxel, cells.
    CHECK(refuses(0, nan));
    CHECK(refuses(24, 0.0));
    CHECK(refuses(24, -1.0));
    CHECK(refuses(32, std::int32_t{0}));
    CHECK(refuses(32, std::int32_t{2147483640}));
    CHECK(refuses(36, std::int32_t{25}));
    CHECK(refuses(36, std::int32_t{32}));
    // Band, slope, counts, ball, sheet, number of bricks.
    CHECK(refuses(44, nan));
    CHECK(refuses(52, 2.0));
    CHECK(refuses(52, 0.0));
    CHECK(refuses(60, std::int64_t{-1}));
    CHECK(refuses(76, nan));
    CHECK(refuses(100, -1.0));
    CHECK(refuses(108, nan));
    CHECK(refuses(108, 0.4));
    CHECK(refuses(116, std::uint64_t{1} << 60U));
    CHECK(refuses(116, std::uint64_t{1}));
    // Entries: a brick that is not there, a distance that is no number; bricks: +b, -b, a value below all.
    CHECK(refuses(124, std::int32_t{-1}));
    CHECK(refuses(124, std::int32_t{1000000}));
    CHECK(refuses(128, std::numeric_limits<float>::infinity()));
    const auto [nx, ny, nz] = field().n_bricks();
    const std::size_t bricks_at = 124 + 8 * (static_cast<std::size_t>(nx * ny * nz) + 1);
    CHECK(refuses(bricks_at - 8, std::int32_t{1}));
    CHECK(refuses(bricks_at, std::int16_t{0}));
    CHECK(refuses(bricks_at + sizeof(DistanceField::Brick), std::int16_t{0}));
    CHECK(refuses(bricks_at + 2 * sizeof(DistanceField::Brick), std::int16_t{-32768}));
    const std::size_t depths_at =
        bricks_at + field().bricks().size() * sizeof(DistanceField::Brick);
    CHECK(refuses(depths_at, std::numeric_limits<float>::quiet_NaN()));
    // And what is within its range is taken.
    CHECK_FALSE(refuses(bricks_at + 2 * sizeof(DistanceField::Brick), std::int16_t{5}));
}

TEST_CASE("shape bytes: voxels that fill too little or too much are refused") {
    VoxelGrid grid;
    grid.frame.n_cells = {2, 2, 2};
    grid.cells.assign(8, VoxelClass::free);
    const Bytes bytes = encode(grid, kGridKey);
    CHECK(decode_voxel_grid(bytes, kGridKey));
    const std::size_t run_at = kPayloadAt + 44;
    for (const std::uint32_t run : {0U, 7U << 2U, 9U << 2U, 0xFFFFFFFFU}) {
        CHECK_FALSE(decode_voxel_grid(with(bytes, run_at, run), kGridKey));
    }
    CHECK_FALSE(decode_voxel_grid(with(bytes, kPayloadAt + 32, std::int32_t{513}), kGridKey));
    CHECK_FALSE(decode_voxel_grid(with(bytes, kPayloadAt + 32, std::int32_t{-2}), kGridKey));
    Pointshell shell = make_surface_pointshell(ball(), 2).value();
    shell.ny[1] = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(decode_pointshell(encode(shell, kShellKey), kShellKey));
    CHECK_FALSE(decode_pointshell(encode(Pointshell{}, kShellKey), kShellKey));
}

TEST_CASE("shape bytes: a key is that of kind, mesh and settings alone") {
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

}  // namespace
}  // namespace fulcrum
