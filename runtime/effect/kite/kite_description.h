// A kite and its wind as a lesson declares them.
#pragma once

#include "haptics/flight/kite_flight.h"

#include <cstdint>
#include <string>

namespace fulcrum::runtime {

inline constexpr double kShortestReel_m = 5.0;   ///< no reel takes more line in ...
inline constexpr double kLongestReel_m = 200.0;  ///< ... or lets more out
/// How fast a button turns the reel, and how far a notch of the wheel does.
inline constexpr double kReelByButton_m_per_s = 2.0;
inline constexpr double kReelByNotch_m = 0.5;
inline constexpr double kMostKiteScale = 10.0;

struct KiteDescription {
    KiteFlightSettings flight{};  ///< its wind, gravity and ground are the lesson's, see below
    std::string cloth = "nylon";  ///< names of what it is made of
    std::string spar = "balsa";
    double share = 1.0;          ///< felt newtons a newton of the line
    double seen_scale = 1.0;     ///< drawn so many times larger than it is
    double elevation_rad = 0.7;  ///< of the line where it begins, and after each launch; 0 to 1.5
    std::int32_t line = 0;       ///< of lesson.lua
};

struct WindDescription {
    double speed_m_per_s = 6.0;  ///< at 10 metres
    double gustiness = 0.0;
    double roughness_m = 0.03;             ///< of the ground
    Vector3 downwind_W{Vector3::UnitX()};  ///< unit, level
    std::int32_t line = 0;                 ///< of lesson.lua; 0: never declared
};

}  // namespace fulcrum::runtime
