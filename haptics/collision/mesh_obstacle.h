// A mesh as a ball meets it: every triangle drawn out by the ball's radius, corners and edges rounded.
//
// A crack narrower than the ball is no way through, whatever the mesh is like: edges are solid in themselves. The tree's leaves near the
// ball are remembered (near_leaves.h); eight triangles at a time are passed over by a plane between them and the way, and only those that
// the ball may touch are asked.
//
// Thread: haptic loop, one each. Cost: some nanoseconds a leaf near, O(log n + leaves) where the ball goes on; no allocation after
// construction.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/collision/near_leaves.h"
#include "haptics/collision/obstacle.h"
#include "haptics/collision/triangle_gap.h"

#include <algorithm>
#include <cstdint>
#include <memory>

namespace fulcrum {

class MeshObstacle final : public Obstacle {
  public:
    /// For a ball of `radius_m`, 0 for a point.
    MeshObstacle(std::shared_ptr<const CollisionMesh> mesh, double radius_m);

    [[nodiscard]] CastHit cast(const CastQuestion& question) noexcept override;
    [[nodiscard]] Gap find_gap(std::int32_t feature, const Vector3& at_B) const noexcept override;
    [[nodiscard]] double find_bend(std::int32_t feature, const Vector3& at_B,
                                   const Vector3& direction_B) const noexcept override;
    [[nodiscard]] std::int32_t find_nearest(const Vector3& at_B,
                                            double level_m) const noexcept override;
    [[nodiscard]] Vector3 centre_B() const noexcept override { return mesh_->centre_B(); }
    [[nodiscard]] double radius_m() const noexcept override {
        return mesh_->radius_m() + ball_radius_m_;
    }
    [[nodiscard]] double clearance_m() const noexcept override {
        return kExactClearance * std::max(mesh_->radius_m(), ball_radius_m_);
    }

  private:
    [[nodiscard]] CastHit cast_remembered(const CastQuestion& question) const noexcept;
    [[nodiscard]] CastHit cast_through_tree(const CastQuestion& question) const noexcept;
    void cast_piece(const CastQuestion& question, CastHit& nearest) const noexcept;
    /// Shortens the question's way to the nearest hit.
    void meet(const TriangleForGap& triangle, const TriangleGap& gap, const CastQuestion& question,
              CastHit& nearest) const noexcept;

    std::shared_ptr<const CollisionMesh> mesh_;
    double ball_radius_m_;
    NearLeaves near_;
};

}  // namespace fulcrum
