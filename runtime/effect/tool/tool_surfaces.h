// What a tool of triangles feels of surfaces besides their shape: each body's friction and relief by its material, and normals that turn evenly
// over the facets of what the lesson calls rounded. What no tool feels is taken out of the plan, and the teacher is told.
//
// Thread: load path. Cost: a texture once a material, even normals once a mesh.
#pragma once

#include "haptics/tool/tool_plan.h"
#include "runtime/effect/tool/tool_body_list.h"
#include "runtime/scene/plan.h"

#include <vector>

namespace fulcrum::runtime {

/// Into a god-object's plan among `solids`, whose meshes are listed; `tool` as the plan has it.
[[nodiscard]] Expected<void> put_surfaces(const LessonDescription& lesson, const ToolBodyList& list,
                                          const std::vector<SolidPlan>& solids,
                                          const TriangleMesh& tool,
                                          std::vector<GodObjectPlan>& plans);

/// From the solids of a plan with a tool; tells of each material once.
void leave_out_surfaces(const LessonDescription& lesson, Plan& plan);

}  // namespace fulcrum::runtime
