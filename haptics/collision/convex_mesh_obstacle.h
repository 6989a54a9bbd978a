// A mesh as a cursor of any convex shape meets it (convex_cursor.h).
//
// Whole nodes of the mesh's tree are passed over: those that lie below the planes that the cursor rests on, or below any other plane across
// which all of its way, or both its ends where it has turned, lie beyond them.
//
// Thread: haptic loop. Cost: a distance (convex_cursor.h) for each triangle that is left, and one for each step of a way that meets it; no
// allocation.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/collision/convex_cursor.h"
#include "haptics/collision/obstacle.h"
#include "haptics/collision/triangle_gap.h"

#include <memory>
#include <optional>

namespace fulcrum {

/// A mesh as a convex cursor meets it.
class ConvexMeshObstacle final : public Obstacle {
  public:
    ConvexMeshObstacle(std::shared_ptr<const CollisionMesh> mesh, ConvexBody cursor);

    [[nodiscard]] CastHit cast(const CastQuestion& question) noexcept override;
    [[nodiscard]] Gap find_gap(std::int32_t feature, const Vector3& at_B) const noexcept override;
    [[nodiscard]] double find_bend(std::int32_t /*feature*/, const Vector3& /*at_B*/,
                                   const Vector3& /*direction_B*/) const noexcept override {
        return 0.0;
    }
    [[nodiscard]] std::int32_t find_nearest(const Vector3& at_B,
                                            double level_m) const noexcept override;
    bool turn(const Matrix3& turn_CB) noexcept override { return cursor_.turn(turn_CB); }
    void keep_turn() noexcept override { cursor_.keep_turn(); }
    [[nodiscard]] Vector3 centre_B() const noexcept override { return mesh_->centre_B(); }
    [[nodiscard]] double radius_m() const noexcept override;
    [[nodiscard]] double clearance_m() const noexcept override;

  private:
    template <class IsEnough>
    [[nodiscard]] Gap find_gap(const TriangleForGap& triangle, const Vector3& at_B,
                               IsEnough&& is_enough) const noexcept;
    [[nodiscard]] Gap find_turned_gap(const TriangleForGap& triangle, const Vector3& from_B,
                                      const Vector3& to_B) const noexcept;
    [[nodiscard]] double find_settled_m(const TriangleForGap& triangle, const Gap& gap,
                                        const CastQuestion& question) const noexcept;
    // Below that height along the unit normal nothing is met.
    struct Floor {
        Vector3 normal_B{Vector3::UnitY()};
        double height_m = 0.0;
        template <class Thing>
        [[nodiscard]] bool has_below(const Thing& thing) const noexcept {
            return thing.highest_along(normal_B) <= height_m;
        }
    };
    class Floors;

    [[nodiscard]] Floor find_floor(const Vector3& normal_B,
                                   const CastQuestion& question) const noexcept;
    [[nodiscard]] std::optional<Floor> find_floor_over(const TriangleForGap& triangle,
                                                       const CastQuestion& question) const noexcept;

    std::shared_ptr<const CollisionMesh> mesh_;
    TurnedCursor cursor_;
};

}  // namespace fulcrum
