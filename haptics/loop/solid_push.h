// How a hand presses a solid, with a point or with a tool.
//
//   F = minus the share of the coupling's force that this solid holds:  sum(push n + drag) over its touches against the same of all
// It presses where the cursor touches that solid, along that solid's own planes. No solid is given more than the gate may let through to
// the hand in this round: what the hand does not feel moves nothing, two solids that wedge it in included.
//
// Thread: haptic loop. Cost: 20 ns a solid; no allocation.
#pragma once

#include "haptics/math/spatial.h"
#include "haptics/point/proxy.h"

#include <cstdint>

namespace fulcrum {

struct SolidPush {
    bool touches = false;
    Vector3 at_W{Vector3::Zero()};
    Vector3 force_W{Vector3::Zero()};   ///< on the solid, at that place
    Vector3 couple_W{Vector3::Zero()};  ///< on it as well, wherever
    Vector3 normal_W{Vector3::Zero()};  ///< into the solid, of any length: where it is pushed to
};

/// What the coupling does in this round.
struct HandPush {
    Vector3 force_W{Vector3::Zero()};  ///< on the hand
    double most_N = 0.0;               ///< that the hand may feel (SafetyGate::find_most_N)
};

/// What a hand may feel next (SafetyGate::find_most_N and find_most_Nm), seen in the world.
struct MostFelt {
    double force_N = 0.0;
    double torque_Nm = 0.0;
};

/// The share of the hand's force that one solid takes, all of it where it alone is touched. `cursor_m`: from the proxy to where it touches.
[[nodiscard]] SolidPush compute_solid_push(const ProxyContact& contact, std::int32_t solid,
                                           const Vector3& force_W, double cursor_m) noexcept;
/// What is left of a push, each 0 to 1.
struct PushShare {
    double force = 1.0;
    double couple = 1.0;
};

/// No more than the hand may feel: a couple is drawn together with the force that comes with it, and by itself.
PushShare limit_push(const MostFelt& most, SolidPush& push) noexcept;

}  // namespace fulcrum
