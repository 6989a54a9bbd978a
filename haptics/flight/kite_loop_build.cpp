// The load-path half of kite_loop.h.
#include "haptics/flight/kite_loop.h"

#include <memory>

namespace fulcrum {

KiteLoop::KiteLoop(const KiteFlightSettings& settings, double rate_hz, KiteChannels& channels)
    : flight_(std::make_unique<KiteFlight>(settings).release()),
      channels_(channels),
      period_s_(1.0 / rate_hz) {}

KiteLoop::~KiteLoop() {
    const std::unique_ptr<KiteFlight> own(flight_);
}

}  // namespace fulcrum
