#include "haptics/collision/triangle_batch.h"

#include <cmath>

namespace fulcrum {

namespace {

// The loop runs over whole groups of so many, as many as a wide register holds; what lies beyond the last triangle is not looked at.
constexpr std::size_t kGroup = 4;
static_assert(TriangleBatch::kCapacity % kGroup == 0);

// By value, so that a loop of them needs no branches.
double larger_of(double a, double b) noexcept {
    return a > b ? a : b;
}

double smaller_of(double a, double b) noexcept {
    return a < b ? a : b;
}

double largest_of(double x, double y, double z) noexcept {
    return larger_of(larger_of(std::abs(x), std::abs(y)), std::abs(z));
}

}  // namespace

void TriangleBatch::find_apart(const Vector3& from_B, const Vector3& to_B,
                               Row& apart) const noexcept {
    const std::size_t n = (n_ + kGroup - 1) / kGroup * kGroup;
    const std::array<double, 3> from{from_B.x(), from_B.y(), from_B.z()};
    const std::array<double, 3> to{to_B.x(), to_B.y(), to_B.z()};
    std::array<double, 3> end_lower{};
    std::array<double, 3> end_upper{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        end_lower[axis] = smaller_of(from[axis], to[axis]);
        end_upper[axis] = larger_of(from[axis], to[axis]);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double from_x = from[0] - a_[0][i];
        const double from_y = from[1] - a_[1][i];
        const double from_z = from[2] - a_[2][i];
        const double to_x = to[0] - a_[0][i];
        const double to_y = to[1] - a_[1][i];
        const double to_z = to[2] - a_[2][i];
        const double height_from = doubled_area_[0][i] * from_x + doubled_area_[1][i] * from_y +
                                   doubled_area_[2][i] * from_z;
        const double height_to =
            doubled_area_[0][i] * to_x + doubled_area_[1][i] * to_y + doubled_area_[2][i] * to_z;
        const double error_from = error_per_m_[i] * largest_of(from_x, from_y, from_z);
        const double error_to = error_per_m_[i] * largest_of(to_x, to_y, to_z);
        // Both in front, or both behind, or on one side of the box.
        const double on_a_side =
            larger_of(smaller_of(height_from - error_from, height_to - error_to),
                      smaller_of(-height_from - error_from, -height_to - error_to));
        const double beside_x = larger_of(lower_[0][i] - end_upper[0], end_lower[0] - upper_[0][i]);
        const double beside_y = larger_of(lower_[1][i] - end_upper[1], end_lower[1] - upper_[1][i]);
        const double beside_z = larger_of(lower_[2][i] - end_upper[2], end_lower[2] - upper_[2][i]);
        apart[i] = larger_of(larger_of(on_a_side, beside_x), larger_of(beside_y, beside_z));
    }
}

SegmentHit TriangleBatch::find_nearest_hit(const Vector3& from_B,
                                           const Vector3& to_B) const noexcept {
    Row apart;
    find_apart(from_B, to_B, apart);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
    std::array<std::size_t, kCapacity> rest;
    std::size_t n_rest = 0;
    for (std::size_t i = 0; i < n_; ++i) {
        rest[n_rest] = i;
        n_rest += apart[i] > 0.0 ? 0U : 1U;
    }
    SegmentHit nearest;
    for (std::size_t i = 0; i < n_rest; ++i) {
        const SegmentHit hit = meet(triangles_[rest[i]], from_B, to_B);
        if (hit.is_before(nearest)) {
            nearest = hit;
        }
    }
    return nearest;
}

}  // namespace fulcrum
