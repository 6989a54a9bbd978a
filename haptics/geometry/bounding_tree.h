// Boxes within boxes over the triangles of a mesh: finds those near a point or along a segment.
//
// A complete 8-ary tree without pointers. Triangles are put in order by splitting at the median of their centres
// across the longest side; slot s of that order is the child s mod 8 of node s / 8 in the last level, which is the
// child of node s / 64 above, and so on. A node holds its 8 children's boxes as 16-bit steps of the mesh's box,
// so that one comparison of eight decides. The step function is monotone and the same for boxes and questions, so a box
// is never missed.
//
// Thread: build at load; questions from any thread. Cost: build O(n log n); 12.2 + 1.6 bytes a triangle, 96 a node;
// questions O(log n + found) for small ones.
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <algorithm>

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace fulcrum {

/// An axis-aligned box; empty when a lower coordinate exceeds the upper.
struct Box {
    Vector3 lower{Vector3::Zero()};
    Vector3 upper{Vector3::Zero()};

    [[nodiscard]] bool contains(const Vector3& p) const noexcept {
        return (p.array() >= lower.array()).all() && (p.array() <= upper.array()).all();
    }
    [[nodiscard]] bool overlaps(const Box& other) const noexcept {
        return (lower.array() <= other.upper.array()).all() &&
               (upper.array() >= other.lower.array()).all();
    }
};

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

    /// As `for_each_in_box`, among the triangles of the given leaves only.
    template <class Visit>
    void for_each_in_leaves(std::span<const std::int32_t> leaves, const Box& box,
                            Visit&& visit) const noexcept {
        const StepBox steps = to_steps(box);
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
    struct Node {
        alignas(16) std::array<std::array<std::int16_t, kWidth>, 3> lower;
        alignas(16) std::array<std::array<std::int16_t, kWidth>, 3> upper;
    };
    struct Place {
        std::int32_t level;
        std::int32_t index;  // within the level
        float s;             // where a segment enters
    };
    struct StepBox {
        std::array<std::int16_t, 3> lower;
        std::array<std::int16_t, 3> upper;
    };
    // A segment in steps: position = start + t rate, and 1 / rate.
    struct StepSegment {
        std::array<float, 3> start;
        std::array<float, 3> inverse_rate;
    };
    using Entries = std::array<float, kWidth>;

    // Steps across the mesh's box, counted from its middle: -32767 to 32766. The two values left over make the box of an
    // absent child, which no question overlaps.
    static constexpr double kSteps = 65533.0;
    static constexpr std::int32_t kMiddleStep = 32767;
    static constexpr float kMissed = 2.0F;    // an entry beyond any s
    static constexpr float kSlack = 1.0e-4F;  // above what rounding in the entries can amount to
    // Deepest stack: all children of one node in each level.
    static constexpr std::size_t kStack = static_cast<std::size_t>(kMaxLevels) * kWidth;

    // Calls visit_leaf(leaf, overlapping children) until it returns false.
    template <class VisitLeaf>
    void for_each_leaf(const Box& box, VisitLeaf&& visit_leaf) const noexcept;
    template <class Visit>
    static void visit_children(std::int32_t leaf, unsigned overlapping, Visit& visit) noexcept;
    void build_nodes(const TriangleMesh& mesh);
    void set_child(Node& node, int child, const StepBox& box) const noexcept;
    [[nodiscard]] static StepBox unite_children(const Node& node) noexcept;
    [[nodiscard]] std::int16_t to_step(double coordinate, int axis) const noexcept;
    [[nodiscard]] StepBox to_steps(const Box& box) const noexcept;
    [[nodiscard]] StepSegment to_steps(const Vector3& from, const Vector3& to) const noexcept;
    // The part of a segment within the root's box, with a margin; false when there is none.
    [[nodiscard]] bool clip_to_root(const Vector3& from, const Vector3& to, double& t_in,
                                    double& t_out) const noexcept;
    [[nodiscard]] static unsigned find_overlapping(const Node& node, const StepBox& box) noexcept;
    static Entries find_entries(const Node& node, const StepSegment& segment, float s_end) noexcept;
    [[nodiscard]] const Node& node_at(const Place& place) const noexcept {
        const std::int32_t first = level_first_[static_cast<std::size_t>(place.level)];
        return nodes_[static_cast<std::size_t>(first) + static_cast<std::size_t>(place.index)];
    }

    std::vector<Node> nodes_;
    std::vector<std::int32_t> order_;
    std::array<std::int32_t, kMaxLevels> level_first_{};
    std::int32_t n_levels_ = 0;
    Box root_box_;
    Vector3 steps_per_m_{Vector3::Zero()};
};

inline std::int16_t BoundingTree::to_step(double coordinate, int axis) const noexcept {
    const double step = (coordinate - root_box_.lower[axis]) * steps_per_m_[axis];
    const double inside = step < 0.0 ? 0.0 : (step > kSteps ? kSteps : step);
    return static_cast<std::int16_t>(static_cast<std::int32_t>(inside) - kMiddleStep);
}

inline BoundingTree::StepBox BoundingTree::to_steps(const Box& box) const noexcept {
    StepBox steps{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        steps.lower[axis] = to_step(box.lower[i], i);
        steps.upper[axis] = to_step(box.upper[i], i);
    }
    return steps;
}

// One bit a child. Without SSE2 the compiler makes of the loop what it can.
inline unsigned BoundingTree::find_overlapping(const Node& node, const StepBox& box) noexcept {
#if defined(__SSE2__)
    __m128i apart = _mm_setzero_si128();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const __m128i lower =
            _mm_load_si128(reinterpret_cast<const __m128i*>(node.lower[axis].data()));
        const __m128i upper =
            _mm_load_si128(reinterpret_cast<const __m128i*>(node.upper[axis].data()));
        apart = _mm_or_si128(apart, _mm_cmpgt_epi16(lower, _mm_set1_epi16(box.upper[axis])));
        apart = _mm_or_si128(apart, _mm_cmpgt_epi16(_mm_set1_epi16(box.lower[axis]), upper));
    }
    const __m128i bytes = _mm_packs_epi16(apart, apart);
    return ~static_cast<unsigned>(_mm_movemask_epi8(bytes)) & 0xFFU;
#else
    unsigned overlapping = 0;
    for (std::size_t child = 0; child < kWidth; ++child) {
        bool apart = false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            apart = apart || node.lower[axis][child] > box.upper[axis] ||
                    box.lower[axis] > node.upper[axis][child];
        }
        overlapping |= (apart ? 0U : 1U) << child;
    }
    return overlapping;
#endif
}

template <class Visit>
void BoundingTree::visit_children(std::int32_t leaf, unsigned overlapping, Visit& visit) noexcept {
    while (overlapping != 0) {
        visit(leaf * kWidth + std::countr_zero(overlapping));
        overlapping &= overlapping - 1U;
    }
}

template <class VisitLeaf>
void BoundingTree::for_each_leaf(const Box& box, VisitLeaf&& visit_leaf) const noexcept {
    if (!root_box_.overlaps(box)) {
        return;
    }
    const StepBox steps = to_steps(box);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
    std::array<Place, kStack> stack;
    std::size_t n_stacked = 0;
    stack[n_stacked++] = {0, 0, 0.0F};
    while (n_stacked > 0) {
        const Place place = stack[--n_stacked];
        unsigned overlapping = find_overlapping(node_at(place), steps);
        if (place.level + 1 == n_levels_) {
            if (overlapping != 0 && !visit_leaf(place.index, overlapping)) {
                return;
            }
            continue;
        }
        while (overlapping != 0) {
            stack[n_stacked++] = {place.level + 1,
                                  place.index * kWidth + std::countr_zero(overlapping), 0.0F};
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
