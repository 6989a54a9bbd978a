// What may come near of a tool's mesh and an object's, kept from step to step: the front of the walk down both trees of boxes, each pair
// on it with a direction that keeps it apart. For god_pair.h.
//
//   apart(n) = min n . p - max n . q,   p in the tool's node, q in the object's       never more than their distance, for any unit n
// of a box of middle c and half sizes t_i along a_i  max n . q = n . c + sum t_i |n . a_i|, of a triangle the highest of its corners.
// Every pair of triangles lies below one pair of nodes on the front, and of every pair on the front it is known that where the tool is now
//   distance >= apart - way
// apart as it was when the pair was last looked at, way all that any point of the tool can have gone since. So a step asks only those pairs whose
// distance may be used up: first along the direction they have (10 ns), and where that does not do, along others; then the larger node
// is split. Triangles that lie on each other no direction keeps apart: they are asked for a better one ever more rarely. Of two pairs that come far apart together their parent is put back. A tool that slides on a surface asks
// for some hundred of them a step, however fine the meshes are.
//
// Thread: the tool's. No allocation after it was built.
// Source: the front: S. Ehmann, M. Lin 2001, Accurate and fast proximity queries between polyhedra using convex surface decomposition, Computer
// Graphics Forum 20(3), section 4.3 (generalised front tracking); directions kept as witnesses: D. Baraff 1990, Curved surfaces and coherence for
// non-penetrating rigid body simulation, SIGGRAPH. That a pair waits until its distance is used up is ours.
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/continuous/nearest_features.h"
#include "haptics/continuous/swept_mesh.h"
#include "haptics/math/spatial.h"

#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

/// Where the tool is held, made ready for many questions.
struct GodPlace {
    Pose X_OT{};
    Matrix3 R_OT{Matrix3::Identity()};
    double rounded_m = 0.0;  ///< more than any rounding here

    [[nodiscard]] static GodPlace of(const SweptMesh& object, const SweptMesh& tool,
                                     const Pose& X_OT) noexcept;
    [[nodiscard]] Triangle corners(const Triangle& own) const noexcept {
        return {R_OT * own[0] + X_OT.position, R_OT * own[1] + X_OT.position,
                R_OT * own[2] + X_OT.position};
    }
};

/// How far any point of the tool goes at most between two poses, on the in-between way or any shorter one.
[[nodiscard]] double find_way_m(const SweptMesh& object, const SweptMesh& tool, const Pose& from_OT,
                                const Pose& to_OT) noexcept;

/// Two triangles and a direction; in the object's frame.
struct GodNear {
    std::int32_t object_triangle = -1;
    std::int32_t tool_triangle = -1;
    Vector3 direction_O{Vector3::Zero()};  ///< n, unit, from the object to the tool
    double level_m = 0.0;                  ///< max n . q
};

/// How far apart the direction shows them to be; `tool_own` in the tool's frame.
[[nodiscard]] double find_apart_m(const GodNear& near, const Triangle& tool_own,
                                  const GodPlace& place) noexcept;

enum class GodLook : std::uint8_t {
    whole,
    too_many,  ///< more than were asked for; `near` has some
    no_room    ///< all is forgotten; `near` has some
};

class GodFront {
  public:
    GodFront(const SweptMesh& object, const SweptMesh& tool, int most_pairs);

    /// Whatever was known of where things are. For a tool put elsewhere.
    void forget() noexcept;
    /// The tool is here now, and of what may come within `reach_m` there is nothing but pairs of triangles, `most` of them.
    [[nodiscard]] GodLook look(const GodPlace& place, double reach_m,
                               std::size_t most = SIZE_MAX) noexcept;
    /// Those of the last `look`.
    [[nodiscard]] std::span<const std::int32_t> near() const noexcept { return near_.all(); }
    [[nodiscard]] const GodNear& pair(std::int32_t i) const noexcept {
        return pairs_[static_cast<std::size_t>(i)].near;
    }
    /// The pair takes the direction between its nearest features there, where they touch it keeps what it has; how far they are.
    double aim(std::int32_t i, const GodPlace& place) noexcept;
    /// Likewise, but where they were found within `within_m` ever more rarely: no direction keeps those apart.
    void aim_at_times(std::int32_t i, const GodPlace& place, double within_m) noexcept;
    /// Puts parents back where their children are farther apart than that; a few of them, others each time. For the place of the last look, whose
    /// pairs are no longer told then.
    void tidy(const GodPlace& place, double far_m) noexcept;
    /// Pairs on the front and above it.
    [[nodiscard]] std::size_t size() const noexcept;
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    // Of nodes, until both are leaves: then of their triangles.
    struct Pair {
        GodNear near{};
        std::int32_t object_node = 0;
        std::int32_t tool_node = 0;
        std::int32_t parent = -1;
        std::int32_t first_child = -1;  // the other one follows it; -1: on the front
        bool is_triangles = false;
        std::uint8_t in_vain = 0;  // how often it was aimed
        std::uint8_t waits = 0;    // so often it is not
    };
    [[nodiscard]] Pair& at(std::int32_t i) noexcept { return pairs_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] double due(std::int32_t i) const noexcept {
        return due_[static_cast<std::size_t>(i)];
    }
    void set_due(std::int32_t i, double due_m) noexcept;
    void list_used_up(double end_m) noexcept;
    [[nodiscard]] double find_apart_m(const Pair& pair, const GodPlace& place) const noexcept;
    // Takes the best of some directions, of triangles only one that is better than `best_m`; how far apart it shows them to be.
    double turn_boxes(Pair& pair, const GodPlace& place) const noexcept;
    double turn_triangles(Pair& pair, const GodPlace& place, double best_m) const noexcept;
    [[nodiscard]] double find_level_m(const Pair& pair, const Vector3& direction_O) const noexcept;
    GodLook look_at(std::int32_t top, const GodPlace& place, double reach_m,
                    std::size_t most) noexcept;
    bool split(std::int32_t i, const GodPlace& place) noexcept;
    void place_pair(std::int32_t i, std::int32_t object_node, std::int32_t tool_node,
                    std::int32_t parent) noexcept;

    const SweptMesh* object_;
    const SweptMesh* tool_;
    std::vector<Pair> pairs_;  // children next to each other, at even places
    // How much way there will have been when a pair's distance may be used up; infinite where it is not on the front.
    std::vector<double> due_;
    std::vector<double> block_due_;   // of so many places no one is due before
    BoundedList<std::int32_t> free_;  // places of two
    BoundedList<std::int32_t> used_up_;
    BoundedList<std::int32_t> near_;
    BoundedList<std::int32_t> waiting_;  // on the way down
    std::size_t end_ = 0;                // beyond it no place was ever used
    std::size_t tidied_ = 0;             // up to there, this time round
    double way_m_ = 0.0;
    Pose at_OT_{};
};

}  // namespace fulcrum
