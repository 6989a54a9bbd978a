// One round of the haptic loop as the recorder keeps it: enough to play the hand again and to
// compare every force.
#pragma once

#include "haptics/base/fault.h"
#include "haptics/handover/force_shares.h"
#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

#include <cstddef>
#include <cstdint>

namespace fulcrum {

/// One round.
struct RecordSample {
    std::uint64_t tick = 0;
    double time_s = 0.0;        ///< of the step, on the run's clock
    double stamp_s = 0.0;       ///< when the device measured the pose
    Pose pose_D{};              ///< as the device gave it, before the workspace is applied
    Twist twist_W{};            ///< estimated, of the tool in the world
    Wrench commanded_W{};       ///< what the scene asked for
    Wrench applied_W{};         ///< what was sent to the device
    std::uint32_t buttons = 0;  ///< one bit a button
    Fault faults = Fault::none;
    GatePhase gate = GatePhase::waiting;
    std::int32_t touched_body = kNoBody;  ///< body under the proxy, or kNoBody
};

/// Haptic loop -> recorder, ring.
struct RecordRound {
    RecordSample sample{};
    ForceShares shares{};
};

inline constexpr std::size_t kRecordRingCapacity = 4096;  ///< samples; 0.8 s at 5 kHz

}  // namespace fulcrum
