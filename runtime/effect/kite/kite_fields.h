// What a lesson says of a kite on a line that the hand holds, and of the wind that it flies in.
#pragma once

#include "runtime/effect/field_list.h"
#include "runtime/effect/kite/kite_description.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

/// Of the kite itself, as it is declared and as it is built anew.
inline constexpr std::tuple kKiteDesign{
    field(&KiteSettings::shape,
          {"shape", choice, "", 0, 0, "nil", "a diamond at first", "diamond delta sled box"}),
    field(&KiteSettings::height_m,
          {"height", number, "metres", 0.1, 5, "nil",
           "from foot to top, 0.8 at first; bridle and knot are made for it"}),
    field(&KiteSettings::width_m,
          {"width", number, "metres", 0.1, 5, "nil", "unfolded, 0.75 at first, of a box 0.4"}),
    field(&KiteSettings::fold_rad,
          {"fold", number, "degrees", 0, 57, "nil",
           "how far each half is bent back, 14 at first; a sled's keels outwards"},
          kPerDegree),
    argument({"cloth", choice, "", 0, 0, "nil",
              "nylon at first; from the lightest: silk, tissue, plastic, cellophane, nylon, paper",
              "plastic tissue nylon paper silk cellophane"}),
    argument({"spar", choice, "", 0, 0, "nil",
              "balsa at first; skewers are a little lighter, birch and tube five times as heavy",
              "balsa birch tube skewer"}),
    field(&KiteSettings::bridle_m,
          {"bridle", number, "metres", 0.1, 50, "nil",
           "the string from the foot over the knot to the top; 1.25 times the height at first"}),
    field(&KiteSettings::knot_m,
          {"knot", number, "metres", 0, 50, "nil",
           "where on the bridle the line is tied, from the foot; 0.85 times the height at first. "
           "Lower, the kite stands steeper in the wind"}),
    field(&KiteSettings::tail_m,
          {"tail", number, "metres", 0, 50, "nil", "how long it is; 2 at first, 0 for none"})};

/// Of its line, and of how it is felt and seen.
inline constexpr std::tuple kKiteLine{
    field([](auto& k) -> auto& { return k.flight.line.length_m; },
          {"line", number, "metres", kShortestReel_m, kLongestReel_m, "20", "let out at first"}),
    field([](auto& k) -> auto& { return k.flight.line.strength_N; },
          {"strength", number, "newtons", 1, 1e6, "150", "the line breaks above it"}),
    field([](auto& k) -> auto& { return k.flight.line.stretch_N; },
          {"stretch", number, "newtons", 10, 1e6, "500",
           "what would make the line twice as long; stretch / 5 times felt times the "
           "hand's scale at most 2000"}),
    field([](auto& k) -> auto& { return k.flight.line.segments; },
          {"segments", integer, "", 1, kMostLineSegments, "16",
           "pieces that the line is computed in"}),
    field(&KiteDescription::share,
          {"felt", number, "", 0.01, 10, "1",
           "newtons in the hand for a newton of the line; where the site allows less than "
           "5 N, less in the same measure"}),
    field(&KiteDescription::seen_scale,
          {"seen", number, "", 1, kMostKiteScale, "1",
           "drawn so many times larger than it is, for it is far away"}),
    field(&KiteDescription::elevation_rad,
          {"elevation", number, "degrees", 0, 85, "40",
           "how steeply the line rises when it is launched"},
          kPerDegree)};

inline constexpr std::tuple kWind{
    field(&WindDescription::speed_m_per_s,
          {"speed", number, "metres per second", 0, kFastestWind_m_per_s, "6",
           "10 metres above the ground; less below"}),
    field(&WindDescription::gustiness,
          {"gusts", number, "", 0, 4, "0", "0 is a steady wind, 1 as it usually is, 4 wild"}),
    argument(
        {"towards", vector, "", -1, 1, "{1, 0, 0}", "the direction it blows to, along the ground"}),
    argument({"over", choice, "", 0, 0, "grass",
              "what it comes over: the rougher, the less near the ground",
              "water grass bushes town"})};

}  // namespace fulcrum::runtime::fields
