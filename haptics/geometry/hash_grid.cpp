#include "haptics/geometry/hash_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace fulcrum {

HashGrid::HashGrid(const Box& box, double cell_m) : box_(box) {
    const double longest_m = (box.upper - box.lower).maxCoeff();
    cell_m_ = std::max(cell_m, longest_m / (kMaxCells - 2.0));
    // What is put in reaches beyond the box by the margin; the last cell's border shall lie beyond that.
    box_.lower -= Vector3::Constant(2.0 * margin_m());
    box_.upper += Vector3::Constant(2.0 * margin_m());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Index>(axis);
        const double n = std::ceil((box_.upper[i] - box_.lower[i]) / cell_m_);
        n_cells_[axis] = static_cast<std::int32_t>(std::clamp(n, 1.0, kMaxCells));
    }
    reserve(0);
}

HashGrid::Cell HashGrid::find_cell(const Vector3& point) const noexcept {
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Index>(axis);
        const double place = std::floor((point[i] - box_.lower[i]) / cell_m_);
        cell[axis] = static_cast<std::int32_t>(
            std::clamp(place, 0.0, static_cast<double>(n_cells_[axis] - 1)));
    }
    return cell;
}

std::uint64_t HashGrid::to_key(const Cell& cell) noexcept {
    constexpr unsigned kBits = 21;
    return static_cast<std::uint64_t>(cell[0]) | static_cast<std::uint64_t>(cell[1]) << kBits |
           static_cast<std::uint64_t>(cell[2]) << (2 * kBits);
}

std::size_t HashGrid::slot_of(std::uint64_t key) const noexcept {
    // The golden ratio's bits spread neighbours.
    const std::uint64_t hash = (key ^ key >> 29U) * 0x9E3779B97F4A7C15U;
    return static_cast<std::size_t>(hash >> 32U) & (values_.size() - 1);
}

void HashGrid::reserve(std::size_t n_cells) {
    const std::size_t n_slots = std::bit_ceil(2 * n_cells + 2);
    keys_.assign(n_slots, 0);
    values_.assign(n_slots, kNothing);
}

void HashGrid::insert(std::uint64_t key, std::int32_t value) noexcept {
    std::size_t slot = slot_of(key);
    while (values_[slot] != kNothing) {
        slot = (slot + 1) & (values_.size() - 1);
    }
    keys_[slot] = key;
    values_[slot] = value;
}

std::int32_t HashGrid::find(std::uint64_t key) const noexcept {
    std::size_t slot = slot_of(key);
    while (values_[slot] != kNothing && keys_[slot] != key) {
        slot = (slot + 1) & (values_.size() - 1);
    }
    return values_[slot];
}

bool HashGrid::clip(const Vector3& from, const Vector3& to, double& t_in,
                    double& t_out) const noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        const double rate = to[axis] - from[axis];
        if (rate == 0.0) {
            if (from[axis] < box_.lower[axis] || from[axis] > box_.upper[axis]) {
                return false;
            }
            continue;
        }
        const double t_lower = (box_.lower[axis] - from[axis]) / rate;
        const double t_upper = (box_.upper[axis] - from[axis]) / rate;
        t_in = std::max(t_in, std::min(t_lower, t_upper));
        t_out = std::min(t_out, std::max(t_lower, t_upper));
    }
    return t_in <= t_out;
}

std::size_t HashGrid::memory_bytes() const noexcept {
    return keys_.capacity() * sizeof(std::uint64_t) + values_.capacity() * sizeof(std::int32_t);
}

}  // namespace fulcrum
