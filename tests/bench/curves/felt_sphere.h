// A hand that strokes a ball along a circle through its middle, and what is sent to it: shared by ours and its peers.
#pragma once

#include "haptics/math/spatial.h"
#include "tests/bench/harness/report.h"

#include <functional>
#include <string>
#include <vector>

namespace fulcrum::bench {

inline constexpr double kStrokedBall_m = 0.1;
inline constexpr double kStrokePush_N = 2.0;
inline constexpr double kStrokeSpeed_m_per_s = 0.2;

/// Newtons that are sent to a hand at a place; called once a millisecond.
using Send = std::function<Vector3(const Vector3& hand_W)>;

/// What was sent in the second of two rounds about the ball.
struct SentStroke {
    double sideways_N = kNone;  ///< root mean square of what lies along the true surface
    double angle_deg = kNone;   ///< the same of the angle to the true normal
    double jump_N = kNone;      ///< 99 % of the rounds change by no more
    double energy_mJ = kNone;   ///< given to the hand in the circle
    double mean_N = kNone;      ///< along the true normal
};

/// The hand comes from outside, stays `depth_m` below the true surface, and goes about at kStrokeSpeed.
[[nodiscard]] SentStroke stroke_ball(const Send& send, double depth_m);
/// What a round costs meanwhile.
[[nodiscard]] Cost measure_stroke(const Send& send, double depth_m);

/// Frequencies of the balls, 20 f^2 triangles each.
[[nodiscard]] std::vector<int> stroked_balls(bool quick);

/// A point of the curve `felt-sphere`.
[[nodiscard]] CostPoint to_point(const std::string& series, double n_triangles,
                                 const SentStroke& sent, const Cost& cost);

}  // namespace fulcrum::bench
