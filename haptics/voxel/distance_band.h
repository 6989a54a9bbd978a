// Exact distances at the lattice corners of one brick of a distance field, triangle by triangle.
//
// A brick is 8 x 8 x 8 cells: 9 x 9 x 9 corners, those of its upper faces shared with its neighbours. All in voxels from the
// brick's least corner. With n the triangle's normal, t_i its edges' directions and m_i = t_i x n, which points away from it,
//   h = n.p - n.a,   e_i = m_i.p - m_i.a_i,   x_i = max(-s_i, s_i - l_i, 0) with s_i = t_i.p - t_i.a_i
//   d^2 = h^2                              where every e_i <= 0
//       = h^2 + min over i (e_i^2 + x_i^2) elsewhere
// All seven are linear along a row, so that eight corners are done at once.
//
// Thread: load. Cost: about a nanosecond a corner within the band of a triangle.
#pragma once

#include "haptics/voxel/triangle_clusters.h"

#include <array>

namespace fulcrum {

inline constexpr int kBrickCells = 8;                      ///< along each edge of a brick
inline constexpr int kBrickSide = kBrickCells + 1;         ///< lattice corners along each edge
inline constexpr std::size_t kBrickCorners = 9UL * 9 * 9;  ///< x fastest, then y, then z

/// Where a corner lies in a brick's list.
[[nodiscard]] constexpr std::size_t brick_corner_at(int x, int y, int z) noexcept {
    const int at = x + kBrickSide * (y + kBrickSide * z);
    return static_cast<std::size_t>(at);
}

/// One value a lattice corner of a brick.
using BrickDistances = std::array<float, kBrickCorners>;

/// A triangle as the corners of one brick ask for it.
struct BandTriangle {
    /// a.p + offset at a place p in the brick.
    struct Line {
        std::array<float, 3> slope{};
        float offset = 0.0F;
    };
    Line height;                 // h
    std::array<Line, 3> beyond;  // e_i
    std::array<Line, 3> along;   // s_i
    std::array<float, 3> length{};
    float not_a_face = 0.0F;        // added to e_i: above 0 where there is no face, a sliver
    std::array<float, 3> middle{};  // of a ball round it
    float radius = 0.0F;
};

/// From corners in voxels from the brick's least corner.
[[nodiscard]] BandTriangle prepare_for_band(const TriangleAt& triangle) noexcept;

/// Lowers `squares`, of distances in voxels, to the triangle's wherever that is within `band`; corners farther from it may be
/// lowered as well, never below their distance.
void lower_squares(const BandTriangle& triangle, float band, BrickDistances& squares) noexcept;

using LowerSquares = void (*)(const BandTriangle&, float band, BrickDistances&) noexcept;
/// The plain version and that for AVX2, null where the processor has none of it or the compiler could not build it; they agree to the
/// bit, and the last is taken.
[[nodiscard]] std::array<LowerSquares, 2> all_lower_squares() noexcept;

}  // namespace fulcrum
