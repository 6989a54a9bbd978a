// What stands in a record in the words of people: effects, the gate's phases, faults, events, directions.
//
// Thread: any. Cost: a short text.
#pragma once

#include "haptics/base/fault.h"
#include "haptics/handover/force_shares.h"
#include "haptics/math/spatial.h"
#include "haptics/record/record.h"
#include "runtime/scene/description.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// What a loop's effects are called, in their order: "weight", "contact", a declared force by the lesson's name, "force breeze".
[[nodiscard]] std::vector<std::string> effect_words(std::span<const EffectSlot> effects,
                                                    const LessonDescription& lesson);
/// "waiting", "rising", "open", "fading", "stopped".
[[nodiscard]] std::string_view gate_word(GatePhase phase) noexcept;
/// Each that holds, behind commas; "none" where none does.
[[nodiscard]] std::string fault_words(Fault faults);
/// "caught", "said".
[[nodiscard]] std::string_view event_word(RecordEventKind kind) noexcept;
/// "hidden", "placed", "falling", "held", "landed".
[[nodiscard]] std::string_view where_word(BodyWhere where) noexcept;
/// Along which axes a force mainly is, the strongest first: 1, 2, 3 for x, y, z, negative where it runs back; none of no force.
[[nodiscard]] std::vector<int> main_axes(const Vector3& force_W);
/// Where a force pulls the hand, as who sits before the screen says it: "down", "up and left", "towards you"; "-" of no force.
[[nodiscard]] std::string direction_words(const Vector3& force_W);
/// The shortest number that is read as the same one again, in at most 17 digits.
[[nodiscard]] std::string exact_text(double value);

}  // namespace fulcrum::runtime
