// The load-path half of world_loop.h.
#include "haptics/dynamics/world_loop.h"

#include <limits>
#include <utility>

namespace fulcrum {

WorldLoop::WorldLoop(const WorldPlan& plan, std::vector<std::int32_t> solid_bodies,
                     WorldChannels& channels, HapticChannels& haptics)
    : world_(plan),
      period_s_(1.0 / plan.rate_hz),
      solid_bodies_(std::move(solid_bodies)),
      channels_(channels),
      haptics_(haptics),
      snapshots_(channels.snapshot),
      frames_(haptics.world) {
    hand_.proxy_position_W.setConstant(std::numeric_limits<double>::quiet_NaN());
}

WorldLoop::~WorldLoop() = default;

}  // namespace fulcrum
