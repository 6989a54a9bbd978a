// Whether the tool that a lesson asks for can be moved on as it asks: told before it runs, with what would do, in one sentence with
// the line of the lesson.
//
// An explicit integrator shakes a tool that is too light for its spring and for what its points press against (step_limit.h). What
// would do is sought within a lesson's ranges, first a mass, then a spring beside the largest mass; backward Euler always does.
//
// Voxel sampling looks at every point in every step: more than fit in half a step, at 25 ns each, are too many. That is what a tool
// takes that lies flat, where Newton's method looks several times; one that is pressed anew may take more for some steps.
//
// Field sampling looks only at what is near, and in a live run only at as much as there is time for. What it would take where all
// points touch is told: 150 ns a point, measured for a tool that lies flat.
//
// Thread: load path. Cost: the integrator's nothing where it has no limit, else 20 ms, and a second where it refuses; the time's nothing.
#pragma once

#include "haptics/tool/step_limit.h"
#include "runtime/scene/description.h"

#include <optional>
#include <string>

namespace fulcrum::runtime {

/// What a tool may take of each step of a live run, microseconds: half of it.
[[nodiscard]] double find_tool_time_us(double rate_hz);

/// The same with the lesson's own budget, where it has one.
[[nodiscard]] double find_budget_us(const HandDescription& hand);

/// Points on the tool's surface, as the lesson says or 2000; and among voxels the most, as the lesson says or as half a step has time for.
[[nodiscard]] int find_surface_points(const ToolDescription& tool);
[[nodiscard]] int find_most_voxel_points(const HandDescription& hand);

/// One sentence where looking at all points at once would take longer than that: what a live run does then, and what would do.
[[nodiscard]] std::optional<std::string> find_tool_notice(const HandDescription& hand,
                                                          const ToolPlan& plan);

/// Refuses more points among voxels than a step has time for, and a budget longer than that: the lesson alone tells, before anything is made.
[[nodiscard]] Expected<void> check_tool_time(const HandDescription& hand);

/// Refuses an integrator that shakes the tool. `shell` is that of the plan's order; `plan` has been validated.
[[nodiscard]] Expected<void> check_tool(const HandDescription& hand, const ToolPlan& plan,
                                        const Pointshell& shell);

}  // namespace fulcrum::runtime
