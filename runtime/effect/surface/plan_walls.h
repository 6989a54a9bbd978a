// Walls and springs of a lesson, fitted to the device that renders them (stable_wall.h): what would shake in a hand is softer in the plan, which gets a
// notice of it, with the line that declared it. For compile_plan.cpp; the plan has its rate and limits already.
//
// Thread: load path.
#pragma once

#include "haptics/surface/material.h"
#include "runtime/scene/plan.h"

namespace fulcrum::runtime {

/// A wall is as stiff in the hand at every scale.
inline void scale_coupling(CouplingSettings& coupling, double scale) {
    coupling.stiffness_N_per_m /= scale;
    coupling.damping_Ns_per_m /= scale;
    coupling.linear_range_m *= scale;
    coupling.saturation_range_m *= scale;
}

/// Of any hand of the lesson: where forces are stiffest in it.
[[nodiscard]] double find_largest_scale(const LessonDescription& lesson);

/// What is touched and made of nothing: the usual coupling, or what of it is stable, in a hand of that scale.
[[nodiscard]] CouplingSettings make_usual_coupling(const HapticPlan& plan,
                                                   const WallHolders& holders, double scale);

/// A notice where that is softer than usual and a solid body of the lesson is touched with it.
void tell_usual_coupling(const LessonDescription& lesson, const WallHolders& holders, Plan& plan);

/// `material` is what was described, in the hand's metres, its picture read. Refuses, with the nearest that is stable, one of which not even the fastest
/// loop would leave kLeastKept on a desktop arm: it would be another material.
[[nodiscard]] Expected<void> fit_material(const MaterialDescription& described,
                                          const WallHolders& holders, Material& material,
                                          Plan& plan);

/// Of its stiffness as it was declared, what the tool's spring keeps: as a wall's without a damper, since what calms the tool is not felt when it
/// stands still against something.
[[nodiscard]] double fit_tool_spring(const LessonDescription& lesson, const WallHolders& holders,
                                     Plan& plan);

/// Gives the plan the lesson's declared forces. A spring about a place is a wall both ways, in any hand of the lesson.
void add_forces(const LessonDescription& lesson, const WallHolders& holders, Plan& plan);

}  // namespace fulcrum::runtime
