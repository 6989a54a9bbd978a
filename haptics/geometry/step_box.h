// Boxes in 16-bit steps, eight at a time: what a node of a bounding tree is made of.
//
// The grid cuts a root box into 65534 steps an axis. to_step(x) = floor((x - lower) steps_per_m), clamped; it is monotone, in
// rounded arithmetic too, so boxes that overlap in metres overlap in steps.
//
// Thread: any. Cost: eight boxes against one in 12 comparisons.
#pragma once

#include "haptics/math/spatial.h"

#include <array>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace fulcrum {

/// An axis-aligned box; empty when a lower coordinate exceeds the upper.
struct Box {
    Vector3 lower{Vector3::Zero()};
    Vector3 upper{Vector3::Zero()};

    [[nodiscard]] bool contains(const Vector3& p) const noexcept {
        return all_at_most(lower, p) && all_at_most(p, upper);
    }
    [[nodiscard]] bool overlaps(const Box& other) const noexcept {
        return all_at_most(lower, other.upper) && all_at_most(other.lower, upper);
    }
    /// What both have in common.
    [[nodiscard]] Box cut_to(const Box& other) const noexcept {
        return {lower.cwiseMax(other.lower), upper.cwiseMin(other.upper)};
    }
};

struct StepBox {
    std::array<std::int16_t, 3> lower{};
    std::array<std::int16_t, 3> upper{};
};

/// Eight boxes, by axis and then by box.
struct EightBoxes {
    alignas(16) std::array<std::array<std::int16_t, 8>, 3> lower;
    alignas(16) std::array<std::array<std::int16_t, 8>, 3> upper;
};

class StepGrid {
  public:
    /// Steps run from -32767 to 32766. The two values left over make the box of an absent child, which nothing overlaps.
    static constexpr double kSteps = 65533.0;
    static constexpr std::int32_t kMiddle = 32767;

    StepGrid() = default;
    /// Over a box of which no side counts as thinner than `thinnest_m` > 0.
    StepGrid(const Box& root, double thinnest_m) noexcept : lower_(root.lower) {
        steps_per_m_ = kSteps * (root.upper - root.lower).cwiseMax(thinnest_m).cwiseInverse();
    }

    [[nodiscard]] StepBox to_steps(const Box& box) const noexcept {
        StepBox steps;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<Index>(axis);
            steps.lower[axis] = to_step(box.lower[i], i);
            steps.upper[axis] = to_step(box.upper[i], i);
        }
        return steps;
    }
    /// Of boxes that were made so: all that one of them holds, and a step beyond.
    [[nodiscard]] Box to_box(const EightBoxes& eight, int which) const noexcept {
        Box box;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<Index>(axis);
            const auto child = static_cast<std::size_t>(which);
            box.lower[i] = lower_[i] + (eight.lower[axis][child] + (kMiddle - 1)) / steps_per_m_[i];
            box.upper[i] = lower_[i] + (eight.upper[axis][child] + (kMiddle + 2)) / steps_per_m_[i];
        }
        return box;
    }
    /// A place between steps, not rounded.
    [[nodiscard]] double to_place(double coordinate, Index axis) const noexcept {
        return (coordinate - lower_[axis]) * steps_per_m_[axis] - kMiddle;
    }
    [[nodiscard]] double steps_per_m(Index axis) const noexcept { return steps_per_m_[axis]; }

  private:
    [[nodiscard]] std::int16_t to_step(double coordinate, Index axis) const noexcept {
        const double step = (coordinate - lower_[axis]) * steps_per_m_[axis];
        const double inside = step < 0.0 ? 0.0 : (step > kSteps ? kSteps : step);
        return static_cast<std::int16_t>(static_cast<std::int32_t>(inside) - kMiddle);
    }

    Vector3 lower_{Vector3::Zero()};
    Vector3 steps_per_m_{Vector3::Ones()};
};

/// One bit for each of the eight that overlaps `box`; 0 for absent ones.
[[nodiscard]] inline unsigned find_overlapping(const EightBoxes& eight,
                                               const StepBox& box) noexcept {
#if defined(__SSE2__)
    __m128i apart = _mm_setzero_si128();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const __m128i lower =
            _mm_load_si128(reinterpret_cast<const __m128i*>(eight.lower[axis].data()));
        const __m128i upper =
            _mm_load_si128(reinterpret_cast<const __m128i*>(eight.upper[axis].data()));
        apart = _mm_or_si128(apart, _mm_cmpgt_epi16(lower, _mm_set1_epi16(box.upper[axis])));
        apart = _mm_or_si128(apart, _mm_cmpgt_epi16(_mm_set1_epi16(box.lower[axis]), upper));
    }
    return ~static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(apart, apart))) & 0xFFU;
#else
    unsigned overlapping = 0;
    for (unsigned child = 0; child < 8; ++child) {
        bool apart = false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            apart = apart || eight.lower[axis][child] > box.upper[axis] ||
                    box.lower[axis] > eight.upper[axis][child];
        }
        overlapping |= (apart ? 0U : 1U) << child;
    }
    return overlapping;
#endif
}

}  // namespace fulcrum
