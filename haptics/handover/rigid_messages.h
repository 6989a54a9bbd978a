// What crosses between the haptic loop of a hand and the world of rigid bodies: one value each way, all solids of the hand's plan in it.
//
//   world of rigid bodies --RigidFrame--> haptic loop        haptic loop --HandPushes--> world of rigid bodies
#pragma once

#include "haptics/handover/latest_value.h"
#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstdint>

namespace fulcrum {

/// No step of the world is longer: after a longer pause it goes on from where it was. So a world that keeps up makes 20 steps a second at least.
inline constexpr double kLongestRigidStep_s = 0.05;

/// How steeply a push falls where the body gives way: of the spring and damper that a hand holds it by.
struct PushSlopes {
    double stiffness_N_per_m = 0.0;  ///< each 0 or more
    double damping_Ns_per_m = 0.0;
    double turn_stiffness_Nm_per_rad = 0.0;
    double turn_damping_Nms_per_rad = 0.0;
    double late_mass_kg =
        0.0;  ///< without which a damper that knows its velocity late would shake it
};

/// How a solid that is a rigid body is and moves.
struct RigidSolid {
    Pose pose_W{};                   ///< of its shape's frame
    Twist velocity_W{};              ///< of that frame's origin
    double behind_s = 0.0;           ///< how long before the frame's stamp that was
    bool is_present = false;         ///< false: it is not in the scene, or no rigid body
    std::uint32_t n_placements = 0;  ///< how often it was put elsewhere at once
};

/// World -> haptic loop, newest value; in the order of the plan's solids.
struct RigidFrame {
    double stamp_s = -1.0;  ///< of when its step began; before the first step negative
    double rate = 1.0;  ///< how much the world moved on in it, in the time that had passed: 0 to 1
    std::array<RigidSolid, kMaxSolids> solids{};
};

/// How far a hand goes along with the body that it holds, within a step.
struct PushBounds {
    /// A direction: so it pushes, and never draws. Zero: it grips, and holds every way and every turning.
    Vector3 along_W{Vector3::Zero()};
    double friction_N = 0.0;  ///< what it holds across `along_W`, each way
    double most_N = 0.0;      ///< that the hand may feel
    double most_Nm = 0.0;     ///< that it turns with, in all
};

/// How a hand holds a body.
struct BodyHold {
    Vector3 at_W{Vector3::Zero()};
    Wrench push_W{};  ///< on the body: a force there, and a couple
    PushSlopes slopes{};
    PushBounds bounds{};
};

/// How a hand pushes one solid.
struct RigidPush {
    std::int32_t solid = kNoBody;
    // As the hand took the solid to be when it pushed so.
    Pose pose_W{};
    Twist velocity_W{};
    std::uint32_t n_placements = 0;
    BodyHold hold{};
    bool puts = false;  ///< the solid is to be at pose_W at once, and nothing else
};

/// Haptic loop -> world, newest value.
struct HandPushes {
    double stamp_s = -1.0;
    std::int32_t count = 0;  ///< of them; solids that are not touched are left out
    std::array<RigidPush, kMaxSolids> pushes{};
};

/// Of one hand. Made before both loops, outlives them.
struct RigidChannels {
    LatestValue<RigidFrame> frame;   ///< writer: world; reader: haptic loop
    LatestValue<HandPushes> pushes;  ///< writer: haptic loop; reader: world
};

}  // namespace fulcrum
