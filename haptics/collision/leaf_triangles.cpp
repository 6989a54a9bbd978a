#include "haptics/collision/leaf_triangles.h"

#include "haptics/math/orientation.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

// What rounding to single precision may amount to, of the lengths involved, with the leaf's radius 1: the errors of three sums of three
// products each, of numbers that were rounded themselves, add up to at most 7 2^-24 |p| + 5 2^-24 |half| + 20 2^-24, and that of the
// comparison of squares to 5 2^-24 of the distance. This is more than three times as much.
constexpr double kRounding = 0x1.0p-19;
// The same for the sphere round a leaf, in double precision.
constexpr double kSphereRounding = 1.0e-9;

// By value, so that a loop of them needs no branches; inline, for a loop with calls is not run for eight triangles at once.
[[gnu::always_inline]] inline float larger_of(float a, float b) noexcept {
    return a > b ? a : b;
}

// Not below 0, and within 0 and 1: comparisons with constants would become branches.
[[gnu::always_inline]] inline float not_below_0(float a) noexcept {
    return 0.5F * (a + std::abs(a));
}

[[gnu::always_inline]] inline float within_0_and_1(float a) noexcept {
    return 0.5F * (std::abs(a) - std::abs(a - 1.0F) + 1.0F);
}

// A vector of numbers that stay in registers.
struct Lane {
    float x;
    float y;
    float z;
};

[[gnu::always_inline]] inline float dot(const Lane& a, const Lane& b) noexcept {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// a - t b
[[gnu::always_inline]] inline Lane take_off(const Lane& a, float t, const Lane& b) noexcept {
    return {a.x - t * b.x, a.y - t * b.y, a.z - t * b.z};
}

// From the nearest point of an edge that begins at the origin.
[[gnu::always_inline]] inline Lane from_edge(const Lane& to, const Lane& edge,
                                             float per_square) noexcept {
    return take_off(to, within_0_and_1(dot(to, edge) * per_square), edge);
}

// Rounding turns it a little, which does no harm.
[[gnu::always_inline]] inline Lane shorter_of(const Lane& a, const Lane& b) noexcept {
    const float is_b = 0.5F - std::copysign(0.5F, dot(b, b) - dot(a, a));
    return take_off(a, is_b, take_off(a, 1.0F, b));
}

// One over the square of an edge; any number does for an edge without length.
float find_inverse(const Vector3& edge) noexcept {
    const double square = edge.squaredNorm();
    return square > 0.0 ? static_cast<float>(1.0 / square) : 0.0F;
}

}  // namespace

void LeafTriangles::load(const CollisionMesh& mesh, std::int32_t leaf) noexcept {
    leaf_ = leaf;
    const std::int32_t first = leaf * kWidth;
    const std::int32_t n = std::min(kWidth, mesh.n_triangles() - first);
    present_ = (1U << static_cast<unsigned>(n)) - 1U;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled below
    std::array<std::array<Vector3, 3>, kWidth> corners;
    Vector3 lower = mesh.vertex_B(mesh.corners(first)[0]);
    Vector3 upper = lower;
    for (std::int32_t i = 0; i < kWidth; ++i) {
        // Absent ones are as the first.
        std::array<Vector3, 3>& own = corners[static_cast<std::size_t>(i)];
        own = mesh.places_B(first + (i < n ? i : 0));
        for (const Vector3& corner : own) {
            lower = lower.cwiseMin(corner);
            upper = upper.cwiseMax(corner);
        }
    }
    middle_B_ = 0.5 * (lower + upper);
    radius_m_ = 0.5 * (upper - lower).norm() * (1.0 + kSphereRounding);
    radii_per_m_ = radius_m_ > 0.0 ? 1.0 / radius_m_ : 0.0;
    for (std::size_t i = 0; i < kWidth; ++i) {
        const Vector3 a = (corners[i][0] - middle_B_) * radii_per_m_;
        const Vector3 ab = (corners[i][1] - corners[i][0]) * radii_per_m_;
        const Vector3 ac = (corners[i][2] - corners[i][0]) * radii_per_m_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<Index>(axis);
            a_[axis][i] = static_cast<float>(a[k]);
            ab_[axis][i] = static_cast<float>(ab[k]);
            ac_[axis][i] = static_cast<float>(ac[k]);
        }
        per_ab_ab_[i] = find_inverse(ab);
        per_ac_ac_[i] = find_inverse(ac);
        per_bc_bc_[i] = find_inverse(ac - ab);
    }
}

unsigned LeafTriangles::find_near(const Vector3& middle_B, const Vector3& half_B,
                                  double distance_m) const noexcept {
    const Vector3 place = (middle_B - middle_B_) * radii_per_m_;
    const Vector3 way = half_B * radii_per_m_;
    const double distance = distance_m * radii_per_m_;
    const double slack = kRounding * (place.norm() + way.norm() + distance + 2.0);
    const auto enough = static_cast<float>((distance + slack) * (distance + slack));
    const Lane at{static_cast<float>(place.x()), static_cast<float>(place.y()),
                  static_cast<float>(place.z())};
    const Lane half{static_cast<float>(way.x()), static_cast<float>(way.y()),
                    static_cast<float>(way.z())};
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled by the loop
    alignas(32) Row rest;
    for (std::size_t i = 0; i < kWidth; ++i) {
        const Lane ab{ab_[0][i], ab_[1][i], ab_[2][i]};
        const Lane ac{ac_[0][i], ac_[1][i], ac_[2][i]};
        const Lane from_a = take_off(at, 1.0F, {a_[0][i], a_[1][i], a_[2][i]});
        const Lane from_b = take_off(from_a, 1.0F, ab);
        const Lane bc = take_off(ac, 1.0F, ab);
        const Lane u = shorter_of(
            shorter_of(from_edge(from_a, ab, per_ab_ab_[i]), from_edge(from_a, ac, per_ac_ac_[i])),
            from_edge(from_b, bc, per_bc_bc_[i]));
        const float highest = not_below_0(larger_of(dot(u, ab), dot(u, ac)));
        const float above = dot(u, from_a) - highest - std::abs(dot(u, half));
        rest[i] = above * std::abs(above) - enough * dot(u, u);
    }
    return find_not_above_0(rest);
}

unsigned LeafTriangles::find_not_above_0(const Row& numbers) const noexcept {
    unsigned found = 0;
    for (unsigned i = 0; i < kWidth; ++i) {
        found |= numbers[i] > 0.0F ? 0U : 1U << i;
    }
    return found & present_;
}

}  // namespace fulcrum
