// A look at whole leaves of a tool's points where there is time for few of them and too few touch to stand for others, so that a lone
// tip weighs what it weighs: first what touched in the last step, then what reaches farthest for its size.
//
//   rank   depth / radius of a node's ball, at most 2; above that a node with a leaf that touched in the last step
// From the level at which the search ended down, at each as many as can be opened in the time that is left, one leaf of each taken.
//
// Thread: that of the step; room is made at load. Cost: bounded by the look's time; 4 bytes a leaf.
#pragma once

#include "haptics/tool/field_sampling/timed_look.h"

#include <vector>

namespace fulcrum {

class DeepestLook {
  public:
    /// Room for that pair; at load.
    void reserve(const SampledPair& pair) { ranks_.resize(pair.n_most_nodes()); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return ranks_.capacity() * sizeof(float);
    }

    /// At the nodes found, of that level; those that are found then are the leaves it was at.
    void look(TimedLook& in, std::size_t level, const NodeList& touched_last) noexcept;

  private:
    void rank(TimedLook& in, std::size_t level, const NodeList& touched_last) noexcept;
    // Keeps as many as there is room for, those that matter most.
    void choose(TimedLook& in, std::size_t level, std::size_t room,
                const NodeList& touched_last) noexcept;

    std::vector<float> ranks_;
};

}  // namespace fulcrum
