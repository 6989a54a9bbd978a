// A closer look where samples of a tool's points touch, or nearly do: at the parts that they stand for, as finely as there is time for.
//
//   units    of the first look's (sample_units.h) those that touch, and what is nearest to it, four for one that touches; F of each of
//            their samples (seen_samples.h)
//   parts    by the least thinning for which there is room: those that have a sample that touches, as many more that nearly do, and a
//            rim round them, four times the root of those that touch, as what surrounds a disc
//   more     what is next nearest, as much as there is time for
//
// Thread: that of the step; room is made at load. Cost: bounded by the look's time; 16 bytes a leaf, 128 one of thinning 1.
// Source: J. Barbic, D. James 2008, Six-DoF haptic rendering of contact between geometrically complex reduced deformable models, IEEE
// Trans. Haptics 1(1), section 4.2 (finer levels where the coarser one comes near).
#pragma once

#include "haptics/tool/field_sampling/sample_units.h"
#include "haptics/tool/field_sampling/seen_samples.h"
#include "haptics/tool/field_sampling/timed_look.h"

#include <vector>

namespace fulcrum {

class CloserLook {
  public:
    static constexpr std::int64_t kEnoughTouch = 64;  ///< samples that stand for all

    /// Room for that pair; at load.
    void reserve(const SampledPair& pair);
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

    /// At parts of units whose samples were taken and are what the sums hold; leaves that touched in the last step are among them.
    /// False, and the sums are what they were: not worth it, or no time for what is wanted.
    bool look(TimedLook& in, const SampleUnits& units, const NodeList& touched_last) noexcept;
    /// The parts that were taken.
    [[nodiscard]] const NodeList& taken() const noexcept { return scratch_; }

  private:
    struct Finer {
        std::size_t thinning, n_wanted;
    };
    float rank_units(TimedLook& in, const SampleUnits& units) noexcept;
    void choose_units(const SampleUnits& units, std::size_t room) noexcept;
    void see_units(TimedLook& in) noexcept;
    [[nodiscard]] Finer choose_finer(TimedLook& in, std::size_t n_touched_last) noexcept;
    void list_parts(TimedLook& in, const Finer& finer) noexcept;
    void add_touched(const NodeList& touched_last) noexcept;
    bool take_parts(TimedLook& in) noexcept;

    NodeList units_;
    NodeList parts_, more_;
    NodeList scratch_;  // for what is in several of them
    std::vector<float> ranks_;
    SeenSamples seen_;
};

}  // namespace fulcrum
