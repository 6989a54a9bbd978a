// For how long a scene asked a hand to feel something, and what became of it at the last gate:
//
//   asked     the command is large enough to be felt
//   felt      what is sent is, asked for or still fading
//   waiting   asked for, and the gate waits for a calm command or a hand that rests
//   taken     asked for, and the gate fades or is stopped: a fault, or a person's stop
//
// Thread: haptic loop; whoever else reads it does so when that has ended. Cost: some nanoseconds a round.
#pragma once

#include "haptics/handover/messages.h"
#include "haptics/math/felt.h"

namespace fulcrum {

struct FeltTime {
    double asked_s = 0.0;
    double felt_s = 0.0;
    double waiting_s = 0.0;  ///< of asked_s
    double taken_s = 0.0;    ///< of asked_s

    /// Of asked_s.
    [[nodiscard]] double shut_s() const noexcept { return waiting_s + taken_s; }
    /// A round of `dt_s` seconds has ended with `state`.
    void add(const HapticState& state, double dt_s) noexcept {
        felt_s += is_felt(state.applied_W) ? dt_s : 0.0;
        if (!is_felt(state.commanded_W)) {
            return;
        }
        asked_s += dt_s;
        waiting_s += state.gate == GatePhase::waiting ? dt_s : 0.0;
        taken_s += state.gate == GatePhase::fading || state.gate == GatePhase::stopped ? dt_s : 0.0;
    }
};

}  // namespace fulcrum
