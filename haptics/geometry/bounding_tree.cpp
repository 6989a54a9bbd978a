#include "haptics/geometry/bounding_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace fulcrum {

namespace {

// No side of the mesh's box counts as thinner than this times its diagonal.
constexpr double kThinnestSide = 1.0e-3;

// A triangle's centre in single precision: only the order depends on it, never a result.
struct Centre {
    std::array<float, 3> at{};
    std::int32_t triangle = 0;
};

std::vector<Centre> find_centres(const TriangleMesh& mesh) {
    std::vector<Centre> centres(mesh.triangles().size());
    const Vector3 middle = 0.5 * (mesh.lower_B() + mesh.upper_B());
    const double scale = 1.0 / mesh.diagonal_m();
    for (std::size_t i = 0; i < centres.size(); ++i) {
        Vector3 sum = Vector3::Zero();
        for (const std::int32_t corner : mesh.triangles()[i]) {
            sum += mesh.vertices_B()[static_cast<std::size_t>(corner)] - middle;
        }
        const Vector3f centre = (sum * scale).cast<float>();
        centres[i] = {{centre.x(), centre.y(), centre.z()}, static_cast<std::int32_t>(i)};
    }
    return centres;
}

std::size_t find_longest_axis(std::span<const Centre> centres) {
    std::array<float, 3> lower = centres.front().at;
    std::array<float, 3> upper = lower;
    for (const Centre& centre : centres) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lower[axis] = std::min(lower[axis], centre.at[axis]);
            upper[axis] = std::max(upper[axis], centre.at[axis]);
        }
    }
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
        longest = upper[axis] - lower[axis] > upper[longest] - lower[longest] ? axis : longest;
    }
    return longest;
}

// Splits so that the left part is a power of two: then every aligned run of 8^k slots is one subtree. Within a leaf the order is of no
// account.
void put_in_order(std::span<Centre> centres) {
    std::vector<std::span<Centre>> waiting{centres};
    while (!waiting.empty()) {
        const std::span<Centre> part = waiting.back();
        waiting.pop_back();
        if (part.size() <= BoundingTree::kWidth) {
            continue;
        }
        const std::size_t n_left = std::bit_floor(part.size() - 1);
        const std::size_t axis = find_longest_axis(part);
        std::nth_element(
            part.begin(), part.begin() + static_cast<std::ptrdiff_t>(n_left), part.end(),
            [axis](const Centre& a, const Centre& b) { return a.at[axis] < b.at[axis]; });
        waiting.push_back(part.subspan(n_left));
        waiting.push_back(part.first(n_left));
    }
}

void set_child(EightBoxes& node, std::size_t child, const StepBox& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        node.lower[axis][child] = box.lower[axis];
        node.upper[axis][child] = box.upper[axis];
    }
}

StepBox unite_children(const EightBoxes& node) {
    StepBox all;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        all.lower[axis] = *std::min_element(node.lower[axis].begin(), node.lower[axis].end());
        all.upper[axis] = *std::max_element(node.upper[axis].begin(), node.upper[axis].end());
    }
    return all;
}

}  // namespace

BoundingTree::BoundingTree(const TriangleMesh& mesh) : root_box_{mesh.lower_B(), mesh.upper_B()} {
    grid_ = StepGrid(root_box_, kThinnestSide * mesh.diagonal_m());
    std::vector<Centre> centres = find_centres(mesh);
    put_in_order(centres);
    order_.reserve(centres.size());
    for (const Centre& centre : centres) {
        order_.push_back(centre.triangle);
    }
    build_nodes(mesh);
}

std::size_t BoundingTree::memory_bytes() const noexcept {
    return nodes_.capacity() * sizeof(EightBoxes) + order_.capacity() * sizeof(std::int32_t);
}

std::optional<std::size_t> BoundingTree::collect_leaves(
    const Box& box, std::span<std::int32_t> leaves) const noexcept {
    LeafSearch search;
    search.begin(*this, box);
    go_on(search, std::numeric_limits<std::int32_t>::max(), leaves);
    return search.n_found() <= leaves.size() ? std::optional(search.n_found()) : std::nullopt;
}

void BoundingTree::LeafSearch::begin(const BoundingTree& tree, const Box& box) noexcept {
    steps_ = tree.grid_.to_steps(box);
    n_found_ = 0;
    n_done_ = 0;
    n_queued_ = 0;
    if (tree.root_box_.overlaps(box)) {
        queue_[n_queued_++] = {0, 0};
    }
}

bool BoundingTree::go_on(LeafSearch& search, std::int32_t n_nodes,
                         std::span<std::int32_t> leaves) const noexcept {
    for (; !search.is_over() && n_nodes > 0; --n_nodes) {
        const LeafSearch::Node node = search.queue_[search.n_done_++];
        // A leaf is taken for the box that its parent has of it, without a look into it; the root for its own.
        if (n_levels_ == 1) {
            search.add_leaf(node.index, leaves);
            continue;
        }
        const bool over_leaves = node.level + 2 == n_levels_;
        if (!over_leaves && search.n_queued_ + kWidth > search.queue_.size()) {
            search.give_up(leaves);
            break;
        }
        unsigned overlapping =
            find_overlapping(node_at({node.level, node.index, 0.0F}), search.steps_);
        for (; overlapping != 0; overlapping &= overlapping - 1U) {
            const std::int32_t child = node.index * kWidth + std::countr_zero(overlapping);
            prefetch(&node_at({node.level + 1, child, 0.0F}), sizeof(EightBoxes));
            if (over_leaves) {
                search.add_leaf(child, leaves);
            } else {
                search.queue_[search.n_queued_++] = {node.level + 1, child};
            }
        }
        if (search.n_found_ > leaves.size()) {
            search.give_up(leaves);
        }
    }
    return !search.is_over();
}

