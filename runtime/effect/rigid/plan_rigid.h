// The part of the plan that is a world of rigid bodies. For compile_plan.cpp.
//
// Thread: load path.
#pragma once

#include "runtime/scene/plan.h"

namespace fulcrum::runtime {

/// Where a scene has rigid bodies, their world, with the ground and the solid bodies that stay; and which of the haptic plan's solids they
/// are. The solids and the tool are in the plan. Refuses, with the body's line, one that cannot be simulated, and what
/// is said of a body's simulation where none is rigid.
[[nodiscard]] Expected<void> add_rigid_bodies(const LessonDescription& lesson,
                                              const SolidLoader& load_solid,
                                              const PlanOptions& options, Plan& plan);

}  // namespace fulcrum::runtime
