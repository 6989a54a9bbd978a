// What a lesson may say beside its effects' fields (runtime/effect), from least to most: the binding table tells it the lesson's side, the
// wire holds the program's side to it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fulcrum::runtime {

// The lesson itself, and the scene.
inline constexpr double kMaxCoordinate_m = 1e4;
inline constexpr std::size_t kMostTitleBytes = 200;
inline constexpr std::size_t kMostLevelBytes = 16;
inline constexpr double kMostMinutes = 1000.0;
inline constexpr double kLeastForceLimit_N = 0.5;
inline constexpr double kMostForceLimit_N = 10.0;
inline constexpr double kMostMark_N = 1000.0;  ///< that is shown beside a thing

// A simulated hand.
inline constexpr double kFarthestAim_m =
    10'100.0;  ///< of a simulated hand: from the scene's edge a metre of its own at the largest scale

// What it does while it runs.
inline constexpr std::int32_t kMostScore = 1'000'000;
inline constexpr std::int32_t kMostLevel = 99;
inline constexpr std::int32_t kMostStars = 3;
inline constexpr double kMostTurn_deg = 1e6;

}  // namespace fulcrum::runtime
