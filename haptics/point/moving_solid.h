// One solid as a proxy sees it: a mesh, where it is now, and where in its own frame the proxy was last.
//
// Thread: haptic loop. Cost: a sweep is some tens of nanoseconds near the last one, O(log n) elsewhere; looking ahead a bounded
// part of a search a step; no allocation.
#pragma once

#include "haptics/collision/enclosure.h"
#include "haptics/collision/segment_query.h"
#include "haptics/collision/segment_structure.h"
#include "haptics/math/spatial.h"
#include "haptics/point/proxy_frame.h"
#include "haptics/point/solid_plan.h"

#include <cstdint>
#include <memory>

namespace fulcrum {

/// The plane of a touched triangle, on the proxy's side of it.
struct TouchedPlane {
    std::int32_t solid = kNoBody;
    std::int32_t feature = -1;           ///< the triangle
    int side = 1;                        ///< +1 the triangle's front, -1 its back
    Vector3 normal_W{Vector3::UnitY()};  ///< unit, towards the proxy
    Vector3 point_W{Vector3::Zero()};    ///< a corner of the triangle
    double clearance_m = 0.0;            ///< how high above the plane the proxy is held

    [[nodiscard]] double height_m(const Vector3& p_W) const noexcept {
        return normal_W.dot(p_W - point_W);
    }
};

class MovingSolid : public ProxyFrame {
  public:
    static constexpr bool kBends = false;  ///< its planes stay as they are while the proxy slides

    /// `index` is the solid's place in the plan. The shape must be made of triangles.
    MovingSolid(const SolidPlan& plan, std::int32_t index,
                SegmentStructureKind structure = SegmentStructureKind::bounding_tree);

    /// First triangle between the proxy's place in the solid's frame and `to_W`.
    [[nodiscard]] SegmentHit sweep(const Vector3& to_W) const noexcept;
    /// The same, by the triangles remembered around the proxy; collects them anew, `reach_m` around, when needed.
    [[nodiscard]] SegmentHit sweep_nearby(const Vector3& to_W, double reach_m) noexcept;

    /// At the end of a step in which the proxy came `reach_m`: collects part of the triangles that it will need next.
    void look_ahead(double reach_m) noexcept;

    /// How often triangles had to be searched for from the root in `sweep_nearby`: what it cost.
    [[nodiscard]] std::uint64_t n_searches() const noexcept { return n_searches_; }

    /// The triangle in which the proxy lies exactly, if any.
    [[nodiscard]] SegmentHit find_touching() const noexcept {
        return find_nearest_hit(*mesh_, proxy_B(), proxy_B());
    }
    /// The plane of a triangle, where the solid is now.
    [[nodiscard]] TouchedPlane find_plane(std::int32_t triangle, int side) const noexcept;
    /// Does the proxy stand over the triangle, or does its foot lie beside it?
    [[nodiscard]] bool is_over(std::int32_t triangle) const noexcept;
    /// Does the place lie in the solid, so that a proxy there must be let out?
    [[nodiscard]] bool holds(const Vector3& p_W) const noexcept {
        return lets_out_ && is_in_stuff(*mesh_, to_body(p_W));
    }
    /// Can a point within `radius_m` of `centre_W` reach the solid?
    [[nodiscard]] bool is_near(const Vector3& centre_W, double radius_m) const noexcept;

  private:
    [[nodiscard]] SegmentHit sweep_B(const Vector3& to_B) const noexcept {
        return structure_ ? structure_->find_nearest_hit(proxy_B(), to_B)
                          : find_nearest_hit(*mesh_, proxy_B(), to_B);
    }

    // Remembers the triangles around the proxy and its way to `end_B`, as far around as they fit.
    void collect_nearby(const Vector3& end_B, double reach_m) noexcept;
    void adapt_margin(bool fits) noexcept;

    std::shared_ptr<const CollisionMesh> mesh_;
    std::unique_ptr<SegmentStructure> structure_;  // none: the mesh's own tree, and what is nearby
    std::int32_t index_;
    bool lets_out_;
    NearbyTriangles nearby_;
    double margin_ = 2.0;  // how far around they are collected, of the reach asked for
    Vector3 last_proxy_B_{Vector3::Zero()};  // where the last look ahead was from
    std::uint64_t n_searches_ = 0;
};

}  // namespace fulcrum
