// What a lesson may say, from least to most: the binding table tells it the lesson's side, the wire holds the program's side to it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fulcrum::runtime {

// The lesson itself, and the scene.
inline constexpr std::size_t kMostTitleBytes = 200;
inline constexpr std::size_t kMostLevelBytes = 16;
inline constexpr double kMostMinutes = 1000.0;
inline constexpr double kLeastForceLimit_N = 0.5;
inline constexpr double kMostForceLimit_N = 10.0;
inline constexpr double kMostGravity_m_per_s2 = 100.0;
inline constexpr double kFarthestGround_m = 100.0;
inline constexpr double kLeastView_deg = 5.0;
inline constexpr double kMostView_deg = 120.0;

// Bodies and the bucket.
inline constexpr std::size_t kMostNounBytes = 64;
inline constexpr std::size_t kMostAboutBytes = 300;
inline constexpr double kLeastRadius_m = 0.001;
inline constexpr double kMostRadius_m = 10.0;
inline constexpr double kMostBodyMass_kg = 1e4;
inline constexpr double kMostExaggeration = 100.0;
inline constexpr double kMostDragArea_m2 = 10.0;
inline constexpr int kMostHeld = 8;
inline constexpr double kMostJointTravel = 1e4;  ///< degrees or metres, a second too
inline constexpr double kMostJointForce = 1e4;   ///< newtons or newton metres

// Declared forces and the hand.
inline constexpr double kMostSpring_N_per_m = 2000.0;
inline constexpr double kMostFieldDamping_Ns_per_m = 50.0;
inline constexpr double kMostMagnet_N = 10.0;
inline constexpr double kLeastMagnetRange_m = 0.001;
inline constexpr double kMostMagnetRange_m = 10.0;
inline constexpr double kLeastHandScale = 0.01;
inline constexpr double kMostHandScale = 100.0;
inline constexpr double kLeastHandRate_Hz = 1000.0;
inline constexpr double kMostHandRate_Hz = 5000.0;
inline constexpr double kFarthestAim_m =
    10'100.0;  ///< of a simulated hand: from the scene's edge a metre of its own at the largest scale

// Surfaces.
inline constexpr double kMostFriction = 5.0;
inline constexpr double kLeastRelief_m = 1e-4;  ///< width of a groove, a bump or a picture
inline constexpr double kWidestRelief_m = 1.0;
inline constexpr double kWidestPicture_m = 100.0;
inline constexpr double kHighestRelief_m = 0.01;
inline constexpr double kMostReliefGain = 100.0;
inline constexpr double kMostTap_Ns_per_m = 100.0;

// A kite and its wind.
inline constexpr double kLeastKite_m = 0.1;
inline constexpr double kMostKite_m = 5.0;
inline constexpr double kMostString_m = 50.0;
inline constexpr double kLeastLineStrength_N = 1.0;
inline constexpr double kLeastLineStretch_N = 10.0;
inline constexpr double kMostLine_N = 1e6;
inline constexpr double kLeastKiteShare = 0.01;
inline constexpr double kMostKiteShare = 10.0;
inline constexpr double kMostGusts = 4.0;

// What it does while it runs.
inline constexpr std::int32_t kMostScore = 1'000'000;
inline constexpr std::int32_t kMostLevel = 99;
inline constexpr std::int32_t kMostStars = 3;
inline constexpr double kMostTurn_deg = 1e6;

}  // namespace fulcrum::runtime
