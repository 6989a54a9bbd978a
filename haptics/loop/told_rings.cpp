// The step path of told_rings.h.
#include "haptics/loop/told_rings.h"

#include "haptics/flight/kite_loop.h"

namespace fulcrum {

template <class T>
bool ToldRings::keep_newer(std::uint64_t tick, const LatestValue<T>& from, Kept<T>& kept) noexcept {
    if (from.n_taken() == kept.n_seen) {
        return true;
    }
    kept.n_seen = from.n_taken();
    return kept.ring.push_by([&](Told<T>& slot) {
        slot.tick = tick;
        slot.value = from.value();
    });
}

bool ToldRings::keep(std::uint64_t tick, const ToldReading& reading) noexcept {
    bool kept = keep_newer(tick, channels_.command, *command_);
    kept = keep_newer(tick, channels_.world, *world_) && kept;
    if (axles_) {
        kept = keep_newer(tick, channels_.axles->orders, *axles_) && kept;
    }
    if (rigid_) {
        kept = keep_newer(tick, channels_.rigid->frame, *rigid_) && kept;
    }
    if (line_) {
        kept = keep_newer(tick, channels_.kite->line, *line_) && kept;
    }
    // Nearly always there is nothing to tell.
    if (any(reading.faults) || !reading.is_reading) {
        kept = reading_->ring.push({tick, reading}) && kept;
    }
    return kept;
}

std::uint64_t ToldRings::dropped() const noexcept {
    const auto of = [](const auto& kept) { return kept ? kept->ring.dropped() : std::uint64_t{0}; };
    return of(command_) + of(world_) + of(axles_) + of(rigid_) + of(line_) + of(reading_);
}

}  // namespace fulcrum
