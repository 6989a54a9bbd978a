// A look at samples of a tool's points where there is no time for all of them (graceful degradation): one point for 2^m that lie together,
// m the least that fits in half of the time, then a closer look where those touch (closer_look.h).
//
//   64 samples touch   their sum times 2^m stands for all. Where closer looks are at each point, that is the sum
//   fewer              no sum of few stands for many
//
// Thread: that of the step; room is made at load. Cost: bounded by the look's time.
// Source: J. Barbic, D. James 2008, Six-DoF haptic rendering of contact between geometrically complex reduced deformable models, IEEE
// Trans. Haptics 1(1), sections 4.2 and 4.3 (nested points, graceful degradation).
#pragma once

#include "haptics/tool/field_sampling/closer_look.h"

namespace fulcrum {

class ThinnedLook {
  public:
    /// Room for that pair; at load.
    void reserve(const SampledPair& pair) { closer_.reserve(pair); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept { return closer_.memory_bytes(); }

    /// At the nodes found, of that level; leaves that touched in the last step say where to look. False, and nothing is taken, where
    /// too few samples touch to stand for all.
    bool look(TimedLook& in, std::size_t level, SampleUnits& units,
              const NodeList& touched_last) noexcept;
    /// Whether it then was at parts of what samples stand for: at these.
    [[nodiscard]] bool is_closer() const noexcept { return is_closer_; }
    [[nodiscard]] const NodeList& parts() const noexcept { return closer_.taken(); }

  private:
    CloserLook closer_;
    bool is_closer_ = false;
};

}  // namespace fulcrum
