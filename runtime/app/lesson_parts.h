// Where a run's parts come from: the lesson's process with the right simulated hand, and the meshes of solid bodies.
#pragma once

#include "haptics/base/error.h"
#include "haptics/geometry/triangle_mesh.h"
#include "runtime/app/places.h"
#include "runtime/app/run_request.h"
#include "runtime/lua/process/lesson_process.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// A lesson's process, and what somebody should know of its hands, a sentence each.
struct StartedLesson {
    std::unique_ptr<LessonProcess> process;
    std::vector<std::string> notices;
};

/// For LessonProcessOptions: a busy computer is told of once, on the terminal, and waited for, at most so long. Once the program is to end
/// an answer has half a second more: one that is under way comes.
[[nodiscard]] std::function<bool(double)> patience(std::optional<double> most_s);

/// Starts the lesson and settles the request's hands for it; with `own_test` and no hand file, those of its first L:test are loaded
/// beside it.
[[nodiscard]] Expected<StartedLesson> start_lesson(const Places& places, RunRequest& request);

/// A model that a lesson names: whose it is, for people, and where it says so.
struct NamedModel {
    std::string name;
    std::string owner;
    SourceLine line = 0;
    bool may_be_shape = true;  ///< sphere and box would do
};

/// All of them.
[[nodiscard]] std::vector<NamedModel> models_of(const LessonDescription& lesson);

/// Every model that the lesson names is there; an error names the body, its line and the nearest name.
[[nodiscard]] Expected<void> check_models(const Places& places,
                                          const std::filesystem::path& lesson_folder,
                                          const LessonDescription& lesson);

/// The surface of a solid body: "sphere" and "box" by rule, anything else from its model.
[[nodiscard]] Expected<TriangleMesh> load_solid_mesh(const Places& places,
                                                     const std::filesystem::path& lesson_folder,
                                                     const BodyDescription& body);

/// The same, made ready to be touched; bodies of one model share it.
[[nodiscard]] SolidLoader make_solid_loader(const Places& places,
                                            const std::filesystem::path& lesson_folder);

/// Reads the pictures of materials, which lie beside the lesson; `scale` is that of its hand.
[[nodiscard]] PictureLoader make_picture_loader(const std::filesystem::path& lesson_folder,
                                                double scale);

/// Changes when the lesson's files change: FNV-1a, 64 bits (Fowler, Noll, Vo), over their bytes, as hexadecimal digits.
[[nodiscard]] std::string version_of(const std::vector<std::filesystem::path>& files);

}  // namespace fulcrum::runtime
