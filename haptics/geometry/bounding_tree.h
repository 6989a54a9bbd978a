// Boxes within boxes over the triangles of a mesh: finds those near a point or along a segment.
//
// A complete 8-ary tree without pointers. Triangles are put in order by splitting at the median of their centres
// across the longest side; slot s of that order is the child s mod 8 of node s / 8 in the last level, which is the
// child of node s / 64 above, and so on. A node holds its 8 children's boxes as 16-bit steps of the mesh's box,
// so that one comparison of eight decides. The step function is monotone and the same for boxes and questions, so a box
// is never missed.
//
// Thread: build at load; questions from any thread. Cost: build O(n log n); 12 bytes a triangle and a seventh more for the nodes above;
// questions O(log n + found) for small ones.
#pragma once

#include "haptics/base/prefetch.h"
#include "haptics/geometry/step_box.h"
#include "haptics/geometry/triangle_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace fulcrum {

class BoundingTree {
  public:
    static constexpr int kWidth = 8;
    static constexpr int kMaxLevels = 11;  ///< 8^11 triangles are more than an index counts

    BoundingTree() = default;
    /// Builds over the mesh's triangles.
    explicit BoundingTree(const TriangleMesh& mesh);

    /// For each slot the mesh's triangle that lies there.
    [[nodiscard]] std::span<const std::int32_t> order() const noexcept { return order_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;
    [[nodiscard]] const Box& root_box() const noexcept { return root_box_; }

    /// Calls visit(slot) for every triangle whose box may overlap `box`, and some others near it.
    template <class Visit>
    void for_each_in_box(const Box& box, Visit&& visit) const noexcept;
    /// The same, but that of nodes for whose box is_off(box) says so nothing is visited: all of their triangles lie in it.
    template <class IsOff, class Visit>
    void for_each_in_box(const Box& box, IsOff&& is_off, Visit&& visit) const noexcept;

    /// Writes the leaves, nodes of up to 8 triangles, that may hold a triangle overlapping `box`. Returns how many, or
    /// nothing when they are more than fit, or the nodes above them more than a search holds.
    [[nodiscard]] std::optional<std::size_t> collect_leaves(
        const Box& box, std::span<std::int32_t> leaves) const noexcept;

    /// A `collect_leaves` in pieces, a few nodes at a time.
    class LeafSearch;
    /// Goes on with a search by up to `n_nodes` nodes; false when it is over, by then with all leaves or with too many.
    bool go_on(LeafSearch& search, std::int32_t n_nodes,
               std::span<std::int32_t> leaves) const noexcept;

    /// In the tree's own steps: triangles that `for_each_in_leaves` leaves out overlap no box within.
    [[nodiscard]] StepBox to_steps(const Box& box) const noexcept { return grid_.to_steps(box); }
    /// As `for_each_in_box`, among the triangles of the given leaves only.
    template <class Visit>
    void for_each_in_leaves(std::span<const std::int32_t> leaves, const StepBox& steps,
                            Visit&& visit) const noexcept;

    /// Calls t_end = visit(slot, t_end) for every triangle whose box may be met by from + t (to - from), t in
    /// [0, t_end], nearest boxes first. t_end starts at 1; visit returns how much of the segment is still of interest.
    template <class Visit>
    void for_each_along(const Vector3& from, const Vector3& to, Visit&& visit) const noexcept;

  private:
    struct Place {
        std::int32_t level;
        std::int32_t index;  // within the level
        float s;             // where a segment enters
    };
    // A segment in steps: position = start + t rate, and 1 / rate.
    struct StepSegment {
        std::array<float, 3> start;
        std::array<float, 3> inverse_rate;
    };
    using Entries = std::array<float, kWidth>;

    static constexpr float kMissed = 2.0F;    // an entry beyond any s
    static constexpr float kSlack = 1.0e-4F;  // above what rounding in the entries can amount to
    // Deepest stack: all children of one node in each level.
    static constexpr std::size_t kStack = static_cast<std::size_t>(kMaxLevels) * kWidth;

    void build_nodes(const TriangleMesh& mesh);
    [[nodiscard]] StepSegment to_steps(const Vector3& from, const Vector3& to) const noexcept;
    // The part of a segment within the root's box, with a margin; false when there is none.
    [[nodiscard]] bool clip_to_root(const Vector3& from, const Vector3& to, double& t_in,
                                    double& t_out) const noexcept;
    static Entries find_entries(const EightBoxes& node, const StepSegment& segment,
                                float s_end) noexcept;
    [[nodiscard]] const EightBoxes& node_at(const Place& place) const noexcept {
        const std::int32_t first = level_first_[static_cast<std::size_t>(place.level)];
        return nodes_[static_cast<std::size_t>(first) + static_cast<std::size_t>(place.index)];
    }

    std::vector<EightBoxes> nodes_;
    std::vector<std::int32_t> order_;
    std::array<std::int32_t, kMaxLevels> level_first_{};
    std::int32_t n_levels_ = 0;
    Box root_box_;
    StepGrid grid_;
};

class BoundingTree::LeafSearch {
  public:
    /// Over: nothing to look for.
    LeafSearch() noexcept = default;
    /// Anew, for the leaves that may hold a triangle overlapping `box`.
    void begin(const BoundingTree& tree, const Box& box) noexcept;

