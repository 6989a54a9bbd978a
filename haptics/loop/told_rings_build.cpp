// The load-path half of told_rings.h.
#include "haptics/flight/kite_loop.h"
#include "haptics/loop/told_rings.h"

namespace fulcrum {

ToldRings::ToldRings(const HapticChannels& channels)
    : channels_(channels),
      command_(std::make_unique<Kept<ForceCommand>>()),
      world_(std::make_unique<Kept<WorldFrame>>()),
      reading_(std::make_unique<Kept<ToldReading>>()) {
    if (channels.axles != nullptr) {
        axles_ = std::make_unique<Kept<AxleOrders>>();
    }
    if (channels.rigid != nullptr) {
        rigid_ = std::make_unique<Kept<RigidFrame>>();
    }
    if (channels.kite != nullptr) {
        line_ = std::make_unique<Kept<LineState>>();
    }
}

ToldRings::~ToldRings() = default;

}  // namespace fulcrum
