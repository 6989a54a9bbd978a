// The 3-DOF proxy: where the point of the tool may be, given where the hand holds it.
//
// Thread: haptic loop. Cost: bounded by the number of triangles near the path; no allocation in `step`.
#pragma once

#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace fulcrum {

inline constexpr std::size_t kMaxTouches = 3;

/// One plane of a solid that holds the proxy. A coupling of stiffness k pushes the solid with -k (push_m normal_W + drag_W).
struct SolidTouch {
    std::int32_t solid = kNoBody;        ///< index in the plan
    std::int32_t feature = -1;           ///< the mesh's triangle; of another shape 0 or -1
    Vector3 normal_W{Vector3::UnitY()};  ///< unit, away from the surface
    double push_m = 0.0;  ///< how far the plane holds the proxy off the hand, 0 or more
    Vector3 drag_W{
        Vector3::Zero()};  ///< metres along the plane that friction holds the proxy off the hand
    double friction_coefficient = 0.0;  ///< that holds here now, at rest or sliding
    double viscous_m = 0.0;             ///< of the drag: what no push bounds
    /// Where the solid has taken the place that the proxy had at the end of the last step.
    Vector3 anchor_W{Vector3::Zero()};
};

/// What a proxy found in one step: proxy - hand = sum over the touches of push_m normal_W + drag_W.
struct ProxyContact {
    Vector3 position_W{Vector3::Zero()};  ///< the proxy; equals the hand's position in free space
    std::int32_t solid =
        kNoBody;  ///< index in the plan of the solid that pushes most, kNoBody in free space
    std::int32_t n_constraints = 0;  ///< active planes, 0 to 3: as many of `touches` count
    Vector3 normal_W{
        Vector3::Zero()};  ///< unit, along all that the planes push; zero in free space
    std::array<SolidTouch, kMaxTouches> touches{};

    [[nodiscard]] std::span<const SolidTouch> active() const noexcept {
        return {touches.data(), static_cast<std::size_t>(n_constraints)};
    }
};

class Proxy {
  public:
    Proxy() = default;
    Proxy(const Proxy&) = delete;
    Proxy& operator=(const Proxy&) = delete;
    virtual ~Proxy() = default;

    /// Puts the proxy on the hand, as at the start of a run; no solid is touched.
    virtual void reset(const Vector3& hand_W) noexcept = 0;
    /// Puts a solid elsewhere at once, instead of moving it there: it pushes nobody on the way, and where it comes to lie on the hand
    /// it lets the hand through until that has left it. An index beyond the plan's solids is ignored.
    virtual void put_solid(std::size_t solid, const Pose& pose_W) noexcept = 0;
    /// Turns the cursor towards the hand's turn, as far as the solids where they are allow (virtual_proxy.h); once before each `step`. Tells
    /// how it is turned then: a ball and a point as the hand. A turn that is not finite leaves all as it was.
    virtual Quaternion turn(const Quaternion& hand_turn_W) noexcept { return hand_turn_W; }
    /// Moves the proxy towards the hand as far as the solids allow. `solid_poses_W` has one pose a solid of the plan.
    virtual const ProxyContact& step(const Vector3& hand_W,
                                     std::span<const Pose> solid_poses_W) noexcept = 0;
};

/// A proxy without friction whose step has two halves, so that a law of friction can choose the goal between them.
class SurfaceObject : public Proxy {
  public:
    /// First half: the solids are here now. One that is touched takes the proxy along; `contact` tells its planes anew, their
    /// anchors and no push. Poses beyond the number of solids are ignored, missing ones unchanged.
    virtual void carry(std::span<const Pose> solid_poses_W) noexcept = 0;
    /// Second half: goes as near to the goal as the solids allow. The contact's pushes are against the goal.
    virtual const ProxyContact& follow(const Vector3& goal_W) noexcept = 0;
    [[nodiscard]] virtual const ProxyContact& contact() const noexcept = 0;

    const ProxyContact& step(const Vector3& hand_W,
                             std::span<const Pose> solid_poses_W) noexcept final {
        carry(solid_poses_W);
        return follow(hand_W);
    }
};

}  // namespace fulcrum
