// A few triangles of a mesh side by side, so that a segment asks several of them at a time.
//
// Most triangles near a segment have both of its ends on one side of their plane, or none of it in their box. A loop without branches
// leaves those out, by the heights and bounds of error that `meet` goes by; `meet` itself is asked about the few others. So the
// answer is to the bit that of asking it about each.
//
// Thread: the one that owns it. Cost: to put a triangle in about ten nanoseconds, to ask one about two; no allocation.
#pragma once

#include "haptics/collision/segment_triangle.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace fulcrum {

class TriangleBatch {
  public:
    static constexpr std::size_t kCapacity = 32;

    void clear() noexcept { n_ = 0; }
    [[nodiscard]] std::size_t size() const noexcept { return n_; }
    [[nodiscard]] bool is_full() const noexcept { return n_ == kCapacity; }
    /// Puts in one more; there must be room.
    void add(const PreparedTriangle& triangle) noexcept;
    /// The first meeting of the segment with any of them; body frame, `from` and `to` finite.
    [[nodiscard]] SegmentHit find_nearest_hit(const Vector3& from_B,
                                              const Vector3& to_B) const noexcept;

  private:
    using Row = std::array<double, kCapacity>;  // a number of each triangle
    using Rows = std::array<Row, 3>;            // a vector's components
    // For each triangle a number, above zero when both ends lie clearly on one side of it or of its box.
    void find_apart(const Vector3& from_B, const Vector3& to_B, Row& apart) const noexcept;

    alignas(64) Rows a_{};  // what the loop asks of each, as in PreparedTriangle
    Rows doubled_area_{};
    Row error_per_m_{};
    Rows lower_{};  // and the box around it
    Rows upper_{};
    std::array<PreparedTriangle, kCapacity> triangles_;
    std::size_t n_ = 0;
};

inline void TriangleBatch::add(const PreparedTriangle& triangle) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Index>(axis);
        a_[axis][n_] = triangle.a[i];
        doubled_area_[axis][n_] = triangle.doubled_area[i];
        lower_[axis][n_] = std::min({triangle.a[i], triangle.b[i], triangle.c[i]});
        upper_[axis][n_] = std::max({triangle.a[i], triangle.b[i], triangle.c[i]});
    }
    error_per_m_[n_] = triangle.error_per_m;
    triangles_[n_++] = triangle;
}

}  // namespace fulcrum
