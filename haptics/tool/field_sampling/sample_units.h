// The units of a thinning that nodes of a tool's tree stand for: each of several nodes that follow each other, or a part of one.
//
//   a node of level l holds the leaves j 8^l to (j + 1) 8^l - 1, a unit of thinning m those from i 2^m to (i + 1) 2^m - 1 (shell_tree.h)
//
// Thread: that of the step; room is made at load. Cost: a nanosecond a unit; 8 bytes a leaf.
#pragma once

#include "haptics/tool/field_sampling/free_memory.h"
#include "haptics/tool/field_sampling/node_list.h"

namespace fulcrum {

class SampleUnits {
  public:
    /// Room for so many leaves; at load.
    void reserve(std::size_t n) {
        all_.reserve(n);
        due_.reserve(n);
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return all_.memory_bytes() + due_.memory_bytes();
    }

    /// Those of `n_units` that ascending nodes of a level stand for, by what is known of their samples.
    void list(const NodeList& nodes, std::size_t level, std::size_t thinning, std::size_t n_units,
              const FreeLeaves& known) noexcept;
    /// Those that are in a list.
    void list_due(const NodeList& units, const FreeLeaves& known) noexcept;

    [[nodiscard]] const NodeList& all() const noexcept { return all_; }
    /// Of them those that are not known to be free.
    [[nodiscard]] const NodeList& due() const noexcept { return due_; }

  private:
    NodeList all_;
    NodeList due_;
};

}  // namespace fulcrum
