// When two convex bodies on their way come near each other.
//
//   gap(t + s) >= gap(t) - s r,   r = -n . (v_first - v_second) + |w_first| R_first + |w_second| R_second
// along the direction n that keeps them apart at t (contact_axis.h): as long as that is more than `near` they do not meet, so the time may
// go on by (gap - near / 2) / r and be looked at again; where r is 0 or less, to the end. R is the body's radius about the point that it
// turns about. So what passes by is told from what is hit, however fast and thin. A pair that is still not decided after kMostLooks
// counts as met there.
//
// Thread: any. Cost: some 2 to 10 times that of contact_axis.h; no allocation.
// Source: B. Mirtich 1996, Impulse-based dynamic simulation of rigid body systems, thesis, section 2.3 (conservative advancement).
#pragma once

#include "haptics/collision/contact_manifold.h"
#include "haptics/collision/contact_shape.h"

namespace fulcrum {

inline constexpr int kMostLooks = 48;

/// A body that moves evenly and turns evenly about a point of it.
struct MovingShape {
    const ContactShape* shape = nullptr;
    ContactPlace place{};               ///< now
    Vector3 centre_W{Vector3::Zero()};  ///< what it turns about
    Twist velocity_W{};                 ///< of that point
    double radius_m = 0.0;              ///< of the shape about it

    [[nodiscard]] Vector3 find_centre(double time_s) const noexcept {
        return centre_W + time_s * velocity_W.linear;
    }
    [[nodiscard]] ContactPlace find_place(double time_s) const noexcept;
};

/// The first time at which no more than `near_m`, above 0, lies between them; infinity where that is not before `end_s`.
[[nodiscard]] double find_meeting_s(const MovingShape& first, const MovingShape& second,
                                    double near_m, double end_s) noexcept;

}  // namespace fulcrum
