// What the looks of one step have in common, from the first on in which not all fitted: how many points one stands for, and which of
// them are looked at. The others look there again, so that the solver sees one force that follows the pose; what has come near since
// is told as left out.
//
// Thread: that of the step; room is made at load. Cost: that of the leaves chosen; 4 bytes a leaf.
#pragma once

#include "haptics/tool/field_sampling/sample_units.h"
#include "haptics/tool/field_sampling/timed_look.h"

namespace fulcrum {

class StepChoice {
  public:
    /// Room for so many leaves; at load.
    void reserve(std::size_t n) { chosen_.reserve(n); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept { return chosen_.memory_bytes(); }

    void forget() noexcept { is_made_ = false; }
    [[nodiscard]] bool is_made() const noexcept { return is_made_; }
    /// What a look took, if others of its step follow: leaves of the sums' thinning; or `is_listed` false: all that may touch, of which
    /// these are those of now.
    void make(TimedLook& in, bool is_listed, const NodeList& leaves) noexcept;
    /// There again, once it is made.
    void look_again(TimedLook& in, SampleUnits& units) const noexcept;

  private:
    bool is_made_ = false;
    bool is_listed_ = false;
    std::size_t thinning_ = 0;
    SampleMiss miss_;
    NodeList chosen_;
};

}  // namespace fulcrum
