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
#include <limits>
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
    void for_each_in_box(const Box& box, Visit&& visit) const noexcept {
        for_each_leaf(box, [&](std::int32_t leaf, unsigned overlapping) noexcept {
            visit_children(leaf, overlapping, visit);
            return true;
        });
    }

    /// Writes the leaves, nodes of up to 8 triangles, that may hold a triangle overlapping `box`. Returns how many, or
    /// nothing when they are more than fit.
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
                            Visit&& visit) const noexcept {
        for (const std::int32_t leaf : leaves) {
            visit_children(leaf, find_overlapping(node_at({n_levels_ - 1, leaf, 0.0F}), steps),
                           visit);
        }
    }

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

    // Nodes still to be looked into.
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): the places are filled as it grows
    struct Stack {
        std::array<Place, kStack> places;
        std::size_t n = 0;
    };

    // Calls visit_leaf(leaf, overlapping children) until it returns false.
    template <class VisitLeaf>
    void for_each_leaf(const Box& box, VisitLeaf&& visit_leaf) const noexcept;
    // The same from what is stacked, for `n_nodes` at most.
    template <class VisitLeaf>
    void visit_stacked(Stack& stack, const StepBox& steps, std::int32_t n_nodes,
                       VisitLeaf&& visit_leaf) const noexcept;
    template <class Visit>
    static void visit_children(std::int32_t leaf, unsigned overlapping, Visit& visit) noexcept;
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

template <class Visit>
void BoundingTree::visit_children(std::int32_t leaf, unsigned overlapping, Visit& visit) noexcept {
    while (overlapping != 0) {
        visit(leaf * kWidth + std::countr_zero(overlapping));
        overlapping &= overlapping - 1U;
    }
}

class BoundingTree::LeafSearch {
  public:
    /// Over: nothing to look for.
    LeafSearch() noexcept = default;
    /// Anew, for the leaves that may hold a triangle overlapping `box`.
    void begin(const BoundingTree& tree, const Box& box) noexcept;

    [[nodiscard]] bool is_over() const noexcept { return stack_.n == 0; }
    /// How many leaves were met so far; more than fit when there are too many.
    [[nodiscard]] std::size_t n_found() const noexcept { return n_found_; }

  private:
    friend class BoundingTree;
    StepBox steps_{};
    Stack stack_;
    std::size_t n_found_ = 0;
};

template <class VisitLeaf>
void BoundingTree::for_each_leaf(const Box& box, VisitLeaf&& visit_leaf) const noexcept {
    if (!root_box_.overlaps(box)) {
        return;
    }
    Stack stack;
    stack.places[stack.n++] = {0, 0, 0.0F};
    visit_stacked(stack, grid_.to_steps(box), std::numeric_limits<std::int32_t>::max(), visit_leaf);
}

template <class VisitLeaf>
void BoundingTree::visit_stacked(Stack& stack, const StepBox& steps, std::int32_t n_nodes,
                                 VisitLeaf&& visit_leaf) const noexcept {
    for (; stack.n > 0 && n_nodes > 0; --n_nodes) {
        const Place place = stack.places[--stack.n];
        unsigned overlapping = find_overlapping(node_at(place), steps);
        if (place.level + 1 == n_levels_) {
            if (overlapping != 0 && !visit_leaf(place.index, overlapping)) {
                stack.n = 0;
            }
            continue;
        }
        while (overlapping != 0) {
            const Place child{place.level + 1, place.index * kWidth + std::countr_zero(overlapping),
                              0.0F};
            prefetch(&node_at(child), sizeof(EightBoxes));
            stack.places[stack.n++] = child;
            overlapping &= overlapping - 1U;
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
