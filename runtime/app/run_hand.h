// One hand of a run: its device, its loop, and what goes between both and the rest of the run.
//
// Thread: `loop` belongs to the hands' thread, `channels` to both sides, all else to the lesson's.
#pragma once

#include "haptics/loop/haptic_loop.h"
#include "runtime/app/hand_channels.h"
#include "runtime/app/hand_choice.h"
#include "runtime/app/hand_device.h"
#include "runtime/lesson/hand_fit.h"
#include "runtime/lesson/scenery.h"
#include "runtime/lesson/session.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// What the lesson's simulated hand wants of somebody at a desk.
struct HandWish {
    Pose target_W{};
    std::uint32_t buttons = 0;
    std::string key;  ///< to be pressed once; empty for none
};

struct RunHand {
    HandChannels channels{};
    std::unique_ptr<HandChannels> told;  ///< by a record, which tells all; else null
    std::unique_ptr<HandDevice> device;
    std::unique_ptr<HapticLoop> loop;
    std::optional<HandWish> wish;
    std::shared_ptr<const Record> replayed;  ///< of this hand alone; null where none is repeated
    HandChoice choice{};                     ///< as it was settled
    HandFit fit{};                           ///< said and kept

    /// Those of the loop: in a run that is told by a record, others than those that the rest of the run has.
    [[nodiscard]] HapticChannels& loop_channels() { return told ? *told : channels; }
    /// `is_told`: a record tells the loop what it is told.
    void build_loop(const Plan& plan, const HapticPlan& own, bool is_told);
    /// Fills in how much memory the loop, of that name in the plan, uses for each of its stages.
    void measure(const std::string& name, std::vector<PlanStage>& stages) const;
    /// As of the lesson's last frame.
    [[nodiscard]] const HapticState& state() const { return channels.state_for_lesson.value(); }
    /// The hand as lesson and picture see it: one without motors with what would be felt, for no force can hurt there, and a gate that
    /// waits would leave nothing to be seen. Nothing while it is stopped or anything is wrong.
    [[nodiscard]] HapticState seen() const;
    /// The same as it is drawn; `ghost` where a pointer shows where the hand itself is.
    [[nodiscard]] HandScenery scenery() const;
    /// For how long it was asked to feel something; of one without motors: what it would have felt. While the loop does not step.
    [[nodiscard]] FeltTime felt_time() const;
    /// True while the device gives no poses or takes no forces.
    [[nodiscard]] bool is_lost() const;
    /// True while a force or a torque waits at the gate, which has these limits, for the hand to rest.
    [[nodiscard]] bool holds_back(const SafetySettings& limits) const;
    /// What the newest reply of the lesson's simulated hand wants of somebody at a desk; nothing before the first. Taken, its key is pressed.
    [[nodiscard]] std::optional<HandWish> take_wish();
    /// The lesson's simulated hand goes there.
    void aim(const HandWish& wanted);
};

using RunHands = std::vector<std::unique_ptr<RunHand>>;

/// The hand that is moved so, counted from 0; none where no hand is. What was unplugged is moved by the mouse.
[[nodiscard]] std::optional<std::size_t> find_hand(const RunHands& hands, HandKind kind);
/// Whether any hand's device gives forces.
[[nodiscard]] bool renders_force(const RunHands& hands);
/// True while a device gives no poses or takes no forces.
[[nodiscard]] bool device_is_lost(const RunHands& hands);
/// True while a force or a torque waits at any gate for its hand to rest.
[[nodiscard]] bool holds_back(const RunHands& hands, const Plan& plan);
/// What has happened to the devices since the last call, a sentence; empty when nothing has.
[[nodiscard]] std::string take_device_notice(const RunHands& hands);
/// Takes what the loops tell the lesson of them.
void look(const RunHands& hands, SessionInput& gathered);
/// Simulated ones go where their scripts want, and the first one, on an arm on which things break, to what it `sees`.
void lead(const RunHands& hands, const SessionOutput& output, const std::optional<Vector3>& sees);
/// Where the hands are, as they are drawn.
void show(const RunHands& hands, Scenery& scenery);
// Of each of them.
[[nodiscard]] std::vector<HapticChannels*> channels_of(const RunHands& hands);
[[nodiscard]] std::vector<const HapticLoop*> loops_of(const RunHands& hands);
[[nodiscard]] std::vector<DeviceTraits> traits_of(const RunHands& hands);
[[nodiscard]] std::vector<FeltTime> felt_times_of(const RunHands& hands);

}  // namespace fulcrum::runtime
