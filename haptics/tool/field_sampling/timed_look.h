// A look that does as much as there is time for: the stages that every look has, and the clock asked between their blocks.
//
// Thread: that of the step. Cost: a question to the clock for 16 leaves and for a level of balls.
#pragma once

#include "haptics/tool/field_sampling/leaf_sums.h"
#include "haptics/tool/field_sampling/look_error.h"
#include "haptics/tool/field_sampling/look_time.h"
#include "haptics/tool/field_sampling/shell_search.h"

namespace fulcrum {

/// What a look goes through, from what is known to how far its result may be off.
struct LookStages {
    LookStages(const SampledPair& pair, const FieldSamplingSettings& settings);
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

    FreeMemory memory;
    ShellSearch search;
    LeafSums sums;
    LookTime time;
    LookError error;
};

/// Refers to both, for one look.
class TimedLook {
  public:
    TimedLook(const FieldLook& at, LookStages& stages) noexcept : at_(at), on_(stages) {}

    /// As far down as there is time; the level of the nodes found.
    std::size_t search() noexcept;
    /// Of leaves of the sums' thinning as many as there is time for; how many.
    std::size_t take(std::span<const std::int32_t> leaves) noexcept;
    /// All nodes found, which are leaves; leaves out what there is no time for.
    void take_found() noexcept;
    /// The parts of all nodes found of a level above the leaves, whatever the time.
    std::size_t go_down(std::size_t level) noexcept;
    void leave_out(std::size_t level, std::size_t i) noexcept {
        on_.error.leave_out(at_.pair, level, found()[i], on_.search.depth_voxels(i));
    }
    /// All nodes found, of that level.
    void leave_out_all(std::size_t level) noexcept;
    /// Of them those with a leaf that is not known to be free and is none of those taken.
    void leave_out_others(std::size_t level, const NodeList& taken) noexcept;

    [[nodiscard]] const FieldLook& at() const noexcept { return at_; }
    [[nodiscard]] const ShellTree& shell() const noexcept { return *at_.pair.shell; }
    [[nodiscard]] const NodeList& found() const noexcept { return on_.search.nodes(); }
    /// By what is known now.
    [[nodiscard]] FreeLeaves known(std::size_t thinning) const noexcept {
        return on_.memory.leaves(thinning);
    }
    [[nodiscard]] ShellSearch& search_stage() noexcept { return on_.search; }
    [[nodiscard]] LeafSums& sums() noexcept { return on_.sums; }
    [[nodiscard]] LookTime& time() noexcept { return on_.time; }
    [[nodiscard]] LookError& error() noexcept { return on_.error; }

  private:
    const FieldLook& at_;
    LookStages& on_;
};

}  // namespace fulcrum
