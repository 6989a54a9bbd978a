#include "runtime/app/run_tape.h"

#include "haptics/loop/haptic_loop.h"

namespace fulcrum::runtime {

void RunTape::keep_frame(const SessionOutput& output) {
    if (n_rounds() < kMostTapedRounds) {
        frames_.push_back({n_rounds(), output.force, static_cast<const EffectOrders&>(output)});
    }
}

void RunTape::keep_round(const std::vector<const HapticLoop*>& loops) {
    if (n_rounds() >= kMostTapedRounds) {
        return;
    }
    for (const HapticLoop* const loop : loops) {
        const HapticState& state = loop->state();
        rounds_.push_back({loop->told(), state.faults, state.gate, state.applied_W});
    }
}

}  // namespace fulcrum::runtime
