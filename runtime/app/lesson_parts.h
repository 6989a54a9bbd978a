// Where a run's parts come from: the lesson's process with the right simulated hand, and the meshes of solid bodies.
#pragma once

#include "haptics/base/error.h"
#include "runtime/app/places.h"
#include "runtime/lua/lesson_process.h"
#include "runtime/scene/plan.h"

#include <filesystem>
#include <memory>

namespace fulcrum::runtime {

struct RunRequest;

/// Starts the lesson; with `own_test` and no hand file, the hand of its first L:test is loaded beside it.
[[nodiscard]] Expected<std::unique_ptr<LessonProcess>> start_lesson(const Places& places,
                                                                    const RunRequest& request);

/// The touchable mesh of a body: "sphere" and "box" by rule, anything else from its model.
[[nodiscard]] SolidLoader make_solid_loader(const Places& places,
                                            const std::filesystem::path& lesson_folder);

}  // namespace fulcrum::runtime
