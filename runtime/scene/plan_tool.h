// The tool in the hand, as the plan needs it: its points, and every solid body as voxels or as a distance field. For plan.cpp.
//
//   voxel   as the lesson says; else as fine as a body's longest side asks for, with at most so many voxels:
//             s = max(length / 400, (volume of its box / 4 million)^(1/3))
//   fields  4 voxels deep on both sides of the surface
//   voxels  the layer that pushes lies one voxel outside the body, so that the tool's and the body's surfaces never meet; those that
//           brake reach 4 mm further, in the hand's metres: two steps of a hand at 2 m/s
//   hand    masses and springs are as the hand feels them: m = mass / scale, k = stiffness / scale, k_r = turn stiffness x scale
//
// What takes long to make comes from the cache of shapes where it has been made before.
//
// Thread: load path. Cost: 10 ms and 1 byte a voxel up to 4 million for each body; with a lesson's own voxels at most kMostVoxels.
#pragma once

#include "haptics/tool/tool_plan.h"
#include "runtime/scene/plan.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Of all bodies together: 64 MB while they are made, a second.
inline constexpr double kMostVoxels = 64.0e6;

/// Gives the plan its tool, where the lesson has one, and a notice of each body with holes, if a field closes them; the plan has its
/// solids already. Refuses with one sentence and the line of
/// the lesson what cannot be made: no body to touch, a bucket beside it, materials (a tool of points feels shape alone), voxels
/// that are too many, a model that encloses nothing, what check_tool.h refuses.
[[nodiscard]] Expected<void> add_tool(const LessonDescription& lesson,
                                      const SolidLoader& load_solid, const PlanOptions& options,
                                      Plan& plan);

/// What the tool is like, in a few words: "cylinder", or its model's name.
[[nodiscard]] std::string name_of(const ToolDescription& tool);

/// A solid body as the tool meets it.
struct ToolObjectFacts {
    VoxelFrame frame;
    std::size_t bytes;
};

/// Of each solid, in the plan's order.
[[nodiscard]] std::vector<ToolObjectFacts> find_object_facts(const ToolPlan& plan);

/// "voxel_sampling" or "field_sampling", as a lesson calls it.
[[nodiscard]] const char* name_of(ToolMethod method);

/// For people who ask what runs: method, points, springs, and the voxels of each body, made now or from the cache; empty without a
/// tool.
[[nodiscard]] std::string tool_table(const LessonDescription& lesson, const Plan& plan);

}  // namespace fulcrum::runtime
