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
    /// The lesson's simulated hand goes there.
    void aim(const HandWish& wanted);
};

using RunHands = std::vector<std::unique_ptr<RunHand>>;

// Of each of them.
[[nodiscard]] std::vector<HapticChannels*> channels_of(const RunHands& hands);
[[nodiscard]] std::vector<const HapticLoop*> loops_of(const RunHands& hands);
[[nodiscard]] std::vector<DeviceTraits> traits_of(const RunHands& hands);
[[nodiscard]] std::vector<FeltTime> felt_times_of(const RunHands& hands);

}  // namespace fulcrum::runtime
