// The first triangle that a segment meets.
//
// `find_nearest_hit` goes down the bounding tree and `find_nearest_hit_brute_force` through all triangles; both ask
// the same question of each triangle, so their answers are the same to the bit.
//
// Thread: any. Cost: O(log n) and O(n); no allocation.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/collision/segment_triangle.h"
#include "haptics/collision/triangle_batch.h"

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
    /// Begins to collect `box_B` as the next one, in place of one begun before.
    void begin_ahead(const CollisionMesh& mesh, const Box& box_B) noexcept;
    /// Goes on with it by up to `n_nodes` nodes of the tree. Once done it waits until it covers more than the present one.
    Collecting go_on_ahead(const CollisionMesh& mesh, std::int32_t n_nodes) noexcept;
    [[nodiscard]] bool is_collecting_ahead() const noexcept { return !ahead_.search.is_over(); }
    /// How many leaves the last box that was done has.
    [[nodiscard]] std::size_t n_leaves() const noexcept { return n_leaves_; }
    [[nodiscard]] bool covers(const Vector3& point_B) const noexcept {
        return present_.covers(point_B);
    }
    /// The same of the next box, once it is done.
    [[nodiscard]] bool covers_ahead(const Vector3& point_B) const noexcept {
        return ahead_.nearby.covers(point_B);
    }
    /// How far along the segment, from 0 to 1, the collected triangles can answer; 0 when they don't cover its start. The next box
    /// takes the present one's place where it can answer further.
    [[nodiscard]] double cover(const Vector3& from_B, const Vector3& to_B) noexcept;
    /// The nearest meeting in the first `part` of the segment, no more than `cover` told last; `t` is that of the whole segment.
    /// The next segments are expected within `around_m` of this one.
    [[nodiscard]] SegmentHit find_nearest_hit(const CollisionMesh& mesh, const Vector3& from_B,
                                              const Vector3& to_B, double part,
                                              double around_m) noexcept;

  private:
    struct Nearby {
        std::array<std::int32_t, kCapacity> leaves{};
        std::size_t n_leaves = 0;
        Box box_B{};
        bool done = false;

        [[nodiscard]] bool covers(const Vector3& point_B) const noexcept {
            return done && box_B.contains(point_B);
        }
        [[nodiscard]] double find_covered_part(const Vector3& from_B,
                                               const Vector3& to_B) const noexcept;
    };
    struct Ahead {
        BoundingTree::LeafSearch search;
        Nearby nearby;
    };

    void take_ahead() noexcept;
    // Asks all collected triangles within a box, and remembers them when they fit.
    [[nodiscard]] SegmentHit ask_within(const CollisionMesh& mesh, const Box& box_B,
                                        const Vector3& from_B, const Vector3& to_B) noexcept;

    // All triangles in a box around the last segment: one that stays in the box needs no others.
    TriangleBatch asked_;
    Box asked_box_B_;
    bool asked_fits_ = false;
    double around_ = 1.0;  // how far around a segment they are taken, of what is asked for
    Nearby present_;
    Ahead ahead_;
    std::size_t n_leaves_ = 0;
};

}  // namespace fulcrum
