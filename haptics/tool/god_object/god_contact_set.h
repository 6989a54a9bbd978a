// The constraint set of a god-object's tool, that the motion hands to what makes the force; and where the motion is to take the tool.
//
//   haptic loop   where the handle is           -> goal -> motion (god_motion.h), as long as that takes
//   motion        where the tool got, by what it is held there -> set  -> haptic loop (god_object_tool.h): the force of it, each step
//
// Thread: one fills a set, the other reads it. Cost: a copy of what presses, 140 bytes each.
// Source: M. Ortega, S. Redon, S. Coquillart 2007, IEEE TVCG 13(3), sections 3.2 and 5: the force from the last constraint set, on a loop of its own.
#pragma once

#include "haptics/handover/latest_value.h"
#include "haptics/handover/messages.h"
#include "haptics/tool/god_object/god_object_plan.h"

#include <array>
#include <cstdint>
#include <span>

namespace fulcrum {

/// What may press at a time, of all objects together; what is more holds the tool all the same, and is not felt.
inline constexpr std::size_t kMostPresses = 2048;

/// A contact that may press the tool where that is.
struct GodPress {
    std::int32_t object = 0;            ///< in the plan's order
    Vector3 arm_W{Vector3::Zero()};     ///< from the tool's centre of mass
    Vector3 normal_W{Vector3::Zero()};  ///< unit, as it is felt: from the object to the tool
    Vector3 true_W{Vector3::Zero()};    ///< as it is, where a surface is shaded
    Vector3 on_object_O{Vector3::Zero()};
    double least_m = 0.0;   ///< the tool may still go so far against the normal, below 0, or 0
    double friction = 0.0;  ///< its coefficient
    double share = 1.0;     ///< 0 as far off as what may press is, 1 from the gap at rest on
};

/// One object when the set was found.
struct GodObjectPlace {
    Pose object_W{};
    Pose from_OT{},
        to_OT{};  ///< where the tool was over it before the step and after it, where slips are followed
};

struct GodContactSet {
    double stamp_s = -1.0;           ///< of the goal that it was found for; below 0: none yet
    std::uint32_t n_placements = 0;  ///< as that goal had it
    bool is_apart =
        true;  ///< else tool and objects overlapped where it was placed: it stands still
    bool is_near = false;  ///< something is near the tool: only then a force outlasts its contact
    GodObjectStep step{};
    Pose tool_W{};
    std::int32_t n_objects = 0;
    std::array<GodObjectPlace, kMaxSolids> objects{};
    std::int32_t n = 0;
    std::array<GodPress, kMostPresses> presses{};  ///< object by object

    [[nodiscard]] std::span<const GodPress> all() const noexcept {
        return {presses.data(), static_cast<std::size_t>(n)};
    }
};

/// Where the motion is to take the tool.
struct GodGoal {
    double stamp_s = -1.0;
    std::uint32_t n_placements = 0;  ///< grows when the tool was put elsewhere, to `placed_W`
    Pose placed_W{};                 ///< the tool, by its centre of mass
    Pose held_W{};                   ///< likewise, where the handle would have it
    std::int32_t n_objects = 0;
    std::array<MovingFrame, kMaxSolids> objects{};
};

/// Between the haptic thread and the motion's.
struct GodChannels {
    LatestValue<GodGoal> goal;       ///< haptic loop; motion
    LatestValue<GodContactSet> set;  ///< motion; haptic loop
};

}  // namespace fulcrum
