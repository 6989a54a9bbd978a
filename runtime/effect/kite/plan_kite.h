// The part of a plan that a kite calls for: its flight beside the haptic loop, and its line in the hand.
//
// Thread: load path.
#pragma once

#include "haptics/base/error.h"
#include "runtime/scene/plan.h"

namespace fulcrum::runtime {

/// Adds what the lesson's kite needs, where it has one. Refuses what no kite is, a line that is too stiff for the hand at this
/// scale, and a wind where nothing flies.
[[nodiscard]] Expected<void> add_kite(const LessonDescription& lesson, const PlanOptions& options,
                                      Plan& plan);

/// What its loop takes of memory.
[[nodiscard]] std::size_t count_kite_bytes(const KiteFlightSettings& flight);

/// The flight of the lesson's kite with another design.
[[nodiscard]] KiteFlightSettings with_design(const KiteFlightSettings& flight,
                                             const KiteSettings& design);

}  // namespace fulcrum::runtime
