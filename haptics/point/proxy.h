// The 3-DOF proxy: where the point of the tool may be, given where the hand holds it.
//
// Thread: haptic loop. Cost: bounded by the number of triangles near the path; no allocation in `step`.
#pragma once

#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

#include <cstdint>
#include <span>

namespace fulcrum {

/// What a proxy found in one step.
struct ProxyContact {
    Vector3 position_W{Vector3::Zero()};  ///< the proxy; equals the hand's position in free space
    std::int32_t solid =
        kNoBody;  ///< index of the touched solid in the plan, kNoBody in free space
    std::int32_t n_constraints = 0;  ///< active planes, 0 to 3
    Vector3 normal_W{
        Vector3::Zero()};  ///< unit vector from proxy away from the surface; zero in free space
};

class Proxy {
  public:
    Proxy() = default;
    Proxy(const Proxy&) = delete;
    Proxy& operator=(const Proxy&) = delete;
    virtual ~Proxy() = default;

    /// Puts the proxy on the hand, as at the start of a run; no solid is touched.
    virtual void reset(const Vector3& hand_W) noexcept = 0;
    /// Moves the proxy towards the hand as far as the solids allow. `solid_poses_W` has one pose a solid of the plan.
    virtual const ProxyContact& step(const Vector3& hand_W,
                                     std::span<const Pose> solid_poses_W) noexcept = 0;
};

}  // namespace fulcrum
