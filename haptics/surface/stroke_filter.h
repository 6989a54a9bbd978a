// Weights for averaging a relief along the stroke, so that what lies above half the loop's rate is removed, not folded.
//
// A hand that strokes with delta metres a round feels a wave of f per metre at nu = f |delta| waves a round; from nu = 1/2 on
// the loop cannot give it, and would give a slow wave in its place. The relief is known ahead of the hand as well as
// behind it, so it is averaged about the place where the hand is, without any delay:
//
//   g(p) = sum over j of w_j g(p + (j / m) delta),   |j| <= kReach m,     sum of the w_j = 1
//   w_j  = sinc(2 nu_c j / m) kaiser(j / (m kReach)),   nu_c = (kPass + kStop) / 2
//
// passes nu <= kPass within kRipple, removes kStop <= nu <= m - kStop to below kRemoved. m samples a round are enough for
// waves up to m - kStop. On a straight stroke of even speed this is exact; one that turns within 2 kReach rounds is
// averaged along its tangent. A hand at rest has delta = 0 and feels the relief itself.
//
// Thread: any; a table that is filled when the program starts. Cost: 2 kReach m + 1 samples of the relief.
// Source: J. F. Kaiser 1974, Nonrecursive digital filter design using the I0-sinh window function, Proc. IEEE Int. Symp.
// Circuits and Systems: window, length and attenuation.
#pragma once

#include <span>

namespace fulcrum {

inline constexpr double kStrokePass = 0.3;      ///< waves a round that are felt in full
inline constexpr double kStrokeStop = 0.5;      ///< waves a round from which on none is felt
inline constexpr double kStrokeRipple = 0.01;   ///< of the amplitude
inline constexpr double kStrokeRemoved = 0.01;  ///< of the amplitude: -40 dB
inline constexpr int kStrokeReach = 7;          ///< rounds to either side
inline constexpr int kMostPerRound = 8;         ///< m at most

/// The weights for m samples a round, 1 to kMostPerRound; the middle one is at 0.
[[nodiscard]] std::span<const double> stroke_weights(int per_round) noexcept;

/// How many samples a round, 0 for the relief itself without a filter, a content of up to `waves` a round needs; at most
/// kMostPerRound, which serves for kMostPerRound - kStrokeStop waves.
[[nodiscard]] int choose_samples_per_round(double waves) noexcept;

}  // namespace fulcrum
