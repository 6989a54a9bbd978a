// The part of the plan that is touched: materials, solid bodies, and what touches them. For compile_plan.cpp.
//
// Thread: load path.
#pragma once

#include "runtime/scene/plan.h"

#include <vector>

namespace fulcrum::runtime {

/// Each material of the lesson ready to be felt, in the hand's metres; pictures are read. Walls are fitted to
/// the device (plan_walls.h).
[[nodiscard]] Expected<std::vector<Material>> make_materials(const LessonDescription& lesson,
                                                             const WallHolders& holders,
                                                             const PictureLoader& load_picture,
                                                             Plan& plan);

/// Adds the solid bodies, each with its material; `audible`: somebody hears them.
[[nodiscard]] Expected<void> add_solids(const LessonDescription& lesson,
                                        const SolidLoader& load_solid,
                                        const std::vector<Material>& materials, bool audible,
                                        HapticPlan& plan);

/// What the lesson chose, or the least that shows what the solids of the plan have.
[[nodiscard]] Expected<void> choose_proxy(const LessonDescription& lesson,
                                          const SolidLoader& load_solid, HapticPlan& plan);

}  // namespace fulcrum::runtime
