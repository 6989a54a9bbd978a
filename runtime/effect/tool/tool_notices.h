// What a teacher should know of a scene in which a tool is felt, a sentence each: it can be played, and is felt otherwise than it
// looks.
//
//   thin wall   more than a twentieth of a body's surface is walls thinner than two of its voxels. Fields and voxels hold a wall's
//               middle from two voxels on; a thinner one pushes less and a tool may be pressed through
//   inside      the tool, in the middle of the hand's space, begins inside a body or touching it. Nothing is felt until it is
//               outside, so that no force begins at once (tool_stage.h)
//
// Thread: load path. Cost: 2 ms a mesh, and one sampling a body.
#pragma once

#include "haptics/tool/tool_plan.h"
#include "runtime/effect/tool/tool_body_list.h"

#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Of a mesh that is met in voxels of that side: the sentence names the body's line, and the thickness or the voxel that does.
[[nodiscard]] std::optional<std::string> tell_thin_wall(const ToolBodyList::Mesh& of,
                                                        double voxel_m);

/// Of each body that the tool begins in; `plan` has been validated.
[[nodiscard]] std::vector<std::string> tell_start_inside(const LessonDescription& lesson,
                                                         const std::vector<SolidPlan>& solids,
                                                         const ToolPlan& plan);

}  // namespace fulcrum::runtime
