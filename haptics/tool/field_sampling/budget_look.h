// A look at a pair within a budget of time. It ends in time and tells what it left out:
//
//   all that may touch fits   it is exact
//   else                      samples that stand for all, with closer looks where they touch (thinned_look.h); where too few touch,
//                             whole leaves, the deepest first (deepest_look.h)
//   in a step whose first look chose so before, there again (step_choice.h)
// The force has half of the time at least where derivatives are asked for too.
//
// Thread: that of the step; room is made at load. Cost: the look's time.
#pragma once

#include "haptics/tool/field_sampling/deepest_look.h"
#include "haptics/tool/field_sampling/step_choice.h"
#include "haptics/tool/field_sampling/thinned_look.h"

namespace fulcrum {

class BudgetLook {
  public:
    /// Room for that pair; at load.
    void reserve(const SampledPair& pair);
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

    /// Nothing is known to have touched.
    void forget() noexcept { touched_last_.clear(); }
    /// Looks from now on are those of another step.
    void begin_step() noexcept { choice_.forget(); }
    void look(TimedLook& in, bool slopes_follow) noexcept;

  private:
    void look_first(TimedLook& in) noexcept;

    SampleUnits units_;
    ThinnedLook thinned_;
    DeepestLook deepest_;
    StepChoice choice_;
    NodeList
        touched_last_;  // leaves that the last look took and touched, where it stood for all by each point
};

}  // namespace fulcrum
