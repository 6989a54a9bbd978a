// Pairs of nodes of two bodies' contact levels, in a tree that is kept from question to question, each with what is known of how near it is.
//
//   bound     no triangle below a is nearer to one below b than g - h_a - h_b, g being how far their hulls are apart (contact_levels.h)
//   motion    how far the tool has moved at most since: the sum of |dx| + 2 sin(turn / 2) reach. What was b apart is now at least b - motion
//             apart, so a pair is not looked at before that says nothing more
// A pair above others is as far as the nearest of these.
//
// Thread: one at a time. Cost: some 0.8 us a pair that is measured; no allocation after construction.
// Source: the tree of pairs as in S. Ehmann, M. Lin 2001, Accurate and fast proximity queries between polyhedra using convex surface decomposition,
// Eurographics; with distances for expiry.
#pragma once

#include "haptics/levels/contact_levels.h"

#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace fulcrum {

/// Where the tool is, and how near counts, while a question is answered.
struct LevelPlace {
    Matrix3 turn{Matrix3::Identity()};
    Vector3 shift{Vector3::Zero()};
    double within_m = 0.0;  ///< d
};

/// A node of the object and one of the tool; -1: none.
struct NodePair {
    std::int32_t object = -1;
    std::int32_t tool = -1;
};

class PairTree {
  public:
    static constexpr std::int32_t kNone = -1;
    // Of a pair that was never told of; of one that has nothing to tell it is less.
    static constexpr float kNotTold = -1.0e30F;
    static constexpr float kNothing = -std::numeric_limits<float>::infinity();
    struct Pair {
        NodePair nodes{};
        std::int32_t first_child = kNone;
        std::int32_t next = kNone;                    ///< beside it, or in the list of free ones
        double bound_m = 0.0;                         ///< bound + motion when it was measured
        float error_m = 0.0F;                         ///< s*
        std::array<float, 3> axis{0.0F, 1.0F, 0.0F};  ///< last normal, frame O
        HullCorners corners{};                        ///< last found
        float told_m = kNotTold;  ///< depth of the deepest contact that was told of it, or below it
    };

    PairTree(std::shared_ptr<const ContactLevels> object, std::shared_ptr<const ContactLevels> tool,
             int most_pairs);

    [[nodiscard]] const ContactLevels& object() const noexcept { return *object_; }
    [[nodiscard]] const ContactLevels& tool() const noexcept { return *tool_; }
    [[nodiscard]] const LevelPlace& place() const noexcept { return place_; }
    [[nodiscard]] std::int32_t root() const noexcept { return root_; }
    [[nodiscard]] int n_kept() const noexcept { return n_kept_; }
    /// Measured since the tool was moved.
    [[nodiscard]] int n_measured() const noexcept { return n_measured_; }
    [[nodiscard]] Pair& at(std::int32_t pair) noexcept {
        return pairs_[static_cast<std::size_t>(pair)];
    }
    [[nodiscard]] const Pair& at(std::int32_t pair) const noexcept {
        return pairs_[static_cast<std::size_t>(pair)];
    }
    [[nodiscard]] const LevelNode& object_node(const NodePair& nodes) const noexcept {
        return object_->node(nodes.object);
    }
    [[nodiscard]] const LevelNode& tool_node(const NodePair& nodes) const noexcept {
        return tool_->node(nodes.tool);
    }
    [[nodiscard]] bool is_leaf(const NodePair& nodes) const noexcept {
        return object_node(nodes).n_children + tool_node(nodes).n_children == 0;
    }

    /// Leaves the root alone.
    void clear() noexcept;
    void move_to(const Pose& X_OT, double within_m) noexcept;
    /// Is nothing below it within `enough_m`, by what is known?
    [[nodiscard]] bool is_beyond(std::int32_t pair, double enough_m) const noexcept {
        return at(pair).bound_m - moved_m_ > enough_m;
    }
    /// Asks for the distance, exact where the bound is not above `enough_m`; true where it is.
    bool measure(std::int32_t pair, double enough_m, HullPair& found) noexcept;
    /// How far apart spheres round both are; below 0 no less than by how little they must be moved to part.
    [[nodiscard]] double compute_spheres_m(const NodePair& nodes) const noexcept;
    /// Gives it children: of the one of its nodes that only bounds, then of more detail. False where there is no room.
    [[nodiscard]] bool divide(std::int32_t pair) noexcept;
    /// Learns from its children how far it is, and how deep; where all are beyond d, it lets go of them: where it may measure, if it is so itself,
    /// else if room runs out.
    void learn_from_children(std::int32_t pair, bool may_measure) noexcept;
    void free_children(std::int32_t pair) noexcept;
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return pairs_.capacity() * sizeof(Pair);
    }

  private:
    [[nodiscard]] std::int32_t make(const NodePair& nodes) noexcept;
    [[nodiscard]] HullPair find_pair(Pair& one, double enough_m) const noexcept;
    [[nodiscard]] float compute_error_m(const NodePair& nodes) const noexcept;

    std::shared_ptr<const ContactLevels> object_;
    std::shared_ptr<const ContactLevels> tool_;
    std::vector<Pair> pairs_;
    std::int32_t free_ = kNone;
    std::size_t n_used_ = 0;  // those behind were never made
    std::int32_t root_ = kNone;
    int n_kept_ = 0;
    int n_measured_ = 0;
    LevelPlace place_;
    Pose last_X_OT_;
    double last_within_m_ = -1.0;
    double moved_m_ = 0.0;
};

}  // namespace fulcrum
