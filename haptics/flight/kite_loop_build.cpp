// The load-path half of kite_loop.h.
#include "haptics/flight/kite_loop.h"

namespace fulcrum {

KiteLoop::KiteLoop(const KiteFlightSettings& settings, double rate_hz, KiteChannels& channels)
    : flight_(settings), channels_(channels), period_s_(1.0 / rate_hz) {}

KiteLoop::~KiteLoop() = default;

}  // namespace fulcrum
