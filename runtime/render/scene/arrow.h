// A force as an arrow: its tail where the force acts, its length in step with its newtons.
//
//   length = kLengthPerNewton F D, D the camera's distance to its target, so that an arrow looks
//   alike in a lesson about fruit and in one about planets; never shorter than its head. Forces that are compared
//   are drawn to one scale: where the largest would be too long, all are shortened by the same factor; those that act on one thing
//   are lengthened as well where they are short, and slim, so that none hides another.
//
// Thread: any; values. Cost: a few dozen multiplications.
#pragma once

#include "runtime/render/camera.h"
#include "runtime/render/scene/placement.h"
#include "runtime/scene/view.h"

#include <optional>

namespace fulcrum::runtime {

/// Arrow length for 1 N seen from 1 m.
inline constexpr double kLengthPerNewton = 0.037;
/// The longest arrow, as a part of the camera's distance: about 6 N.
inline constexpr double kLongestArrow = 0.222;
/// The force whose arrow is as long as that.
inline constexpr double kLongestForce_N = kLongestArrow / kLengthPerNewton;
/// Below this no arrow is drawn: the hand does not feel it.
inline constexpr double kLeastForce_N = 0.05;

/// The two parts of an arrow, to be drawn with make_arrow_shaft and make_arrow_head.
struct Arrow {
    Placement shaft;
    Placement head;
    Vector3 tail_W{Vector3::Zero()};
    Vector3 tip_W{Vector3::Zero()};
    double radius_m = 0.0;  ///< of the head
    ForceLook look = ForceLook::hand;
};

/// How an arrow is drawn beside others.
struct ArrowStyle {
    double scale = 1.0;  ///< so many times as long as alone
    double girth = 1.0;  ///< so many times as thick, its head likewise
};

/// The arrow of a force. Nothing when it is not visible, too small, or not finite.
[[nodiscard]] std::optional<Arrow> arrow_for(const ViewForce& force, const Camera& camera,
                                             const ArrowStyle& style = {});

/// Of forces that act on one thing near each other: slim, and to one scale, at which the largest is as long as an arrow may be, but no
/// more than kMostStretch times as long as alone.
[[nodiscard]] ArrowStyle style_of_balance(const std::vector<ViewForce>& forces);
inline constexpr double kMostStretch = 2.0;

/// The scale to which forces are drawn that are compared: 1, or less when the largest would be too long.
[[nodiscard]] double common_scale(const std::vector<ViewTorque>& torques);

/// The lever arm of a torque: a bar from the axis to where the force acts, for make_arrow_shaft. Nothing when it has no length
/// or is not finite.
[[nodiscard]] std::optional<Placement> arm_for(const ViewTorque& torque, const Camera& camera);

}  // namespace fulcrum::runtime
