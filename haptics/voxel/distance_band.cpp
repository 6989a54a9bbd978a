#include "haptics/voxel/distance_band.h"

#include "haptics/base/processor.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#if defined(__GNUC__)
// Vectors wider than the processor's never leave this file.
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace fulcrum {

namespace {

constexpr float kFarAway = 1.0e6F;  // voxels: beyond any triangle of a block
// Height over longest edge: below, a triangle is its longest edge to within a millionth of it.
constexpr double kSliver = 1.0e-6;

}  // namespace

}  // namespace fulcrum

#define FULCRUM_KERNEL plain_band
#include "haptics/voxel/distance_band_kernel.h"
#undef FULCRUM_KERNEL
#ifdef FULCRUM_WIDER_KERNELS
#pragma GCC push_options
#pragma GCC target("avx2")
#define FULCRUM_KERNEL avx2_band
#include "haptics/voxel/distance_band_kernel.h"
#undef FULCRUM_KERNEL
#pragma GCC pop_options
#endif

namespace fulcrum {

namespace {

BandTriangle::Line make_line(const Vector3& slope, const Vector3& through) noexcept {
    return {{static_cast<float>(slope.x()), static_cast<float>(slope.y()),
             static_cast<float>(slope.z())},
            static_cast<float>(-slope.dot(through))};
}

}  // namespace

BandTriangle prepare_for_band(const TriangleAt& triangle) noexcept {
    const std::array<Vector3, 3> corners{triangle.a, triangle.b, triangle.c};
    std::array<Vector3, 3> edges;
    std::size_t longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        edges[i] = corners[(i + 1) % 3] - corners[i];
        longest = edges[i].squaredNorm() > edges[longest].squaredNorm() ? i : longest;
    }
    Vector3 normal = edges[0].cross(edges[1]);
    const bool is_sliver = normal.norm() <= kSliver * edges[longest].squaredNorm();
    normal = is_sliver ? edges[longest].unitOrthogonal() : normal.normalized();

    BandTriangle t;
    t.height = make_line(normal, corners[longest]);
    t.not_a_face = is_sliver ? 2.0F * kFarAway : 0.0F;
    for (std::size_t i = 0; i < 3; ++i) {
        if (is_sliver && i != longest) {
            t.beyond[i].offset = kFarAway;
            continue;
        }
        const Vector3 along = edges[i].normalized();
        t.along[i] = make_line(along, corners[i]);
        t.beyond[i] = make_line(along.cross(normal), corners[i]);
        t.length[i] = static_cast<float>(edges[i].norm());
    }
    const Vector3 middle = 0.5 * (corners[longest] + corners[(longest + 1) % 3]);
    t.middle = {static_cast<float>(middle.x()), static_cast<float>(middle.y()),
                static_cast<float>(middle.z())};
    // Round the longest edge's middle: a little too large for obtuse triangles.
    constexpr float kAboveRounding = 1.0001F;
    t.radius =
        kAboveRounding * static_cast<float>(std::max(0.5 * edges[longest].norm(),
                                                     (corners[(longest + 2) % 3] - middle).norm()));
    return t;
}

std::array<LowerSquares, 2> all_lower_squares() noexcept {
#ifdef FULCRUM_WIDER_KERNELS
    return {plain_band::lower_squares, has_avx2() ? avx2_band::lower_squares : nullptr};
#else
    return {plain_band::lower_squares, nullptr};
#endif
}

void lower_squares(const BandTriangle& triangle, float band, BrickDistances& squares) noexcept {
    static const LowerSquares widest = widest_of(all_lower_squares());
    widest(triangle, band, squares);
}

}  // namespace fulcrum
