// One obstacle as a proxy sees it: where it is now, and where in its own frame the proxy was last.
//
// Thread: haptic loop. Cost: that of the obstacle; no allocation.
#pragma once

#include "haptics/collision/enclosure.h"
#include "haptics/collision/obstacle.h"
#include "haptics/math/spatial.h"
#include "haptics/point/proxy_frame.h"
#include "haptics/point/solid_plan.h"

#include <cstdint>
#include <memory>
#include <span>

namespace fulcrum {

/// A feature that may hold the proxy, linearised where the proxy is.
struct ObstaclePlane {
    std::int32_t solid = kNoBody;
    std::int32_t feature = -1;
    Vector3 normal_W{Vector3::UnitY()};  ///< unit, towards the proxy
    double gap_m = 0.0;                  ///< between them now
    double clearance_m = 0.0;            ///< the gap at which the proxy is held
    double curvature_per_m = 0.0;        ///< as in Gap
    Vector3 straight_W{Vector3::Zero()};
};

class MovingObstacle : public ProxyFrame {
  public:
    /// `lets_out`, `shape_B`: as in SolidPlan; `stuff`: the mesh that the obstacle is made of, if it is one. Its frame is the shape's.
    MovingObstacle(std::unique_ptr<Obstacle> obstacle, std::int32_t index, const Pose& pose_W,
                   bool lets_out = false, std::shared_ptr<const CollisionMesh> stuff = nullptr,
                   const Pose& shape_B = {});

    /// As ProxyFrame::take_pose, of the body; and tells the obstacle how it is turned.
    bool take_pose(const Pose& pose_W) noexcept;
    /// Turns the cursor (R_WC) in its place. What comes into its way by that `cast` finds, and planes are those of that, until the
    /// proxy is put somewhere.
    void turn_cursor(const Matrix3& turn_WC) noexcept;
    /// Has cursor or solid turned since the proxy was put somewhere, and does that matter?
    [[nodiscard]] bool has_turned() const noexcept { return has_turned_; }
    /// As ProxyFrame::put_proxy, with the cursor as it is turned now.
    void put_proxy(const Vector3& proxy_W) noexcept;
    /// The first meeting on the way from the proxy's place in the solid's frame to `to_W`. `normals_W`: planes that it
    /// does not sink through.
    [[nodiscard]] CastHit cast(const Vector3& to_W, double reach_m,
                               std::span<const Vector3> normals_W) noexcept;
    /// A feature's plane where the proxy is now.
    [[nodiscard]] ObstaclePlane find_plane(std::int32_t feature) const noexcept;
    /// The place nearest to `p_W` at which the feature is as far as it should, to first order.
    [[nodiscard]] Vector3 move_off(std::int32_t feature, const Vector3& p_W) const noexcept;
    /// How far along `direction_W` the feature stays bent (Obstacle::find_bend).
    [[nodiscard]] double find_bend(std::int32_t feature,
                                   const Vector3& direction_W) const noexcept {
        return obstacle_->find_bend(feature, proxy_B(), turn_WB().transpose() * direction_W);
    }
    /// The feature that the proxy is most deeply in, if any: -1 when it is as far from all as it should.
    [[nodiscard]] std::int32_t find_deepest() const noexcept {
        return obstacle_->find_nearest(proxy_B(), 0.5 * clearance_m());
    }
    /// Does a proxy at the place lie in the solid, or overlap it?
    [[nodiscard]] bool holds(const Vector3& p_W) const noexcept;
    /// Can a proxy within `radius_m` of `centre_W` reach the solid?
    [[nodiscard]] bool is_near(const Vector3& centre_W, double radius_m) const noexcept;
    /// The gap at which the proxy is held here.
    [[nodiscard]] double clearance_m() const noexcept;

  private:
    static constexpr std::size_t kMostNormals = 4;

    void tell_turn() noexcept;
    [[nodiscard]] bool is_near_way(const Vector3& to_B) const noexcept;

    std::unique_ptr<Obstacle> obstacle_;
    std::int32_t index_;
    bool lets_out_;
    Matrix3 turn_WC_{Matrix3::Identity()};
    bool has_turned_ = false;
    std::shared_ptr<const CollisionMesh> stuff_;
    Pose shape_B_;
    bool is_placed_;  // elsewhere than the body
};

}  // namespace fulcrum
