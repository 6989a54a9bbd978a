// Until when each node of a tool's tree is free, on the clock of its motion (motion_clock.h), now at m: temporal coherence.
//
//   a ball with slack s                    until m + s; how deep it may be after that: m minus then
//   a leaf looked at, its least F          until m + F / L - margin; and after that by where it was looked at (seen_leaves.h)
//   a group of a node's parts              until the first of its parts is not
//   a group whose balls may all touch, each as deep as h at least: hopeless until m + h, so long its balls say nothing new
// Leaves of the shell's thinnings are remembered as well, each by its own points.
//
// Thread: that of the step. Cost: nanoseconds a group; 5 bytes a leaf, as much again for thinnings, and seen_leaves.h.
// Source: W. McNeely, K. Puterbaugh, J. Troy 2006, Voxel-based 6-DOF haptic rendering improvements, Haptics-e 3(7), section 4.
#pragma once

#include "haptics/tool/field_sampling/motion_clock.h"
#include "haptics/tool/field_sampling/node_list.h"
#include "haptics/tool/field_sampling/sampled_pair.h"
#include "haptics/tool/field_sampling/seen_leaves.h"

#include <algorithm>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace fulcrum {

/// Eight nodes that follow each other, as they are known now.
class FreeGroup {
  public:
    FreeGroup(float* until, float* hopeless_until, float now) noexcept
        : until_(until), hopeless_until_(hopeless_until), now_(now) {}

    /// Those that are free no longer, a bit each.
    [[nodiscard]] unsigned find_due() const noexcept {
#if defined(__SSE2__)
        const __m128 now = _mm_set1_ps(now_);
        const int low = _mm_movemask_ps(_mm_cmple_ps(_mm_loadu_ps(until_), now));
        const int high = _mm_movemask_ps(_mm_cmple_ps(_mm_loadu_ps(until_ + 4), now));
        return static_cast<unsigned>(low | high << 4);
#else
        unsigned due = 0;
        for (unsigned i = 0; i < ShellTree::kWidth; ++i) {
            due |= until_[i] <= now_ ? 1U << i : 0U;
        }
        return due;
#endif
    }
    [[nodiscard]] bool is_hopeless() const noexcept {
        return *hopeless_until_ > now_;
    }
    /// How deep a node may be, in the voxels of slacks.
    [[nodiscard]] float find_depth(std::size_t i) const noexcept {
        return now_ - until_[i];
    }
    /// It may go so far; what it was known to be free for stands.
    void note_slack(std::size_t i, float slack) noexcept {
        until_[i] = std::max(until_[i], now_ + slack);
    }
    void note_free(std::size_t i, float voxels) noexcept {
        until_[i] = now_ + voxels;
    }
    /// Those that were asked may touch, each as deep as that.
    void note_hopeless(float depth) noexcept {
        *hopeless_until_ = now_ + std::max(depth, 0.0F);
    }

  private:
    float* until_;
    float* hopeless_until_;
    float now_;
};

/// The leaves of a thinning, as they are known now by their own points.
class FreeLeaves {
  public:
    FreeLeaves(const float* until, float now) noexcept : until_(until), now_(now) {}
    [[nodiscard]] bool may_touch(std::size_t leaf) const noexcept { return until_[leaf] <= now_; }
    /// How far it may go; voxels.
    [[nodiscard]] float find_slack(std::size_t leaf) const noexcept { return until_[leaf] - now_; }

  private:
    const float* until_;
    float now_;
};

class FreeMemory {
  public:
    explicit FreeMemory(const SampledPair& pair);

    /// Knows nothing.
    void reset() noexcept;
    /// The tool is where it is looked at now; a million voxels away at most.
    void advance(const FieldLook& look) noexcept;

    [[nodiscard]] FreeGroup group(std::size_t level, std::size_t group) noexcept {
        Level& at = levels_[level];
        return {at.until.data() + ShellTree::kWidth * group, at.hopeless_until.data() + group,
                clock_.now()};
    }
    [[nodiscard]] FreeLeaves leaves(std::size_t thinning) const noexcept {
        return {(thinning == 0 ? levels_.front().until : thinned_until_[thinning - 1]).data(),
                clock_.now()};
    }
    /// Of the leaves of a group that are due those that are still, for all that is known of where they were looked at.
    [[nodiscard]] unsigned recall_leaves(const FieldLook& look, std::size_t group,
                                         unsigned due) noexcept;
    /// A group of leaves will be asked for soon.
    void prefetch_group(std::size_t group) const noexcept { seen_.prefetch_group(group); }

    /// That leaves of a thinning were looked at, the least F of each in steps.
    void note_leaves(const FieldLook& look, std::size_t thinning,
                     std::span<const std::int32_t> leaves, const float* least_steps) noexcept;
    /// That all was looked at in groups of a level of what was due there: what was found knows better than the balls round them.
    void note_groups(std::size_t level, const NodeList& groups) noexcept;

    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    struct Level {
        std::vector<float> until;           // a node's
        std::vector<float> hopeless_until;  // a group's
    };
    template <class Use>
    void visit_times(Use use) noexcept;
    void rebase() noexcept;

    MotionClock clock_;
    SeenLeaves seen_;
    std::vector<Level> levels_;
    std::vector<std::vector<float>> thinned_until_;  // of each thinning but the first
};

}  // namespace fulcrum
