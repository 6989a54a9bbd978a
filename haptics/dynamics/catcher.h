// The bucket on the tool: whether a body came in through its opening, and where in it the body
// comes to rest. See world.h.
//
// Thread: the world loop. Cost: two transforms a falling body and step.
#pragma once

#include "haptics/dynamics/rigid_body.h"
#include "haptics/dynamics/world_plan.h"
#include "haptics/math/spatial.h"

#include <cstddef>
#include <span>

namespace fulcrum {

/// A body's way through the opening's plane.
struct Crossing {
    bool inside = false;    ///< it went down through the opening
    double share = 0.0;     ///< how much of the step had passed, 0 to 1
    double radius_m = 0.0;  ///< distance from the opening's centre there
};

class Catcher {
  public:
    explicit Catcher(const CatcherPlan& plan) noexcept : plan_(plan) {}

    [[nodiscard]] bool present() const noexcept { return plan_.present; }
    /// How far from the centre of the opening a body's centre may cross: the opening less a quarter
    /// of the body's radius (further out it would tip off the rim), and never less than half the
    /// opening.
    [[nodiscard]] double compute_reach_m(double body_radius_m) const noexcept;
    /// Did the centre, at `before_T` and then `after_T` in the tool's frame, go down through the
    /// opening between them?
    [[nodiscard]] Crossing compute_crossing(const Vector3& before_T, const Vector3& after_T,
                                            double body_radius_m) const noexcept;
    /// Where the body comes to rest on those already held, in the tool's frame: aside from the
    /// middle, each in another direction, as low as the floor and those spheres allow.
    [[nodiscard]] Vector3 compute_resting_place(double body_radius_m,
                                                std::span<const RigidBody> bodies) const noexcept;

  private:
    CatcherPlan plan_;
};

}  // namespace fulcrum
