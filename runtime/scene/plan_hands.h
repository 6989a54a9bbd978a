// The hands beside the first: each has a haptic loop of its own among the same bodies. For compile_plan.cpp.
//
//   same for all   bodies, materials, declared forces, rigid bodies and how they are pushed, rate, limits
//   its own        centre, scale, cursor and proxy, and so the springs of what it touches
// What one hand alone can hold goes with no other: a bucket, a kite, a body on a hinge, which the hand's own loop turns, what falls and is
// caught, the lesson's own force, and a tool, which has half of each round's time.
//
// Thread: load path.
#pragma once

#include "haptics/surface/material.h"
#include "runtime/scene/plan.h"

#include <vector>

namespace fulcrum::runtime {

/// Refuses what goes with one hand alone, whoever is there.
[[nodiscard]] Expected<void> check_more_hands(const LessonDescription& lesson);

/// Plans as many of them as are there. The plan has the first hand, rigid bodies included, already.
[[nodiscard]] Expected<void> add_more_hands(const LessonDescription& lesson,
                                            const SolidLoader& load_solid,
                                            const std::vector<Material>& materials,
                                            const PlanOptions& options, Plan& plan);

/// The loop of a hand, as a plan's stages name it: "haptic", "hand 2".
[[nodiscard]] std::string name_of_loop(std::size_t hand);

/// The lesson as if a hand of it, counted from 0, were its only one.
[[nodiscard]] LessonDescription as_seen_by(const LessonDescription& lesson, std::size_t hand);

}  // namespace fulcrum::runtime
