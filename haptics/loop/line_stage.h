// A line in the hand as a stage of the haptic loop: takes the newest state of the line, gives its wrench, and tells the line's own
// loop where the hand is, when that is known: a pose that is no hand's must not draw a line.
//
// Thread: haptic loop. Cost: 60 ns. No allocation.
#pragma once

#include "haptics/coupling/elastic_force.h"
#include "haptics/flight/kite_loop.h"
#include "haptics/flight/line_feel.h"

namespace fulcrum {

/// What a line does to the hand in one round; all of it gives the hand's work back.
struct LineForce {
    Wrench wrench_W{};
    ElasticForce force{};   ///< newtons
    ElasticForce torque{};  ///< newton metres
};

class LineStage {
  public:
    /// Takes settings that `validate` accepted. `channels` may be null: then nothing pulls and nobody is told.
    LineStage(const LineFeelSettings& settings, KiteChannels* channels) noexcept
        : feel_(settings), channels_(channels) {}

    /// Where the hand is: the line's own loop goes on from there.
    void tell_hand(const Vector3& hand_W) noexcept;
    [[nodiscard]] LineForce step(const Pose& tool_W, double now_s, double dt_s) noexcept;

  private:
    LineFeel feel_;
    KiteChannels* channels_;
};

}  // namespace fulcrum
