#include "runtime/app/lesson_parts.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/screen_trouble.h"
#include "runtime/lua/api/binding_table.h"
#include "runtime/scene/gltf/collision_from_model.h"
#include "runtime/scene/gltf/gltf_model.h"
#include "runtime/scene/picture/felt_pictures.h"
#include "runtime/scene/shape_models.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

namespace fulcrum::runtime {
namespace fs = std::filesystem;

namespace {

// The names of models, the lesson's own too, that a misspelt one most likely means: "\"apple\" or \"maple\"".
std::string near_models(const Places& places, const fs::path& lesson_folder,
                        const std::string& model) {
    constexpr int kMost = 3;
    std::vector<std::string> known{std::string(kSphereModel), std::string(kBoxModel),
                                   std::string(kOrbitModel)};
    known.insert(known.end(), kPlanetModels.begin(), kPlanetModels.end());
    for (const fs::path& folder : {lesson_folder, places.models}) {
        for (const fs::path& file : entries_of(folder)) {
            if (file.extension() == ".glb" || file.extension() == ".gltf") {
                known.push_back(file.stem().string());
            }
        }
    }
    std::string near;
    for (int i = 0; i < kMost; ++i) {
        // After the most likely one only those that differ by a letter.
        const std::string next =
            near.empty() ? nearest_word(model, known) : nearest_word(model, known, 1);
        if (next.empty()) {
            break;
        }
        near += (near.empty() ? "\"" : " or \"") + next + '"';
        std::erase(known, next);
    }
    return near;
}

tl::unexpected<Error> no_model(const Places& places, const fs::path& lesson_folder,
                               const NamedModel& model) {
    const std::string near = near_models(places, lesson_folder, model.name);
    const std::string put = "put " + model.name + ".glb beside the lesson";
    return fail("there is no model \"" + model.name + "\" for " + model.owner,
                "lesson.lua:" + std::to_string(model.line),
                !near.empty()        ? "did you mean " + near + "? If not, " + put
                : model.may_be_shape ? put + ", or use sphere or box"
                                     : put);
}

}  // namespace

std::vector<NamedModel> models_of(const LessonDescription& lesson) {
    std::vector<NamedModel> models;
    const auto add = [&](const std::string& name, const std::string& owner, SourceLine line,
                         bool may_be_shape = true) {
        if (!name.empty()) {
            models.push_back({name, owner, line, may_be_shape});
        }
    };
    for (const BodyDescription& body : lesson.bodies) {
        for (const std::string& model : {body.model, body.felt_model, body.simulated_model}) {
            add(model, body.name, body.line);
        }
    }
    if (lesson.hand.tool) {
        add(lesson.hand.tool->model, "the tool", lesson.hand.line);
    }
    add(lesson.hand.cursor_model, "the cursor", lesson.hand.line, false);
    for (const HandDescription& hand : lesson.more_hands) {
        add(hand.cursor_model, "the cursor", hand.line, false);
    }
    if (lesson.bucket.present) {
        add(lesson.bucket.model, "the bucket", lesson.bucket.line);
    }
    return models;
}

Expected<void> check_models(const Places& places, const fs::path& lesson_folder,
                            const LessonDescription& lesson) {
    for (const NamedModel& model : models_of(lesson)) {
        if (!is_shape_model(model.name) && find_model(places, lesson_folder, model.name).empty()) {
            return no_model(places, lesson_folder, model);
        }
    }
    return {};
}

namespace {

// Whether a Lua file says where this hand goes.
bool follows_script(const HandChoice& choice, PlayedBy by) {
    const bool at_desk = choice.hand == HandKind::mouse || choice.hand == HandKind::keys;
    return choice.hand == HandKind::scripted || (by != PlayedBy::arm && at_desk);
}

// Of hands that were asked for.
LessonFiles files_of(const Places& places, const RunRequest& request) {
    LessonFiles files;
    files.folder = request.folder;
    files.library = places.scripts_lib;
    if (follows_script(request, request.by)) {
        files.hand = request.hand_file;
    }
    if (!request.more_hands.empty() && follows_script(request.more_hands[0], request.by)) {
        files.second_hand = request.more_hands[0].hand_file;
    }
    return files;
}

// Those of the lesson's own test, where nobody named others.
Expected<void> add_own_hands(const LessonTestDescription& test, const RunRequest& request,
                             LessonFiles& files) {
    const auto add = [&](const HandChoice& choice, const std::string& own,
                         std::filesystem::path& file) -> Expected<void> {
        if (own.empty() || !file.empty() || !follows_script(choice, request.by)) {
            return {};
        }
        file = request.folder / own;
        if (std::error_code error; !fs::exists(file, error)) {
            return fail("there is no " + own + " beside the lesson",
                        "lesson.lua:" + std::to_string(test.line),
                        "write the simulated hand, or leave hand = … away");
        }
        return {};
    };
    return add(request, test.hand, files.hand).and_then([&]() -> Expected<void> {
        return request.more_hands.empty()
                   ? Expected<void>{}
                   : add(request.more_hands[0], test.second_hand, files.second_hand);
    });
}

}  // namespace

std::function<bool(double)> patience(std::optional<double> most_s) {
    constexpr double kTold_s = 2.0;
    constexpr double kWhenEnded_s = 0.5;  // an answer under way still comes
    return [most_s, told = false](double waited_s) mutable {
        if (!told && waited_s > kTold_s) {
            told = true;
            std::fprintf(stderr, "This computer is busy: the lesson has hardly run for %.0f s.\n",
                         waited_s);
        }
        return waited_s < (interrupted() ? kWhenEnded_s : most_s.value_or(HUGE_VAL));
    };
}

Expected<StartedLesson> start_lesson(const Places& places, RunRequest& request) {
    // Whether it has a second hand is not known yet.
    LessonFiles asked = files_of(places, request);
    asked.second_hand.clear();
    LessonProcessOptions options;
    options.seed = request.seed;
    options.waits_on =
        patience(request.hands_there == HandsThere::desk ? std::optional(kLongestWindowWait_s)
                                                         : std::nullopt);
    auto process = LessonProcess::start(asked, options);
    if (!process) {
        return tl::unexpected(process.error());
    }
    auto notices = settle_hands((*process)->description(), request);
    if (!notices) {
        return tl::unexpected(notices.error());
    }
    LessonFiles files = files_of(places, request);
    if (const auto& tests = (*process)->description().tests; request.own_test && !tests.empty()) {
        const LessonTestDescription test = tests.front();
        if (auto added = add_own_hands(test, request, files); !added) {
            return tl::unexpected(added.error());
        }
    }
    // The lesson says only once it is loaded which hands it wants, so it may be started a second time, with those.
    if (files.hand != asked.hand || files.second_hand != asked.second_hand) {
        process->reset();
        process = LessonProcess::start(files, options);
        if (!process) {
            return tl::unexpected(process.error());
        }
    }
    return StartedLesson{std::move(*process), std::move(*notices)};
}

Expected<TriangleMesh> load_solid_mesh(const Places& places, const fs::path& lesson_folder,
                                       const BodyDescription& body) {
    if (is_ball_model(body.model)) {
        return make_sphere(body.radius_m, kSphereModelFrequency);
    }
    if (!body.boxes.empty()) {
        return make_boxes(body.boxes);
    }
    if (body.model == kBoxModel) {
        return make_box(box_size_m(body));
    }
    const fs::path file = find_model(places, lesson_folder, body.model);
    if (file.empty()) {
        return no_model(places, lesson_folder, {body.model, body.name, body.line});
    }
    const auto model = load_gltf(file);
    if (!model) {
        return tl::unexpected(model.error());
    }
    return collision_from_model(*model, file.string());
}

// A model looks the same whatever the body's radius; a ball or a box is as large as its radius says.
SolidLoader make_solid_loader(const Places& places, const fs::path& lesson_folder) {
    using Key = std::tuple<std::string, double, double, double>;
    const auto made = std::make_shared<std::map<Key, std::shared_ptr<const CollisionMesh>>>();
    return [places, lesson_folder,
            made](const BodyDescription& body) -> Expected<std::shared_ptr<const CollisionMesh>> {
        const auto load = [&] {
            return load_solid_mesh(places, lesson_folder, body)
                .and_then([](const TriangleMesh& mesh) { return CollisionMesh::create(mesh); });
        };
        if (!body.boxes.empty()) {
            return load();  // its own, of no other body
        }
        const Vector3 size_m =
            is_shape_model(body.model) ? box_size_m(body) : Vector3(Vector3::Zero());
        const Key key{body.model, size_m.x(), size_m.y(), size_m.z()};
        if (const auto known = made->find(key); known != made->end()) {
            return known->second;
        }
        return load().map([&](const std::shared_ptr<const CollisionMesh>& mesh) {
            return made->emplace(key, mesh).first->second;
        });
    };
}

PictureLoader make_picture_loader(const fs::path& lesson_folder, double scale) {
    const auto pictures = std::make_shared<FeltPictures>(lesson_folder, scale);
    return [pictures](const MaterialDescription& material, double width_m) {
        return pictures->load(material.image, width_m).map_error([&](const Error& error) {
            const std::string file = error.where.empty() ? "" : error.where + ": ";
            return Error{file + error.message, "lesson.lua:" + std::to_string(material.line),
                         error.what_to_do};
        });
    };
}

std::string version_of(const std::vector<fs::path>& files) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const fs::path& path : files) {
        std::ifstream file(path, std::ios::binary);
        std::for_each(std::istreambuf_iterator<char>(file), {}, [&](char c) {
            hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
        });
    }
    std::ostringstream text;
    text << std::hex << hash;
    return text.str();
}

}  // namespace fulcrum::runtime
