// Which bodies hang together: those that touch or are joined, and what touches those, are one island and can be solved by themselves.
//
// Union-find with the least number as the root, so an island's place among the others, and a body's place in it, follow from the numbers
// alone and not from the order in which links were told. What does not move links nothing: a floor does not make all that stands on it one.
//
// Thread: the world loop. Cost: some ns a body and link; no allocation.
// Source: R. Tarjan 1975, Efficiency of a good but not linear set union algorithm, J. ACM 22(2).
#pragma once

#include "haptics/base/bounded_list.h"

#include <cstdint>
#include <span>

namespace fulcrum {

/// Of one island, by their numbers in the scene, ascending.
struct IslandParts {
    std::span<const std::int32_t> bodies;
    std::span<const std::int32_t> pairs;
    std::span<const std::int32_t> joints;
};

/// Numbers sorted into groups, ascending within each.
class Groups {
  public:
    Groups(int max_items, int max_groups);

    /// `group_of[i]` from 0 to n_groups - 1; below 0: in none.
    void sort(std::span<const std::int32_t> group_of, int n_groups) noexcept;
    [[nodiscard]] std::span<const std::int32_t> group(int i) const noexcept;

  private:
    BoundedList<std::int32_t> items_;
    BoundedList<std::int32_t> begins_;
};

class Islands {
  public:
    explicit Islands(int max_bodies);

    /// All bodies alone; `moves[i]` is 0 of what stays where it is.
    void begin(std::span<const std::uint8_t> moves) noexcept;
    /// Two bodies that touch or are joined; nothing where one of them does not move or is below 0.
    void link(std::int32_t a, std::int32_t b) noexcept;
    /// Numbers the islands, by the least body of each.
    void finish() noexcept;

    [[nodiscard]] int count() const noexcept { return n_islands_; }
    /// Ascending.
    [[nodiscard]] std::span<const std::int32_t> bodies(int island) const noexcept {
        return bodies_.group(island);
    }
    /// -1 of what does not move or is below 0.
    [[nodiscard]] std::int32_t island_of(std::int32_t body) const noexcept {
        return body < 0 ? -1 : island_of_[static_cast<std::size_t>(body)];
    }

  private:
    [[nodiscard]] std::int32_t find_root(std::int32_t body) noexcept;

    BoundedList<std::int32_t> parents_;  // -1: does not move
    BoundedList<std::int32_t> island_of_;
    Groups bodies_;
    int n_islands_ = 0;
};

}  // namespace fulcrum
