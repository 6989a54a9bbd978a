// A proxy with friction: a surface object that slides freely, and a law that says how far it may.
//
//   carry the surface object with its solid -> solve friction at the planes that hold it -> let it follow the goal
//   goal = hand + sum of the drags (friction_problem.h)
// In the terms of the friction cone algorithm the hand is the cone's apex, the friction circle's radius is mu times the push, and
// the god object stays while it lies in the circle and else is moved to its edge. Here the god object is the surface object
// itself, on its own planes: it collides wherever it goes, so that "the average of the two planes" of Barrow and
// Harwin, right to first order on a curved surface, is not needed. Several solids hold it at once, each with its own
// planes, anchor and coefficients; each gets its own reaction.
//
// Thread: haptic loop. Cost: that of the surface object, and about 50 ns on one plane; no allocation.
// Source: see friction_problem.h.
#pragma once

#include "haptics/point/friction_problem.h"
#include "haptics/point/proxy.h"

#include <array>
#include <memory>
#include <vector>

namespace fulcrum {

class FrictionCone final : public Proxy {
  public:
    /// One law for each solid of the plan.
    FrictionCone(std::unique_ptr<SurfaceObject> surface_object, std::vector<FrictionLaw> laws,
                 int max_rounds);

    void reset(const Vector3& hand_W) noexcept override;
    void put_solid(std::size_t solid, const Pose& pose_W) noexcept override;
    Quaternion turn(const Quaternion& hand_turn_W) noexcept override {
        return surface_object_->turn(hand_turn_W);
    }
    const ProxyContact& step(const Vector3& hand_W,
                             std::span<const Pose> solid_poses_W) noexcept override;

    /// Does the solid hold the proxy fast?
    [[nodiscard]] bool is_stuck(std::int32_t solid) const noexcept {
        return stuck_[static_cast<std::size_t>(solid)] != 0;
    }

  private:
    using Planes = std::array<FrictionPlane, kMaxTouches>;

    [[nodiscard]] std::span<FrictionPlane> hold(const Vector3& hand_W, Planes& storage) noexcept;
    void share_drag(std::span<const SolidTouch> before,
                    std::span<const FrictionPlane> planes) noexcept;

    std::unique_ptr<SurfaceObject> surface_object_;
    std::vector<FrictionLaw> laws_;
    std::vector<char> stuck_;  // of each solid
    int max_rounds_;
    ProxyContact contact_;
};

}  // namespace fulcrum
