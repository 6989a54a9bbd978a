#include "haptics/voxel/shape_bytes.h"

#include "haptics/voxel/shape_seal.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {

using namespace shape_seal;

namespace {

constexpr std::int32_t kMostGridCells = 512;

// What is kept of each kind.
template <class Walker>
void walk_payload(Walker& walker, const VoxelGrid& grid) {
    walk_frame(walker, grid.frame);
    for (std::size_t first = 0; first < grid.cells.size();) {
        const VoxelClass kind = grid.cells[first];
        std::size_t end = first + 1;
        while (end < grid.cells.size() && grid.cells[end] == kind) {
            ++end;
        }
        // The kind in the two lowest bits.
        walker.field(static_cast<std::uint32_t>(end - first) << 2U |
                     static_cast<std::uint32_t>(kind));
        first = end;
    }
}

template <class Walker>
void walk_payload(Walker& walker, const Pointshell& shell) {
    for (const auto* const values :
         {&shell.x_m, &shell.y_m, &shell.z_m, &shell.nx, &shell.ny, &shell.nz}) {
        walker.array(std::span<const float>(*values));
    }
}

template <class Walker, class Moments>
void walk_moments(Walker& walker, Moments& moments) {
    walker.field(moments.volume_m3);
    walk_vector(walker, moments.centre_B);
    for (Index row = 0; row < 3; ++row) {
        for (Index column = 0; column < 3; ++column) {
            walker.field(moments.second_m5(row, column));
        }
    }
}

template <class Walker>
void walk_payload(Walker& walker, const MeasuredSolid& solid) {
    walk_moments(walker, solid.moments);
    walker.field(static_cast<std::uint8_t>(solid.by_samples ? 1 : 0));
}

// Of a solid that fills some of the space that a mesh may take, and is spread along three axes as a body is.
bool are_moments(const SolidMoments& moments) noexcept {
    constexpr double kRounding = 1.0e-9;
    const double longest_m = 2.0 * kLargest_m;
    const Matrix3& second = moments.second_m5;
    if (!(moments.volume_m3 > 0.0 && moments.volume_m3 <= longest_m * longest_m * longest_m) ||
        !is_place(moments.centre_B) || !second.allFinite() || !(second.trace() > 0.0)) {
        return false;
    }
    const Vector3 along = compute_principal_axes(second).moments;
    return along.minCoeff() >= -kRounding * along.maxCoeff() &&
           (second - second.transpose()).cwiseAbs().maxCoeff() <= kRounding * second.trace();
}

auto payload_of(const auto& shape) {
    return [&shape](auto& walker) { walk_payload(walker, shape); };
}

// A unit normal in single precision.
bool is_direction(const Vector3& normal) noexcept {
    constexpr double kRounding = 1.0e-6;
    return std::abs(normal.squaredNorm() - 1.0) <= kRounding;
}

}  // namespace

std::size_t count_bytes(const VoxelGrid& grid) {
    return count_sealed(payload_of(grid));
}

std::size_t count_bytes(const Pointshell& shell) {
    return count_sealed(payload_of(shell));
}

std::size_t count_bytes(const MeasuredSolid& solid) {
    return count_sealed(payload_of(solid));
}

Bytes encode(const VoxelGrid& grid, const Digest& key) {
    return seal(ShapeKind::voxel_grid, key, payload_of(grid));
}

Bytes encode(const Pointshell& shell, const Digest& key) {
    return seal(ShapeKind::pointshell, key, payload_of(shell));
}

Bytes encode(const MeasuredSolid& solid, const Digest& key) {
    return seal(ShapeKind::solid_moments, key, payload_of(solid));
}

Expected<VoxelGrid> decode_voxel_grid(std::span<const std::byte> bytes, const Digest& key) {
    const auto payload = unseal(bytes, ShapeKind::voxel_grid, key);
    if (!payload) {
        return tl::unexpected(payload.error());
    }
    ByteReader reader(*payload);
    VoxelGrid grid;
    walk_frame(reader, grid.frame);
    if (!reader.is_whole() || !is_frame(grid.frame, 1, kMostGridCells)) {
        return refuse("the kept voxels are none");
    }
    const auto [nx, ny, nz] = grid.frame.n_cells;
    const std::size_t n_cells =
        static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz);
    grid.cells.assign(n_cells, VoxelClass::free);
    std::size_t first = 0;
    while (reader.n_left() > 0) {
        std::uint32_t run = 0;
        reader.field(run);
        const std::size_t n = run >> 2U;
        if (!reader.is_whole() || n == 0 || n > n_cells - first) {
            return refuse("the kept voxels are none");
        }
        std::fill_n(grid.cells.begin() + static_cast<std::ptrdiff_t>(first), n,
                    static_cast<VoxelClass>(run & 3U));
        first += n;
    }
    if (first != n_cells) {
        return refuse("the kept voxels are none");
    }
    return grid;
}

Expected<Pointshell> decode_pointshell(std::span<const std::byte> bytes, const Digest& key) {
    const auto payload = unseal(bytes, ShapeKind::pointshell, key);
    if (!payload) {
        return tl::unexpected(payload.error());
    }
    constexpr std::size_t kPointBytes = 6 * sizeof(float);
    const std::size_t n = payload->size() / kPointBytes;
    if (n == 0 || payload->size() % kPointBytes != 0 ||
        n > static_cast<std::size_t>(kMostShellPoints)) {
        return refuse("the kept pointshell is none");
    }
    ByteReader reader(*payload);
    Pointshell shell;
    for (auto* const values :
         {&shell.x_m, &shell.y_m, &shell.z_m, &shell.nx, &shell.ny, &shell.nz}) {
        reader.array(*values, n);
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (!is_place(shell.position_T(i)) || !is_direction(shell.normal_T(i))) {
            return refuse("the kept pointshell is none");
        }
    }
    return shell;
}

Expected<MeasuredSolid> decode_measured_solid(std::span<const std::byte> bytes, const Digest& key) {
    const auto payload = unseal(bytes, ShapeKind::solid_moments, key);
    if (!payload) {
        return tl::unexpected(payload.error());
    }
    ByteReader reader(*payload);
    MeasuredSolid solid;
    std::uint8_t by_samples = 0;
    walk_moments(reader, solid.moments);
    reader.field(by_samples);
    solid.by_samples = by_samples == 1;
    if (!reader.is_whole() || reader.n_left() != 0 || by_samples > 1 ||
        !are_moments(solid.moments)) {
        return refuse("the kept moments are none");
    }
    return solid;
}

}  // namespace fulcrum
