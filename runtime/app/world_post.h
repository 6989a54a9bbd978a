// What a lesson asks of the world, on its way there: a command that got lost would leave the lesson waiting for ever for what it asked, so
// while the world has no room they wait here, in order.
//
// Thread: the lesson's.
#pragma once

#include "haptics/base/error.h"
#include "haptics/handover/channels.h"

#include <cstddef>
#include <deque>
#include <span>

namespace fulcrum::runtime {

class WorldPost {
  public:
    static constexpr std::size_t kMostWaiting =
        8192;  ///< some ten seconds of nine bodies that all move

    /// Hands over what waits and then these, as many as the world has room for; says so when more wait than may.
    [[nodiscard]] Expected<void> send(std::span<const WorldCommand> commands,
                                      WorldCommandRing& world);
    [[nodiscard]] std::size_t n_waiting() const noexcept { return waiting_.size(); }

  private:
    std::deque<WorldCommand> waiting_;
};

}  // namespace fulcrum::runtime
