// A point that never enters a solid: it goes as near to the hand as the surfaces allow.
//
// Law: of all positions in front of the touched planes the proxy takes the nearest to the hand (plane_constraints.h).
// How it gets there makes it neither leak nor stick:
//  - It moves only along segments that, by exact signs, meet no triangle (segment_triangle.h), in the frame of each
//    solid. So in each solid's frame its path is a chain that no triangle cuts, whatever moved.
//  - On a hit it stops a hair (1e-10 of the solid's radius) in front, backing off along the segment, and the triangle's plane
//    joins the constraints. Planes that do not push are left.
//  - Where it comes to rest it asks whether it really stands over each touched triangle. If not, it tries to move on without
//    some of them: an edge that falls away must not hold it, nor convex neighbours pin it on their ridge.
//  - A solid that moves carries the proxy that touches it, and takes along one that it meets; between two solids
//    that close on it the proxy is pushed out sideways. If there is no way out it lets one solid pass and counts that.
// Both faces of a triangle are solid. A proxy that starts inside a body is held inside, unless that lets out (let_through.h). A pose
// that jumps is a motion too: `put_solid` and `reset` forgive it. All lengths are relative to the solid's size.
// Among solids that are shapes too (mixed_solid.h) a shape has the plane that touches it under the proxy, taken anew until the proxy lies
// on it: what such a plane leaves of the error shrinks by depth over the radius of curvature a round.
//
// Thread: haptic loop. Cost: bounded sweeps a step, each O(log n) at worst; no allocation, noexcept.
// Source: C. B. Zilles, J. K. Salisbury 1995, A constraint-based god-object method for haptic display, IROS.
#pragma once

#include "haptics/point/held_planes.h"
#include "haptics/point/mixed_solid.h"
#include "haptics/point/moving_solid.h"
#include "haptics/point/proxy.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

/// Solid is a MovingSolid where all are made of triangles, else a MixedSolid.
template <class Solid>
class GodObjectAmong final : public SurfaceObject {
  public:
    /// Farthest coordinate of a hand that is followed, metres; one beyond is ignored like NaN.
    static constexpr double kFarthest_m = 1.0e30;

    /// Takes solids that `validate` accepted; the proxy starts at the origin, `reset` puts it on the hand.
    explicit GodObjectAmong(const std::vector<SolidPlan>& solids,
                            SegmentStructureKind structure = SegmentStructureKind::bounding_tree);

    void reset(const Vector3& hand_W) noexcept override;
    void put_solid(std::size_t solid, const Pose& pose_W) noexcept override;
    void carry(std::span<const Pose> solid_poses_W) noexcept override;
    /// A goal that is not finite leaves all as it was.
    const ProxyContact& follow(const Vector3& goal_W) noexcept override;
    [[nodiscard]] const ProxyContact& contact() const noexcept override { return contact_; }

    /// How often a solid had to be let through, squeezed between two.
    [[nodiscard]] std::uint64_t n_squeezed() const noexcept { return n_squeezed_; }
    /// How often triangles had to be searched for, instead of being at hand from before.
    [[nodiscard]] std::uint64_t n_searches() const noexcept;
    /// Sweeps of the last step: what it cost.
    [[nodiscard]] int n_sweeps() const noexcept { return n_sweeps_; }

  private:
    // The triangles whose planes were used in this step, so that no two take turns for ever.
    struct KnownTriangle {
        std::int32_t solid;
        std::int32_t triangle;
    };
    struct Advance {
        bool blocked = false;
        double moved_m = 0.0;
        TouchedPlane plane;  // that blocked
    };
    struct Blocker {
        std::int32_t solid = kNoBody;
        SegmentHit hit;
    };
    using Planes = HeldPlanes<TouchedPlane>;

    static constexpr int kMaxSweeps = 64;  ///< in a step; a smooth surface takes about 2
    static constexpr std::size_t kMaxKnown = 32;

    // Motion of the solids (god_object_solids.cpp).
    void follow_touched() noexcept;
    [[nodiscard]] bool place_between(const Vector3& wish_W, const Blocker& first) noexcept;
    [[nodiscard]] Blocker find_blocker(const Vector3& to_W) noexcept;
    void accept(const Vector3& proxy_W) noexcept;
    void leave_surface() noexcept;

    // Motion to the goal.
    void find_near_solids(const Vector3& goal_W) noexcept;
    [[nodiscard]] std::span<const std::int32_t> near_solids() const noexcept {
        return {near_.data(), n_near_};
    }
    void follow_goal(const Vector3& goal_W) noexcept;
    void look_ahead() noexcept;
    [[nodiscard]] bool renew_planes() noexcept;
    [[nodiscard]] bool find_way_on(const Vector3& goal_W, bool has_moved) noexcept;
    [[nodiscard]] bool try_without(const Vector3& goal_W, unsigned kept) noexcept;
    [[nodiscard]] static Vector3 constrain(const Vector3& wish, const Vector3& from_W,
                                           Planes& planes) noexcept;
    [[nodiscard]] static bool contains(const Planes& planes, const TouchedPlane& other) noexcept;
    [[nodiscard]] Advance advance(const Vector3& target_W) noexcept;
    [[nodiscard]] Blocker sweep_all(const Vector3& to_W) noexcept;
    void move_to(const Vector3& proxy_W) noexcept;
    [[nodiscard]] bool is_known(const TouchedPlane& plane) const noexcept;
    void remember(const TouchedPlane& plane) noexcept;
    void publish(const Vector3& goal_W) noexcept;

    std::vector<Solid> solids_;
    // Solids that the hand's motion can reach in this step: the first n_near_ entries.
    std::vector<std::int32_t> near_;
    std::size_t n_near_ = 0;
    Vector3 proxy_W_{Vector3::Zero()};
    Vector3 goal_W_{Vector3::Zero()};
    double reach_m_ = 0.0;  // how far the goal came in this step: about as far as the proxy will go
    Planes planes_;
    std::array<KnownTriangle, kMaxKnown> known_{};
    std::size_t n_known_ = 0;
    int n_sweeps_ = 0;
    std::uint64_t n_squeezed_ = 0;
    ProxyContact contact_;
};

using GodObject = GodObjectAmong<MovingSolid>;

}  // namespace fulcrum
