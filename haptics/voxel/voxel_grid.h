// A block of voxels of four kinds, one byte each: what a mesh becomes first, and the map that is read fastest where it fits
// the processor's caches.
//
// Thread: filled at load; read from any thread. Cost: one load a look, 1 byte a voxel.
// Source: W. McNeely, K. Puterbaugh, J. Troy 1999, Six degree-of-freedom haptic rendering using voxel sampling, section
// 4.1, table 1 (the four kinds and their numbers).
#pragma once

#include "haptics/voxel/voxel_frame.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fulcrum {

/// McNeely's two bits. The upper one says whether a point there is felt.
enum class VoxelClass : std::uint8_t {
    free = 0,      ///< nothing but free space
    interior = 1,  ///< deeper than the layer that pushes: a point here has penetrated
    surface = 2,   ///< pushes
    proximity = 3  ///< free, but near what pushes: brakes
};

/// Filled whole; x runs fastest, then y, then z. The outermost voxels of a grid from `voxelise` are free, so that a place
/// outside may be clamped to them.
struct VoxelGrid {
    VoxelFrame frame{};
    std::vector<VoxelClass> cells;

    /// Where a voxel of the frame lies in `cells`.
    [[nodiscard]] std::size_t index_of(const VoxelFrame::Cell& cell) const noexcept {
        const auto [nx, ny, nz] = frame.n_cells;
        return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(ny) +
                static_cast<std::size_t>(cell[1])) *
                   static_cast<std::size_t>(nx) +
               static_cast<std::size_t>(cell[0]);
    }
    /// Free outside the frame.
    [[nodiscard]] VoxelClass find_class(const VoxelFrame::Cell& cell) const noexcept {
        return frame.contains(cell) ? cells[index_of(cell)] : VoxelClass::free;
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept { return sizeof(*this) + cells.size(); }
};

/// Whether the outermost voxels of a block are all free, by what find_class(cell) says of each.
template <class FindClass>
[[nodiscard]] bool is_free_outside(const VoxelFrame& frame, FindClass&& find_class) {
    const VoxelFrame::Cell& n = frame.n_cells;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t second = (axis + 1) % 3;
        const std::size_t third = (axis + 2) % 3;
        VoxelFrame::Cell cell{};
        for (cell[second] = 0; cell[second] < n[second]; ++cell[second]) {
            for (cell[third] = 0; cell[third] < n[third]; ++cell[third]) {
                for (const std::int32_t end : {0, n[axis] - 1}) {
                    cell[axis] = end;
                    if (find_class(cell) != VoxelClass::free) {
                        return false;
                    }
                }
            }
        }
    }
    return true;
}

}  // namespace fulcrum
