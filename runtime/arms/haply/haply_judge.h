// Which arm of the service may be held, and whether it is still as it was: every refusal in a sentence for a teacher.
//
// Forces are refused by an arm that is not calibrated, has no power, is held by somebody else, or whose session is turned, moved or
// stretched: a mirrored basis keeps the power and shows the world turned, a stretched mount multiplies every stiffness.
//
// Thread: any. Cost: microseconds; allocates.
// Source: docs.haply.co/inverseSDK/service: session-configuration/sessions and commons/mount-and-workspace tell that other programs
// may change a session; status fields by jhu-saw/sawHaplyService, mtsHaply.cpp.
#pragma once

#include "runtime/arms/haply/haply_message.h"

namespace fulcrum::runtime {

/// The arm of a first message: the one with this id, or where that is empty the only one. Refuses where there is none or are several.
[[nodiscard]] Expected<HaplyArm> choose_haply_arm(const HaplyMessage& first, const std::string& id);

/// Refuses one that may not be held when a session begins.
[[nodiscard]] Expected<void> check_haply_arm(const HaplyArm& arm);

/// Why it may not be pushed now, a sentence's clause; empty where it may. `known` is what was said of it before.
[[nodiscard]] std::string find_haply_trouble(const HaplyStatus& known);
/// What a message says of an arm, over what was known.
void update(HaplyStatus& known, const HaplyStatus& said) noexcept;

/// What somebody has changed since the session began, by name ("the basis"); empty where nothing has. `now` may have no configuration.
[[nodiscard]] std::string find_haply_change(const HaplyArm& first, const HaplyArm& now);

/// "Haply Inverse3 049D".
[[nodiscard]] std::string name_haply_arm(const HaplyArm& arm);

/// Half the size of the ball that the handle can reach, m.
[[nodiscard]] double find_haply_reach_m(const HaplyConfig& config);

}  // namespace fulcrum::runtime
