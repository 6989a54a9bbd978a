// Pairs of triangles on their way that try continuous collision: at chance, and of every kind that is likely to go wrong.
#pragma once

#include "haptics/continuous/sweep.h"
#include "tests/support/wander.h"

#include <array>

namespace fulcrum {

/// A held triangle and one that moves; about a metre large.
struct TrianglePair {
    Triangle fixed_A;
    Triangle moving_B;
    Pose start_AB{};
    Pose end_AB{};
    Vector3 pivot_B{Vector3::Zero()};

    [[nodiscard]] InBetweenMotion motion() const { return {start_AB, end_AB, pivot_B}; }
};

/// Anything: places, sizes, turns up to pi.
[[nodiscard]] TrianglePair draw_pair(Random& random);

/// Kind 0 to kHardPairs - 1. Where nothing else is said, the gap on the way is a millionth to a billionth of a metre, on either side of 0.
inline constexpr int kHardPairs = 12;
inline constexpr std::array<const char*, kHardPairs> kHardPairNames{
    "a corner grazes a face",
    "a face slides along a face",
    "edges that coincide",
    "an edge grazes an edge",
    "slivers, segments and points",
    "half a turn with a long arm",
    "both in one plane",
    "a corner on a corner or an edge",
    "touching only at the beginning or end",
    "nearly no motion, or none",
    "a thousand times its own size a step",
    "far from the origin"};
[[nodiscard]] TrianglePair draw_hard_pair(Random& random, int kind);

}  // namespace fulcrum
