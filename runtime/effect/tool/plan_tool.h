// The tool in the hand, as the plan needs it: its points and springs, and every solid body as tool_bodies.h makes it. For compile_plan.cpp.
//
//   hand    masses and springs are as the hand feels them: m = mass / scale, k = stiffness / scale, k_r = turn stiffness x scale
//   points  as many as the lesson says or 2000, on the surface; among voxels a point a voxel of the tool, where that is no more than the lesson
//           says or a step has time for
//   time    in a live run half of each step (check_tool.h), so that the loop is never late for its tool, or a thread of its own finds contact
//           beside the steps; else as long as it takes, so that a run is the same each time
//
// What can be refused is refused before anything that takes long is made: bodies and voxels first, then the tool, then its springs.
// What takes long comes from the cache of shapes where it has been made before.
//
// Thread: load path. Cost: that of tool_bodies.h, and 1 us a point.
#pragma once

#include "haptics/tool/tool_plan.h"
#include "runtime/scene/plan.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Gives the plan its tool, where the lesson has one, and a notice of each body with holes, if a field closes them; the plan has its
/// solids already. Refuses with one sentence and the line of
/// the lesson what cannot be made: no body to touch, a bucket beside it, materials (a tool of points feels shape alone, a god-object their friction too), voxels
/// that are too many, a model that encloses nothing, what check_tool.h refuses.
[[nodiscard]] Expected<void> add_tool(const LessonDescription& lesson,
                                      const SolidLoader& load_solid, const PlanOptions& options,
                                      Plan& plan);

/// Whether a live run has a thread that finds the tool's contacts, or moves it, beside the haptic loop: by how it is kept outside.
[[nodiscard]] bool has_thread(const ToolDescription& tool);
/// What it does, as a stage of the plan, which has its tool already.
[[nodiscard]] PlanStage make_contact_stage(const LessonDescription& lesson, const Plan& plan);

/// What the tool is like, in a few words: "cylinder", or its model's name.
[[nodiscard]] std::string name_of(const ToolDescription& tool);

/// A solid body as the tool meets it.
struct ToolObjectFacts {
    VoxelFrame frame;  ///< of a god-object's body, or one of contact levels, no voxels
    std::size_t bytes = 0;
    std::int32_t n_triangles = 0;  ///< of such a body
    FrictionSettings friction{};   ///< of a god-object's body
    double texture_m = 0.0;        ///< how high the relief is that the tool feels of it
    bool rounded = false;          ///< its facets are felt as one even surface
    std::int32_t n_levels = 0;     ///< of contact levels
    std::int32_t n_pieces = 0;     ///< likewise
};

/// Of each solid, in the plan's order.
[[nodiscard]] std::vector<ToolObjectFacts> find_object_facts(const ToolPlan& plan);

/// "made now" or "from the cache".
[[nodiscard]] const char* name_of(ShapeSource source);

/// "fields" or "levels", as a lesson calls it.
[[nodiscard]] const char* name_of(ContactFinding contact);

/// "planes", "linearised" or "held", as a lesson calls it.
[[nodiscard]] const char* name_of(PenaltyModel model);

/// "field_sampling", "voxel_sampling", "implicit_penalty" or "god_object", as a lesson calls it.
[[nodiscard]] const char* name_of(ToolMethod method);

/// For people who ask what runs: method, points, springs, and the voxels of each body, made now or from the cache; empty without a
/// tool.
[[nodiscard]] std::string tool_table(const LessonDescription& lesson, const Plan& plan);

}  // namespace fulcrum::runtime
