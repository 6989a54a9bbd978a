// A mesh as a ball meets it: every triangle drawn out by the ball's radius, corners and edges rounded.
//
// A crack narrower than the ball is no way through, whatever the mesh is like: edges are solid in themselves. Triangles near the ball
// are remembered with all that their distance asks for, and each with a distance that it cannot have come below since it was
// last looked at: most are passed over by one comparison.
//
// Thread: haptic loop, one each. Cost: O(log n + triangles near); no allocation after construction.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/collision/obstacle.h"
#include "haptics/collision/triangle_gap.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

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
    static constexpr std::size_t kMostRemembered = 1024;

    void remember(const Vector3& centre_B, double radius_m) noexcept;
    void remember(std::int32_t triangle) noexcept;
    [[nodiscard]] CastHit cast_remembered(const CastQuestion& question) noexcept;
    [[nodiscard]] CastHit cast_through_tree(const CastQuestion& question) const noexcept;
    void cast_piece(const CastQuestion& question, CastHit& nearest) const noexcept;
    /// Shortens the question's way to the nearest hit.
    void meet(const TriangleForGap& triangle, const TriangleGap& gap, const CastQuestion& question,
              CastHit& nearest) const noexcept;

    std::shared_ptr<const CollisionMesh> mesh_;
    double ball_radius_m_;
    std::size_t n_remembered_ = 0;
    std::vector<TriangleForGap>
        triangles_;                 // room for kMostRemembered, as many as remembered count
    std::vector<double> bounds_m_;  // their distances were at least this less the way travelled
    double travelled_m_ = 0.0;
    Vector3 last_B_{Vector3::Zero()};
    Vector3 centre_B_{Vector3::Zero()};  // of the ball in which all triangles are remembered
    double reach_m_ = -1.0;              // its radius; below 0: none are
};

}  // namespace fulcrum
