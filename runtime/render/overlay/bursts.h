// A burst where something was caught or answered rightly: a dozen small soft stars and dots that fly apart, sink and fade.
//
//   place(t) = at + R (1 - exp(-4 t/T)) (cos u_i, sin u_i) + fall (t/T)^2, alpha = 1 - (t/T)^2
// A function of its age and nothing else.
//
// Thread: one. Cost: a dozen small shapes a burst.
#pragma once

#include "runtime/render/camera.h"
#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/overlay/measure.h"
#include "runtime/scene/view.h"

namespace fulcrum::runtime {

inline constexpr float kBurstReach = 74.0F;  ///< at 720, from its middle to where a star ends
inline constexpr float kBurstFall = 26.0F;   ///< at 720

void draw_bursts(const std::vector<ViewBurst>& bursts, const Camera& camera, const Measure& measure,
                 DrawList& list);

}  // namespace fulcrum::runtime
