#include "haptics/geometry/weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace fulcrum {

namespace {

using Cell = std::array<std::int64_t, 3>;

constexpr std::int32_t kNone = -1;
constexpr double kLargestCell = 4.0e18;  // within 64 bits; cells out there only share a chain

std::uint64_t hash_cell(const Cell& cell) {
    std::uint64_t hash =
        0x9E3779B97F4A7C15U;  // the golden ratio's bits: spreads neighbouring cells
    for (const std::int64_t part : cell) {
        hash = (hash ^ static_cast<std::uint64_t>(part)) * 0xBF58476D1CE4E5B9U;
        hash ^= hash >> 31U;
    }
    return hash;
}

// Kept vertices by cell. Chains of one slot may mix cells; distance decides, so that only costs
// time.
class KeptVertices {
  public:
    KeptVertices(std::span<const Vector3> vertices, double tolerance_m)
        : vertices_(vertices),
          tolerance_m_(tolerance_m),
          slots_(std::bit_ceil(vertices.size() + 1), kNone),
          next_(vertices.size(), kNone) {}

    // The kept vertex of least index within the tolerance, or kNone.
    [[nodiscard]] std::int32_t find(const Vector3& point) const {
        std::int32_t found = kNone;
        std::array<std::size_t, 8> seen{};
        for (unsigned corner = 0; corner < 8; ++corner) {
            const Vector3 offset((corner & 1U) != 0 ? tolerance_m_ : -tolerance_m_,
                                 (corner & 2U) != 0 ? tolerance_m_ : -tolerance_m_,
                                 (corner & 4U) != 0 ? tolerance_m_ : -tolerance_m_);
            const std::size_t slot = slot_of(point + offset);
            seen[corner] = slot;
            bool repeated = false;
            for (unsigned earlier = 0; earlier < corner; ++earlier) {
                repeated = repeated || seen[earlier] == slot;
            }
            if (!repeated) {
                found = find_in_chain(slot, point, found);
            }
        }
        return found;
    }

    void keep(std::int32_t index) {
        std::int32_t& head = slots_[slot_of(vertices_[static_cast<std::size_t>(index)])];
        next_[static_cast<std::size_t>(index)] = head;
        head = index;
    }

  private:
    [[nodiscard]] std::size_t slot_of(const Vector3& point) const {
        Cell cell{};
        for (int axis = 0; axis < 3; ++axis) {
            cell[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::clamp(
                std::floor(point[axis] / (2.0 * tolerance_m_)), -kLargestCell, kLargestCell));
        }
        return static_cast<std::size_t>(hash_cell(cell)) & (slots_.size() - 1);
    }

    [[nodiscard]] std::int32_t find_in_chain(std::size_t slot, const Vector3& point,
                                             std::int32_t found) const {
        for (std::int32_t i = slots_[slot]; i != kNone; i = next_[static_cast<std::size_t>(i)]) {
            const bool near =
                (vertices_[static_cast<std::size_t>(i)] - point).norm() <= tolerance_m_;
            if (near && (found == kNone || i < found)) {
                found = i;
            }
        }
        return found;
    }

    std::span<const Vector3> vertices_;
    double tolerance_m_;
    std::vector<std::int32_t> slots_;
    std::vector<std::int32_t> next_;
};

}  // namespace

std::vector<std::int32_t> compute_welded_indices(std::span<const Vector3> vertices,
                                                 double tolerance_m) {
    std::vector<std::int32_t> becomes(vertices.size());
    KeptVertices kept(vertices, tolerance_m);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto self = static_cast<std::int32_t>(i);
        const std::int32_t same = kept.find(vertices[i]);
        becomes[i] = same == kNone ? self : same;
        if (same == kNone) {
            kept.keep(self);
        }
    }
    return becomes;
}

}  // namespace fulcrum
