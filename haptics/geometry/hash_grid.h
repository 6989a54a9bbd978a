// A uniform grid of cells of which only those that hold something are kept, found by hashing; and the way of a segment through it.
//
// The way visits cells in order (three distances to the next border, the nearest is crossed). Rounding may take it into a
// neighbour a hair early or late: whoever fills the grid widens what he puts in by `margin_m`, which is far more.
//
// Thread: filled at load; asked from any thread. Cost: a cell is found in O(1); 12 bytes a slot, at most half of them used.
// Source: J. Amanatides, A. Woo 1987, A fast voxel traversal algorithm for ray tracing, Eurographics.
#pragma once

#include "haptics/geometry/step_box.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace fulcrum {

class HashGrid {
  public:
    using Cell = std::array<std::int32_t, 3>;
    static constexpr double kMaxCells = 1 << 20;  ///< along an axis
    static constexpr double kMargin = 1.0e-3;     ///< of a cell
    static constexpr std::int32_t kNothing = -1;

    HashGrid() = default;
    /// Over a box; a cell's edge is `cell_m` or as much as kMaxCells ask for.
    HashGrid(const Box& box, double cell_m);

    [[nodiscard]] double cell_m() const noexcept { return cell_m_; }
    [[nodiscard]] double margin_m() const noexcept { return kMargin * cell_m_; }
    /// The cell of a point, or the nearest one to it.
    [[nodiscard]] Cell find_cell(const Vector3& point) const noexcept;
    /// A cell as one number.
    [[nodiscard]] static std::uint64_t to_key(const Cell& cell) noexcept;

    /// Room for so many cells; forgets all that were there.
    void reserve(std::size_t n_cells);
    /// What lies in a cell; each cell once, value >= 0. Needs room.
    void insert(std::uint64_t key, std::int32_t value) noexcept;
    [[nodiscard]] std::int32_t find(std::uint64_t key) const noexcept;

    /// Are coordinates of this magnitude exact enough for the margin?
    [[nodiscard]] bool resolves(double largest_m) const noexcept {
        constexpr double kRoundings = 32.0 * std::numeric_limits<double>::epsilon();
        return kRoundings * largest_m < margin_m();
    }
    /// Calls visit(key, t_leave) for the cells along from + t (to - from) until it returns false; t_leave is where the segment
    /// goes on to the next one. Needs ends that it `resolves`.
    template <class Visit>
    void for_each_along(const Vector3& from, const Vector3& to, Visit&& visit) const noexcept;
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    [[nodiscard]] bool clip(const Vector3& from, const Vector3& to, double& t_in,
                            double& t_out) const noexcept;
    // Where the segment crosses the cell's next border on an axis; never, if it does not move along it. From the border's own
    // place each time, so that no rounding adds up on the way.
    [[nodiscard]] double find_border(const Vector3& from, const Vector3& to, const Cell& cell,
                                     std::size_t axis) const noexcept {
        const auto i = static_cast<Index>(axis);
        const double border = box_.lower[i] + cell_m_ * (cell[axis] + (to[i] > from[i] ? 1 : 0));
        return to[i] == from[i] ? std::numeric_limits<double>::infinity()
                                : (border - from[i]) / (to[i] - from[i]);
    }
    [[nodiscard]] std::size_t slot_of(std::uint64_t key) const noexcept;

    Box box_;
    double cell_m_ = 1.0;
    Cell n_cells_{1, 1, 1};
    std::vector<std::uint64_t> keys_;
    std::vector<std::int32_t> values_;  // kNothing in free slots
};

template <class Visit>
void HashGrid::for_each_along(const Vector3& from, const Vector3& to,
                              Visit&& visit) const noexcept {
    double t_in = 0.0;
    double t_out = 1.0;
    if (!clip(from, to, t_in, t_out)) {
        return;
    }
    Cell cell = find_cell(from + t_in * (to - from));
    std::array<double, 3> t_next{find_border(from, to, cell, 0), find_border(from, to, cell, 1),
                                 find_border(from, to, cell, 2)};
    while (true) {
        const std::size_t xy = t_next[0] <= t_next[1] ? 0 : 1;
        const std::size_t axis = t_next[xy] <= t_next[2] ? xy : 2;
        const double t_leave = t_next[axis];
        const auto i = static_cast<Index>(axis);
        if (!visit(to_key(cell), t_leave) || t_leave > t_out) {
            return;
        }
        cell[axis] += to[i] > from[i] ? 1 : -1;
        if (cell[axis] < 0 || cell[axis] >= n_cells_[axis]) {
            return;
        }
        t_next[axis] = find_border(from, to, cell, axis);
    }
}

}  // namespace fulcrum