    [[nodiscard]] bool is_over() const noexcept { return n_done_ == n_queued_; }
    /// How many leaves were met so far; more than fit when there are too many.
    [[nodiscard]] std::size_t n_found() const noexcept { return n_found_; }

  private:
    friend class BoundingTree;
    struct Node {
        std::int32_t level;
        std::int32_t index;  // within the level
    };
    // All nodes above the leaves that a search may meet; one that meets more is treated as having too many leaves.
    static constexpr std::size_t kMostNodes = 128;

    void add_leaf(std::int32_t leaf, std::span<std::int32_t> leaves) noexcept {
        if (n_found_ < leaves.size()) {
            leaves[n_found_] = leaf;
        }
        ++n_found_;
    }
    void give_up(std::span<std::int32_t> leaves) noexcept {
        n_found_ = leaves.size() + 1;
        n_done_ = n_queued_;
    }

    StepBox steps_{};
    // First come, first served: by the time that a node's turn comes it has been fetched.
    std::array<Node, kMostNodes> queue_{};
    std::size_t n_queued_ = 0;
    std::size_t n_done_ = 0;
    std::size_t n_found_ = 0;
};

template <class Visit>
void BoundingTree::for_each_in_box(const Box& box, Visit&& visit) const noexcept {
    for_each_in_box(
        box, [](const Box& /*node*/) noexcept { return false; }, visit);
}

template <class IsOff, class Visit>
void BoundingTree::for_each_in_box(const Box& box, IsOff&& is_off, Visit&& visit) const noexcept {
    if (!root_box_.overlaps(box)) {
        return;
    }
    const StepBox steps = grid_.to_steps(box);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
    std::array<Place, kStack> stack;
    std::size_t n_stacked = 0;
    stack[n_stacked++] = {0, 0, 0.0F};
    while (n_stacked > 0) {
        const Place place = stack[--n_stacked];
        const EightBoxes& node = node_at(place);
        unsigned overlapping = find_overlapping(node, steps);
        for (; overlapping != 0; overlapping &= overlapping - 1U) {
            const int which = std::countr_zero(overlapping);
            const std::int32_t child = place.index * kWidth + which;
            if (place.level + 1 == n_levels_) {
                visit(child);
                continue;
            }
            if (is_off(grid_.to_box(node, which))) {
                continue;
            }
            stack[n_stacked++] = {place.level + 1, child, 0.0F};
            prefetch(&node_at(stack[n_stacked - 1]), sizeof(EightBoxes));
        }
    }
}

template <class Visit>
void BoundingTree::for_each_in_leaves(std::span<const std::int32_t> leaves, const StepBox& steps,
                                      Visit&& visit) const noexcept {
    // Eight leaves at a time: what they have to visit is one word, so few branches depend on what is found.
    for (; !leaves.empty(); leaves = leaves.subspan(std::min<std::size_t>(leaves.size(), kWidth))) {
        std::uint64_t overlapping = 0;
        for (std::size_t i = 0; i < std::min<std::size_t>(leaves.size(), kWidth); ++i) {
            const EightBoxes& boxes = node_at({n_levels_ - 1, leaves[i], 0.0F});
            overlapping |= std::uint64_t{find_overlapping(boxes, steps)} << (kWidth * i);
        }
        for (; overlapping != 0; overlapping &= overlapping - 1U) {
            const auto bit = static_cast<std::size_t>(std::countr_zero(overlapping));
            visit(leaves[bit / kWidth] * kWidth + static_cast<std::int32_t>(bit % kWidth));
        }
    }
}

template <class Visit>
void BoundingTree::for_each_along(const Vector3& from, const Vector3& to,
                                  Visit&& visit) const noexcept {
    double t_in = 0.0;
    double t_out = 1.0;
    if (!clip_to_root(from, to, t_in, t_out)) {
        return;
    }
    // Within the tree s runs from 0 to 1 over the part inside the root's box, where single precision is fine enough.
    const StepSegment segment = to_steps(from + t_in * (to - from), from + t_out * (to - from));
    const auto to_s = [t_in, t_out](double t) {
        return static_cast<float>((t - t_in) / (t_out - t_in));
    };
    double t_end = 1.0;
    float s_end = 1.0F + kSlack;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
    std::array<Place, kStack> stack;
    std::size_t n_stacked = 0;
    stack[n_stacked++] = {0, 0, 0.0F};
    while (n_stacked > 0) {
        const Place place = stack[--n_stacked];
        if (place.s > s_end) {
            continue;
        }
        const Entries entries = find_entries(node_at(place), segment, s_end);
        const bool last_level = place.level + 1 == n_levels_;
        const std::size_t bottom = n_stacked;
        for (int child = 0; child < kWidth; ++child) {
            const float s = entries[static_cast<std::size_t>(child)];
            const std::int32_t index = place.index * kWidth + child;
            if (s >= kMissed) {
                continue;
            }
            if (last_level) {
                t_end = visit(index, t_end);
                s_end = std::min(to_s(t_end), 1.0F) + kSlack;
                continue;
            }
            // Kept so that the nearest lies on top.
            std::size_t at = n_stacked++;
            for (; at > bottom && stack[at - 1].s < s; --at) {
                stack[at] = stack[at - 1];
            }
            stack[at] = {place.level + 1, index, s};
        }
    }
}

}  // namespace fulcrum
