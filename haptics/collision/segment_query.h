// The first triangle that a segment meets.
//
// `find_nearest_hit` goes down the bounding tree and `find_nearest_hit_brute_force` through all triangles; both ask
// the same question of each triangle, so their answers are the same to the bit.
//
// Thread: any. Cost: O(log n) and O(n); no allocation.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/collision/segment_triangle.h"

#include <array>
#include <cstdint>

namespace fulcrum {

[[nodiscard]] inline PreparedTriangle prepare_triangle(const CollisionMesh& mesh,
                                                       std::int32_t triangle) noexcept {
    const TriangleCorners& corners = mesh.corners(triangle);
    return prepare_triangle(mesh.vertex_B(corners[0]), mesh.vertex_B(corners[1]),
                            mesh.vertex_B(corners[2]), triangle);
}

/// The nearest meeting with the mesh; body frame, `from` and `to` finite.
[[nodiscard]] SegmentHit find_nearest_hit(const CollisionMesh& mesh, const Vector3& from_B,
                                          const Vector3& to_B) noexcept;

/// The same by asking every triangle: what the tree is tested against.
[[nodiscard]] SegmentHit find_nearest_hit_brute_force(const CollisionMesh& mesh,
                                                      const Vector3& from_B,
                                                      const Vector3& to_B) noexcept;

enum class Collecting : std::uint8_t { goes_on, done, too_many };

/// The part of a mesh's tree around a box: short segments within the box are answered from it without a descent. One mesh.
/// The next box can be collected ahead, a few nodes at a time, while the present one still serves.
class NearbyTriangles {
  public:
    static constexpr std::size_t kCapacity = 24;  ///< leaves of up to 8 triangles

    /// Collects the triangles near `box_B`. When there are too many it is false: nothing is covered, and the tree answers.
    bool collect(const CollisionMesh& mesh, const Box& box_B) noexcept;
    /// Begins to collect `box_B` as the next one.
    void begin_ahead(const CollisionMesh& mesh, const Box& box_B) noexcept;
    /// Goes on with it by up to `n_nodes` nodes of the tree; once it is complete, and fits, it takes the present one's place.
    Collecting go_on_ahead(const CollisionMesh& mesh, std::int32_t n_nodes) noexcept;
    [[nodiscard]] bool is_collecting_ahead() const noexcept { return !ahead_.search.is_over(); }

    [[nodiscard]] std::size_t n_leaves() const noexcept { return n_leaves_; }
    [[nodiscard]] bool covers(const Vector3& point_B) const noexcept {
        return covers_ && box_B_.contains(point_B);
    }
    /// How far along the segment, from 0 to 1, the collected triangles can answer. Needs `covers(from_B)`.
    [[nodiscard]] double find_covered_part(const Vector3& from_B,
                                           const Vector3& to_B) const noexcept;
    /// The nearest meeting in the first `part` of the segment, of which all is covered; `t` is that of the whole segment.
    [[nodiscard]] SegmentHit find_nearest_hit(const CollisionMesh& mesh, const Vector3& from_B,
                                              const Vector3& to_B, double part) noexcept;

  private:
    // The last sweep's triangles: one that goes back on its way needs no others.
    static constexpr std::size_t kMaxAsked = 32;

    struct Ahead {
        BoundingTree::LeafSearch search;
        std::array<std::int32_t, kCapacity> leaves{};
        Box box_B{};
    };

    std::array<PreparedTriangle, kMaxAsked> asked_;
    std::size_t n_asked_ = kMaxAsked + 1;  // more than fit: nothing is remembered
    StepBox asked_box_{};
    std::array<std::int32_t, kCapacity> leaves_{};
    std::size_t n_leaves_ = 0;
    Box box_B_;
    bool covers_ = false;
    Ahead ahead_;
};

}  // namespace fulcrum
