// What lessons and the effects that run beside the hands say to each other, besides each effect's own channels.
#pragma once

#include "haptics/flight/kite_loop.h"
#include "haptics/handover/axle_messages.h"
#include "haptics/handover/messages.h"

#include <optional>
#include <vector>

namespace fulcrum::runtime {

/// The newest that each told; null where the lesson has none, and before its first round.
struct EffectFrames {
    const WorldSnapshot* world = nullptr;
    const AxleFrame* axles = nullptr;
    const KiteFrame* kite = nullptr;
};

/// What a lesson orders of them.
struct EffectOrders {
    std::vector<WorldCommand> world;            ///< in this frame
    AxleOrders axles{};                         ///< so far
    KiteOrders kite{};                          ///< likewise
    std::optional<KiteSettings> kite_design{};  ///< another kite, to be flown from now on
};

}  // namespace fulcrum::runtime
