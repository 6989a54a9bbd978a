// What the leaves of a tool's points add up to that a look takes: force, torque, which of them touch and how deep.
//
// Leaves are of one thinning of the shell at a time; each point stands for 2^m then. Up to 128 leaves that touch are added in single
// precision lanes (distance_field_batch.h) before they are added to the sums; those that do not touch never change a bit of them.
//
// Thread: that of the step; room is made at load. Cost: a leaf 0.07 us in the cache, 0.17 beyond it; 4 bytes a leaf, with a
// budget 8.
#pragma once

#include "haptics/tool/field_sampling/field_sampling_settings.h"
#include "haptics/tool/field_sampling/field_touch.h"
#include "haptics/tool/field_sampling/free_memory.h"

namespace fulcrum {

class LeafSums {
  public:
    /// What has been added up so far; of leaves of one thinning.
    struct Total {
        std::size_t thinning = 0;
        ContactSums sums;           ///< frame O, over the stiffness
        ContactSpread spread;       ///< where a point stands for others
        float least_steps = 0.0F;   ///< F of the deepest point; 0: none
        std::size_t n_touched = 0;  ///< leaves; those that other totals had before included
    };

    /// Takes settings that `validate` accepted.
    LeafSums(const SampledPair& pair, const FieldSamplingSettings& settings);

    /// Nothing is taken yet, and what is will be of that thinning.
    void begin(std::size_t thinning = 0) noexcept {
        touched_.clear();
        begin_anew(thinning);
    }
    /// The same, but leaves that touched stay known.
    void begin_anew(std::size_t thinning) noexcept {
        total_ = {};
        total_.thinning = thinning;
    }
    /// The total is that again, which was told before `begin_anew`.
    void go_back(const Total& total) noexcept {
        total_ = total;
        touched_.shorten(total.n_touched);
    }
    /// Of the leaves that touched forgets those that another total had before.
    void forget_before(const Total& total) noexcept { touched_.drop_first(total.n_touched); }

    /// Ascending leaves; `memory`, where there is one, is told how far each is from touching.
    void take(const FieldLook& look, std::span<const std::int32_t> leaves, FreeMemory* memory,
              LookWork& work) noexcept;
    /// What was taken is all in the total now.
    void settle(const FieldLook& look) noexcept;

    /// Once settled.
    [[nodiscard]] Total total() const noexcept {
        Total total = total_;
        total.n_touched = touched_.size();
        return total;
    }
    [[nodiscard]] const ContactSums& sums() const noexcept { return total_.sums; }
    [[nodiscard]] const ContactSpread& spread() const noexcept { return total_.spread; }
    [[nodiscard]] float least_steps() const noexcept { return total_.least_steps; }
    [[nodiscard]] std::size_t thinning() const noexcept { return total_.thinning; }
    /// Points that one stands for.
    [[nodiscard]] std::int64_t weight() const noexcept {
        return std::int64_t{1} << total_.thinning;
    }
    /// Leaves that were taken and touch, in the order of that.
    [[nodiscard]] const NodeList& touched() const noexcept { return touched_; }
    void sort_touched() noexcept { touched_.sort(); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept { return touched_.memory_bytes(); }

  private:
    ForceAlong along_;
    Total total_;
    NodeList touched_;
    ContactLanes lanes_;
    std::size_t n_in_lanes_ = 0;  // leaves that touch
};

}  // namespace fulcrum
