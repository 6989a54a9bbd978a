// The search down a tool's tree of balls (shell_tree.h) for nodes that may touch: level by level, of each the groups whose node above may.
//
//   anew    every ball of a group is asked for its slack (ball_slack.h)
//   known   those alone that are free no longer by what is remembered of them (free_memory.h), which learns what they say
//
// Thread: that of the step; room is made at load. Cost: a group 0.03 us, one that is known to be free 1 ns; 9 bytes a leaf.
// Source: J. Barbic, D. James 2008, Six-DoF haptic rendering of contact between geometrically complex reduced deformable models, IEEE
// Trans. Haptics 1(1), section 4.2.
#pragma once

#include "haptics/tool/field_sampling/field_touch.h"
#include "haptics/tool/field_sampling/free_memory.h"

#include <vector>

namespace fulcrum {

class ShellSearch {
  public:
    explicit ShellSearch(const SampledPair& pair);

    /// Found: ascending nodes of the level that was searched last.
    [[nodiscard]] const NodeList& nodes() const noexcept { return nodes_; }
    /// How deep node number i of them may be, in the voxels of slacks.
    [[nodiscard]] float depth_voxels(std::size_t i) const noexcept { return depths_[i]; }
    /// All leaves, without a search.
    void list_leaves(std::size_t n) noexcept;

    /// Down to the leaves: those that may touch within `within` voxels; the least slack of the others.
    float search_anew(const FieldLook& look, float within, LookWork& work) noexcept;
    /// Down to the leaves: those that may touch.
    void search_known(const FieldLook& look, FreeMemory& memory, LookWork& work) noexcept;

    /// The same, level by level, `level` being where it is: from the only group of the topmost on,
    [[nodiscard]] std::size_t begin_at_top() noexcept;
    [[nodiscard]] std::size_t n_groups_at(std::size_t level) const noexcept {
        return groups_[level].size();
    }
    void search_level(const FieldLook& look, std::size_t level, FreeMemory& memory,
                      LookWork& work) noexcept;
    /// then the parts of what was found; the level of those.
    std::size_t go_down(std::size_t level) noexcept;
    /// It ends here.
    void stop_at(std::size_t level) noexcept;
    /// Of what was found those stay for which `keeps(i)` says so, asked in turn.
    template <class Keeps>
    void keep_if(Keeps keeps) noexcept {
        std::size_t n = 0;
        nodes_.keep_if([&](std::size_t i) {
            const bool is_kept = keeps(i);
            if (is_kept) {
                depths_[n++] = depths_[i];
            }
            return is_kept;
        });
    }
    /// Tells the memory that all leaves found were looked at, by groups from below.
    void note_groups(FreeMemory& memory) const noexcept;

    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    void add(std::size_t node, float depth_voxels) noexcept {
        depths_[nodes_.size()] = depth_voxels;
        nodes_.add(static_cast<std::int32_t>(node));
    }
    void search_group(const FieldLook& look, std::size_t level, std::size_t group, unsigned due,
                      FreeMemory& memory, LookWork& work) noexcept;
    float search_level_anew(const FieldLook& look, std::size_t level, float within,
                            LookWork& work) noexcept;

    std::vector<NodeList> groups_;  // of each level, to be looked at in this search
    NodeList nodes_;
    std::vector<float> depths_;
};

}  // namespace fulcrum
