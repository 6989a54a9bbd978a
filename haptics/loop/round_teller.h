// What a haptic loop tells of its rounds: its state, what each effect adds to the force, every round for the record; and counts of them all.
//
//   begin -> share, as each effect is added -> publish -> record
// Shares are told beside what is summed, so that the sum is the same whether anybody asks or not; where nobody does none is kept.
//
// Thread: the haptic loop's; built before it starts. Cost: three copies of what is told; no allocation after it was built.
#pragma once

#include "haptics/device/device.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/felt_time.h"
#include "haptics/loop/told_rings.h"

#include <array>
#include <cstdint>
#include <vector>

namespace fulcrum {

class RoundTeller {
  public:
    /// Of a loop with these channels, which outlive it, and these effects, each field's behind the one before.
    RoundTeller(HapticChannels& channels, std::vector<EffectSlot> effects);

    /// No effect has added anything in this round; one without a pose tells of none.
    void begin(bool has_pose) noexcept;
    /// What an effect adds; `field`: which of the plan's, for Effect::field.
    void share(Effect effect, const Vector3& force_W, const Vector3& torque_W = Vector3::Zero(),
               std::size_t field = 0) noexcept;
    /// To world and lesson, with the number of the round, which is now set, its time and the shares.
    void publish(HapticState& state, double now_s, double dt_s) noexcept;
    /// For the recorder, of a round that was published, what the device told in it: a fault where there was no room.
    [[nodiscard]] Fault record(const HapticState& state, const DeviceReading& told,
                               const ToldReading& reading) noexcept;

    /// In the order of the shares.
    [[nodiscard]] const std::vector<EffectSlot>& effects() const noexcept { return effects_; }
    [[nodiscard]] const FeltTime& felt_time() const noexcept { return felt_time_; }

  private:
    HapticChannels* channels_;
    std::vector<EffectSlot> effects_;
    std::array<std::int8_t, kEffectKinds> slot_of_{};  // an effect's first place among them
    std::uint64_t tick_ = 0;
    FeltTime felt_time_{};
    bool is_kept_ = false;  // what is shared in this round
    ForceShares shares_{};
};

}  // namespace fulcrum
