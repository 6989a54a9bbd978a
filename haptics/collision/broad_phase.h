// Which of many boxes overlap: sweep and prune.
//
// Boxes are kept sorted by their lower ends along one axis, equal ones by number; swept in this order, each is compared with those that
// begin before it ends. From step to step little changes its place in the order, so putting it right again costs about one comparison a
// box. The axis is that along which the boxes' middles are spread most; another is taken when it is spread twice as much. What is found is
// exact: every pair of boxes that overlap or touch, each once, in the order of their numbers, whatever was before. Of more than there is
// room for those stay whose boxes are nearest to each other, each taken without what it reaches beyond its body.
//
// Thread: the world loop. Cost: some 10 ns a box and 5 ns a pair along the axis, and sorting what is found; no allocation.
// Source: D. Baraff 1992, Dynamic simulation of non-penetrating rigid bodies, thesis, section 2.3 (sort and sweep, coherence).
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/geometry/step_box.h"

#include <cstdint>
#include <span>
#include <tuple>

namespace fulcrum {

/// Two bodies by number, the lesser first, and which patch of their contact where they may have several (sampled_contacts.h).
struct BodyPair {
    std::int32_t first = 0;
    std::int32_t second = 0;
    std::int32_t patch = 0;
    [[nodiscard]] bool operator==(const BodyPair&) const noexcept = default;
    [[nodiscard]] bool operator<(const BodyPair& other) const noexcept {
        return std::tie(first, second, patch) < std::tie(other.first, other.second, other.patch);
    }
};

class BroadPhase {
  public:
    /// Reserves all that it will need.
    BroadPhase(int max_bodies, int max_pairs);

    /// `moves[i]` is 0 of a body that stays where it is: two of those make no pair. Boxes may be infinite; one that holds no numbers
    /// overlaps none. Boxes beyond the most that were announced are left out. `reaches_m`, as many or none, is how far each box goes beyond
    /// its body. Valid until the next call.
    [[nodiscard]] std::span<const BodyPair> find_pairs(
        std::span<const Box> boxes, std::span<const std::uint8_t> moves,
        std::span<const double> reaches_m = {}) noexcept;
    /// Pairs for which there was no room in the last call.
    [[nodiscard]] int n_dropped() const noexcept { return n_dropped_; }

  private:
    void take_order(std::size_t n_boxes) noexcept;
    void choose_axis(std::span<const Box> boxes) noexcept;
    void sort(std::span<const Box> boxes) noexcept;
    /// As an order in which the farthest come last.
    struct NearPair {
        double gap_m = 0.0;
        BodyPair bodies{};
        [[nodiscard]] bool operator<(const NearPair& other) const noexcept {
            return std::tie(gap_m, bodies) < std::tie(other.gap_m, other.bodies);
        }
    };
    void add(const NearPair& pair) noexcept;

    BoundedList<std::int32_t> order_;
    BoundedList<NearPair> near_;
    BoundedList<BodyPair> pairs_;
    int axis_ = 0;
    int n_dropped_ = 0;
};

}  // namespace fulcrum
