// How the force of a round is made up: what each effect of the plan adds to it.
//
//   sum over the effects = what is commanded, before the last gate      (up to the rounding of the sum)
// Which effect has which place is fixed when the loop is built: `HapticLoop::effects`.
#pragma once

#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace fulcrum {

/// What may add to the force, in the order of the step.
enum class Effect : std::uint8_t {
    tool,             ///< the spring between hand and tool
    tool_damping,     ///< the rest of what a tool gives
    contact,          ///< the spring between hand and proxy
    contact_damping,  ///< the damper beside it
    grip,             ///< a body in the hand
    texture,          ///< a surface's relief
    tap,              ///< how a surface rings
    weight,           ///< what lies in the hand
    field,            ///< a declared force field; there may be several
    line,             ///< a kite's line
    lesson,           ///< the lesson's own force
    brake,            ///< the passivity stage
};
inline constexpr std::size_t kEffectKinds = static_cast<std::size_t>(Effect::brake) + 1;
/// Of one loop: it has a tool or a contact, never both.
inline constexpr std::size_t kMostEffects = kEffectKinds - 3 + kMaxFields;

/// One place among the shares.
struct EffectSlot {
    Effect effect = Effect::contact;
    std::int32_t field = -1;  ///< which of the plan's, for Effect::field
};

/// Haptic loop -> whoever tells people why they feel a force, newest value.
struct ForceShares {
    std::int32_t n = 0;                         ///< places that are used
    std::array<Wrench, kMostEffects> each_W{};  ///< n of them; what is behind them is of no round
};

}  // namespace fulcrum