void BoundingTree::build_nodes(const TriangleMesh& mesh) {
    // Nodes of each level from the last, whose children are the slots, up to the root.
    std::vector<std::int32_t> counts;
    auto n_children = static_cast<std::int32_t>(order_.size());
    do {
        n_children = (n_children + kWidth - 1) / kWidth;
        counts.push_back(n_children);
    } while (n_children > 1);
    n_levels_ = static_cast<std::int32_t>(counts.size());
    std::int32_t n_nodes = 0;
    for (std::size_t level = 0; level < counts.size(); ++level) {
        level_first_[level] = n_nodes;
        n_nodes += counts[counts.size() - 1 - level];
    }
    EightBoxes nothing{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        nothing.lower[axis].fill(std::numeric_limits<std::int16_t>::max());
        nothing.upper[axis].fill(std::numeric_limits<std::int16_t>::min());
    }
    nodes_.assign(static_cast<std::size_t>(n_nodes), nothing);
    const std::size_t last = counts.size() - 1;
    for (std::size_t slot = 0; slot < order_.size(); ++slot) {
        const TriangleCorners& t = mesh.triangles()[static_cast<std::size_t>(order_[slot])];
        const Vector3& a = mesh.vertices_B()[static_cast<std::size_t>(t[0])];
        const Vector3& b = mesh.vertices_B()[static_cast<std::size_t>(t[1])];
        const Vector3& c = mesh.vertices_B()[static_cast<std::size_t>(t[2])];
        const Box box{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
        set_child(nodes_[static_cast<std::size_t>(level_first_[last]) + slot / kWidth],
                  slot % kWidth, grid_.to_steps(box));
    }
    for (std::size_t level = last; level > 0; --level) {
        const auto first = static_cast<std::size_t>(level_first_[level]);
        const auto n = static_cast<std::size_t>(counts[last - level]);
        for (std::size_t i = 0; i < n; ++i) {
            set_child(nodes_[static_cast<std::size_t>(level_first_[level - 1]) + i / kWidth],
                      i % kWidth, unite_children(nodes_[first + i]));
        }
    }
}

bool BoundingTree::clip_to_root(const Vector3& from, const Vector3& to, double& t_in,
                                double& t_out) const noexcept {
    if (!root_box_.overlaps({from.cwiseMin(to), from.cwiseMax(to)})) {
        return false;
    }
    t_in = 0.0;
    t_out = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double rate = to[axis] - from[axis];
        if (rate == 0.0) {
            continue;  // the boxes overlap, so this axis excludes nothing
        }
        const double t_lower = (root_box_.lower[axis] - from[axis]) / rate;
        const double t_upper = (root_box_.upper[axis] - from[axis]) / rate;
        t_in = std::max(t_in, std::min(t_lower, t_upper));
        t_out = std::min(t_out, std::max(t_lower, t_upper));
    }
    constexpr double kMargin = 1.0e-9;  // far above the rounding of t
    if (t_in > t_out + kMargin) {
        return false;
    }
    t_in = std::max(0.0, t_in - kMargin);
    t_out = std::min(1.0, std::max(t_out, t_in) + kMargin);
    return true;
}

BoundingTree::StepSegment BoundingTree::to_steps(const Vector3& from,
                                                 const Vector3& to) const noexcept {
    constexpr double kLargest = 1.0e15;  // a finite stand-in for one over nothing
    StepSegment segment{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Index>(axis);
        const double rate = (to[i] - from[i]) * grid_.steps_per_m(i);
        segment.start[axis] = static_cast<float>(grid_.to_place(from[i], i));
        segment.inverse_rate[axis] = static_cast<float>(
            std::abs(rate) * kLargest > 1.0 ? 1.0 / rate : std::copysign(kLargest, rate));
    }
    return segment;
}

BoundingTree::Entries BoundingTree::find_entries(const EightBoxes& node, const StepSegment& segment,
                                                 float s_end) noexcept {
    Entries enter{};
    Entries leave{};
    leave.fill(s_end);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // A box reaches to the end of its last step. Half a step more covers the rounding to single precision.
        const float start = segment.start[axis];
        const float inverse = segment.inverse_rate[axis];
        for (std::size_t child = 0; child < kWidth; ++child) {
            const float t_lower =
                (static_cast<float>(node.lower[axis][child]) - 0.5F - start) * inverse;
            const float t_upper =
                (static_cast<float>(node.upper[axis][child]) + 1.5F - start) * inverse;
            enter[child] = std::max(enter[child], std::min(t_lower, t_upper));
            leave[child] = std::min(leave[child], std::max(t_lower, t_upper));
        }
    }
    Entries entries{};
    for (std::size_t child = 0; child < kWidth; ++child) {
        // An absent child's box is inside out and would pass as its mirror image.
        const bool present = node.lower[0][child] <= node.upper[0][child];
        entries[child] = present && enter[child] <= leave[child] + kSlack ? enter[child] : kMissed;
    }
    return entries;
}

}  // namespace fulcrum
