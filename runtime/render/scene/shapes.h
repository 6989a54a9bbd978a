// Simple shapes made here: the ball that stands for a missing model, and the parts of an arrow.
//
// Thread: any. Cost: a few thousand corners.
#pragma once

#include "runtime/scene/model.h"

namespace fulcrum::runtime {

/// A ball around the origin, metres, in one colour (linear).
[[nodiscard]] LoadedModel make_ball(float radius_m, std::array<float, 4> colour);

/// A shape of revolution about +Y: `profile` is r, y pairs from the bottom to the top, in metres.
/// Creases are kept where the profile turns by more than 30 degrees.
[[nodiscard]] LoadedModel make_lathe(const std::vector<std::array<float, 2>>& profile,
                                     std::array<float, 4> colour);

/// An arrow's shaft: radius 1, from y = 0 with a round end to y = 1, open at the top.
[[nodiscard]] LoadedModel make_arrow_shaft(std::array<float, 4> colour);
/// An arrow's head: base radius 1 at y = 0, blunt tip at y = 1.
[[nodiscard]] LoadedModel make_arrow_head(std::array<float, 4> colour);

}  // namespace fulcrum::runtime
