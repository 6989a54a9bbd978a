// Where a block of equal cubes lies in the frame of the object it covers: what voxmaps and distance fields share.
//
//   cell of a point:   i = floor((p_O - lower_O) / s)          s the voxel size, i counted from 0 along each axis
//   its centre:        p_O = lower_O + (i + 1/2) s
//   a place in cells:  g = (p_O - lower_O) / s                 lattice corners are where g is whole
//
// Thread: load; asked from any thread. Cost: a subtraction and a multiplication an axis.
#pragma once

#include "haptics/math/spatial.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace fulcrum {

struct VoxelFrame {
    using Cell = std::array<std::int32_t, 3>;

    Vector3 lower_O{Vector3::Zero()};  ///< least corner of cell 0, 0, 0
    double voxel_m = 1.0;              ///< edge of a cell, above 0
    Cell n_cells{1, 1, 1};             ///< along each axis, at least 1

    [[nodiscard]] Vector3 upper_O() const noexcept {
        return lower_O + voxel_m * Vector3(n_cells[0], n_cells[1], n_cells[2]);
    }
    /// Counted in cells from the least corner.
    [[nodiscard]] Vector3 to_lattice(const Vector3& p_O) const noexcept {
        return (p_O - lower_O) / voxel_m;
    }
    /// May lie outside; needs a place within 2^31 cells of the block.
    [[nodiscard]] Cell find_cell(const Vector3& p_O) const noexcept {
        const Vector3 g = to_lattice(p_O);
        return {static_cast<std::int32_t>(std::floor(g.x())),
                static_cast<std::int32_t>(std::floor(g.y())),
                static_cast<std::int32_t>(std::floor(g.z()))};
    }
    [[nodiscard]] Vector3 centre_of(const Cell& cell) const noexcept {
        return lower_O + voxel_m * Vector3(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5);
    }
    [[nodiscard]] bool contains(const Cell& cell) const noexcept {
        return is_within(cell, 0) && is_within(cell, 1) && is_within(cell, 2);
    }

  private:
    [[nodiscard]] bool is_within(const Cell& cell, std::size_t axis) const noexcept {
        return cell[axis] >= 0 && cell[axis] < n_cells[axis];
    }
};

}  // namespace fulcrum
