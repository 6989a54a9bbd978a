// One solid as a god-object sees it where not all are made of triangles: a mesh (moving_solid.h), or a sphere, box, capsule or cylinder
// in closed form (moving_obstacle.h), which a point meets as a body of one feature.
//
// A shape's plane touches it at the place nearest to the proxy. All these shapes are convex, so none of it lies before that plane.
//
// Thread: haptic loop. Cost: that of the mesh, or some five closed forms a sweep; no allocation.
#pragma once

#include "haptics/point/moving_obstacle.h"
#include "haptics/point/moving_solid.h"

#include <cstdint>
#include <variant>

namespace fulcrum {

class MixedSolid {
  public:
    static constexpr bool kBends = true;

    /// As MovingSolid; a shape must not be a distance function, which need not be convex.
    MixedSolid(const SolidPlan& plan, std::int32_t index, SegmentStructureKind structure);

    // As ProxyFrame.
    bool take_pose(const Pose& pose_W) noexcept;
    void put_proxy(const Vector3& proxy_W) noexcept { frame().put_proxy(proxy_W); }
    [[nodiscard]] Vector3 carried_proxy_W() const noexcept { return frame().carried_proxy_W(); }
    [[nodiscard]] bool lets_through() const noexcept { return frame().lets_through(); }
    void let_through(bool on) noexcept { frame().let_through(on); }

    // As MovingSolid.
    [[nodiscard]] SegmentHit sweep(const Vector3& to_W) noexcept;
    [[nodiscard]] SegmentHit sweep_nearby(const Vector3& to_W, double reach_m) noexcept;
    void look_ahead(double reach_m) noexcept;
    [[nodiscard]] std::uint64_t n_searches() const noexcept;
    [[nodiscard]] SegmentHit find_touching() const noexcept;
    [[nodiscard]] TouchedPlane find_plane(std::int32_t feature, int side) const noexcept;
    /// The proxy stands over a shape wherever it is.
    [[nodiscard]] bool is_over(std::int32_t feature) const noexcept;
    [[nodiscard]] bool holds(const Vector3& p_W) const noexcept;
    [[nodiscard]] bool is_near(const Vector3& centre_W, double radius_m) const noexcept;

    /// Takes a shape's plane anew where the proxy is; true when the proxy hangs over it, farther than can be told from lying on it.
    [[nodiscard]] bool renew(TouchedPlane& plane) const noexcept;

  private:
    [[nodiscard]] const MovingSolid* mesh() const noexcept {
        return std::get_if<MovingSolid>(&solid_);
    }
    [[nodiscard]] MovingSolid* mesh() noexcept { return std::get_if<MovingSolid>(&solid_); }
    [[nodiscard]] const MovingObstacle& shape() const noexcept {
        return *std::get_if<MovingObstacle>(&solid_);
    }
    [[nodiscard]] MovingObstacle& shape() noexcept { return *std::get_if<MovingObstacle>(&solid_); }
    [[nodiscard]] const ProxyFrame& frame() const noexcept {
        const MovingSolid* const solid = mesh();
        return solid != nullptr ? static_cast<const ProxyFrame&>(*solid) : shape();
    }
    [[nodiscard]] ProxyFrame& frame() noexcept {
        MovingSolid* const solid = mesh();
        return solid != nullptr ? static_cast<ProxyFrame&>(*solid) : shape();
    }

    std::variant<MovingSolid, MovingObstacle> solid_;
};

}  // namespace fulcrum
