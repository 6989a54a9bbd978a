// What a touch was like in one round of the haptic loop: enough to make the sound of a stroke and of a tap from the same
// signals that made the force.
#pragma once

#include "haptics/handover/event_ring.h"
#include "haptics/handover/messages.h"

#include <cstddef>
#include <cstdint>

namespace fulcrum {

/// Of the audible solid that is pressed most. A round in which none is touched tells one sample with `solid` kNoBody when
/// the touch has just ended, and nothing after that.
struct TouchSample {
    double time_s = 0.0;           ///< of the round, on the run's clock
    std::int32_t solid = kNoBody;  ///< index in the plan
    float u_m = 0.0F;  ///< place on the surface: texture coordinates in metres (triplanar.h)
    float v_m = 0.0F;
    float normal_force_N =
        0.0F;  ///< with which the coupling's spring presses, before the gate; 0 or more
    float slip_speed_m_per_s = 0.0F;  ///< of the contact point along the surface; 0 or more
    /// Felt relief: 0 to height_m, filtered along the stroke as the force is; 0 where there is no texture.
    float texture_height_m = 0.0F;
    /// Above zero in the one round in which a tap begins: the speed of the hand against the surface.
    float impact_speed_m_per_s = 0.0F;
};

inline constexpr std::size_t kTouchRingCapacity = 4096;  ///< samples; 0.8 s at 5 kHz

using TouchRing = EventRing<TouchSample, kTouchRingCapacity>;

}  // namespace fulcrum
