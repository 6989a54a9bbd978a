// Points in a hash table of cubic cells, twice the tolerance wide: a ball of that radius meets at most 8.
//
// Thread: load. Cost: O(1) for points further apart than the tolerance.
#pragma once

#include "haptics/math/spatial.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

class NearPoints {
  public:
    /// Over points that must remain; none is in the table yet. `tolerance_m` > 0.
    NearPoints(std::span<const Vector3> points, double tolerance_m)
        : points_(points),
          tolerance_m_(tolerance_m),
          slots_(std::bit_ceil(points.size() + 1), kNone),
          next_(points.size(), kNone) {}

    /// Puts one of the points into the table.
    void add(std::int32_t index) {
        std::int32_t& head = slots_[slot_of(points_[static_cast<std::size_t>(index)])];
        next_[static_cast<std::size_t>(index)] = head;
        head = index;
    }

    /// Calls visit(index) for the points in the table within the tolerance, in any order.
    template <class Visit>
    void for_each_near(const Vector3& point, Visit&& visit) const {
        std::array<std::size_t, 8> seen{};
        for (unsigned corner = 0; corner < 8; ++corner) {
            const Vector3 offset((corner & 1U) != 0 ? tolerance_m_ : -tolerance_m_,
                                 (corner & 2U) != 0 ? tolerance_m_ : -tolerance_m_,
                                 (corner & 4U) != 0 ? tolerance_m_ : -tolerance_m_);
            const std::size_t slot = slot_of(point + offset);
            seen[corner] = slot;
            if (std::find(seen.begin(), seen.begin() + corner, slot) == seen.begin() + corner) {
                visit_chain(slot, point, visit);
            }
        }
    }

  private:
    static constexpr std::int32_t kNone = -1;

    [[nodiscard]] std::size_t slot_of(const Vector3& point) const {
        constexpr double kLargestCell = 4.0e18;  // within 64 bits; cells out there share a chain
        // The golden ratio's bits spread neighbouring cells.
        std::uint64_t hash = 0x9E3779B97F4A7C15U;
        for (const double coordinate : point) {
            const double cell = std::clamp(std::floor(coordinate / (2.0 * tolerance_m_)),
                                           -kLargestCell, kLargestCell);
            hash = (hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cell))) *
                   0xBF58476D1CE4E5B9U;
            hash ^= hash >> 31U;
        }
        return static_cast<std::size_t>(hash) & (slots_.size() - 1);
    }
    // Chains of one slot may mix cells; distance decides, so that only costs time.
    template <class Visit>
    void visit_chain(std::size_t slot, const Vector3& point, Visit&& visit) const {
        for (std::int32_t i = slots_[slot]; i != kNone; i = next_[static_cast<std::size_t>(i)]) {
            if ((points_[static_cast<std::size_t>(i)] - point).norm() <= tolerance_m_) {
                visit(i);
            }
        }
    }

    std::span<const Vector3> points_;
    double tolerance_m_;
    std::vector<std::int32_t> slots_;
    std::vector<std::int32_t> next_;
};

}  // namespace fulcrum
