// One solid as a proxy sees it: a mesh, where it is now, and where in its own frame the proxy was last.
//
// Thread: haptic loop. Cost: a sweep is some tens of nanoseconds near the last one, O(log n) elsewhere; no allocation.
#pragma once

#include "haptics/collision/segment_query.h"
#include "haptics/collision/segment_structure.h"
#include "haptics/math/spatial.h"
#include "haptics/point/solid_plan.h"

#include <cstdint>
#include <memory>

namespace fulcrum {

/// The plane of a touched triangle, on the proxy's side of it.
struct TouchedPlane {
    std::int32_t solid = kNoBody;
    std::int32_t triangle = -1;
    int side = 1;                        ///< +1 the triangle's front, -1 its back
    Vector3 normal_W{Vector3::UnitY()};  ///< unit, towards the proxy
    Vector3 point_W{Vector3::Zero()};    ///< a corner of the triangle
    double clearance_m = 0.0;            ///< how high above the plane the proxy is held

    [[nodiscard]] double height_m(const Vector3& p_W) const noexcept {
        return normal_W.dot(p_W - point_W);
    }
};

class MovingSolid {
  public:
    /// `index` is the solid's place in the plan. The shape must be made of triangles.
    MovingSolid(const SolidPlan& plan, std::int32_t index,
                SegmentStructureKind structure = SegmentStructureKind::bounding_tree);

    /// Moves the solid; true when that changed anything. A pose that is not finite is ignored.
    bool take_pose(const Pose& pose_W) noexcept;
    /// Says where the proxy is; there must be no triangle between here and where it was.
    void put_proxy(const Vector3& proxy_W) noexcept { proxy_B_ = to_body(proxy_W); }
    /// Where the proxy would be, had it moved along with the solid.
    [[nodiscard]] Vector3 carried_proxy_W() const noexcept { return to_world(proxy_B_); }

    /// First triangle between the proxy's place in the solid's frame and `to_W`.
    [[nodiscard]] SegmentHit sweep(const Vector3& to_W) const noexcept;
    /// The same, by the triangles remembered around the proxy; collects them anew, `reach_m` around, when needed.
    [[nodiscard]] SegmentHit sweep_nearby(const Vector3& to_W, double reach_m) noexcept;

    /// How often triangles had to be searched for from the root in `sweep_nearby`: what it cost.
    [[nodiscard]] std::uint64_t n_searches() const noexcept { return n_searches_; }

    /// The triangle in which the proxy lies exactly, if any.
    [[nodiscard]] SegmentHit find_touching() const noexcept {
        return find_nearest_hit(*mesh_, proxy_B_, proxy_B_);
    }
    /// The plane of a triangle, where the solid is now.
    [[nodiscard]] TouchedPlane find_plane(std::int32_t triangle, int side) const noexcept;
    /// Does the proxy stand over the triangle, or does its foot lie beside it?
    [[nodiscard]] bool is_over(std::int32_t triangle) const noexcept;
    /// Can a point within `radius_m` of `centre_W` reach the solid?
    [[nodiscard]] bool is_near(const Vector3& centre_W, double radius_m) const noexcept;

  private:
    [[nodiscard]] Vector3 to_body(const Vector3& p_W) const noexcept {
        return turn_.transpose() * (p_W - origin_W_);
    }
    [[nodiscard]] Vector3 to_world(const Vector3& p_B) const noexcept {
        return turn_ * p_B + origin_W_;
    }

    [[nodiscard]] SegmentHit sweep_B(const Vector3& to_B) const noexcept {
        return structure_ ? structure_->find_nearest_hit(proxy_B_, to_B)
                          : find_nearest_hit(*mesh_, proxy_B_, to_B);
    }

    std::shared_ptr<const CollisionMesh> mesh_;
    std::unique_ptr<SegmentStructure> structure_;  // none: the mesh's own tree, and what is nearby
    std::int32_t index_;
    Pose pose_W_;
    Matrix3 turn_{Matrix3::Identity()};  // R_WB
    Vector3 origin_W_{Vector3::Zero()};
    Vector3 proxy_B_{Vector3::Zero()};
    NearbyTriangles nearby_;
    std::uint64_t n_searches_ = 0;
};

}  // namespace fulcrum
