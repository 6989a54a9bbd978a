#include "runtime/app/picture.h"

#include "runtime/effect/hand/show_tool.h"
#include "runtime/render/egl/offscreen.h"
#include "runtime/render/image.h"
#include "runtime/render/scene/tool_model.h"
#include "runtime/scene/gltf/gltf_model.h"
#include "runtime/scene/shape_models.h"

#include <system_error>

namespace fulcrum::runtime {
namespace {

constexpr int kScreenshotWidth_px = 1280;
constexpr int kScreenshotHeight_px = 720;

}  // namespace

Expected<std::unique_ptr<Picture>> Picture::create(const Places& places) {
    std::unique_ptr<Picture> picture(new Picture(places));
    auto renderer = Renderer::create();
    if (!renderer) {
        return tl::unexpected(renderer.error());
    }
    picture->renderer_ = std::move(*renderer);
    return picture;
}

std::vector<std::string> Picture::load_models(const LessonDescription& lesson,
                                              const std::filesystem::path& lesson_folder) {
    std::vector<std::string> names{std::string(kCursorModel), std::string(kHandModel)};
    std::vector<std::string> notices;
    if (lesson.hand.tool && !lesson.hand.tool->model.empty()) {
        names.push_back(lesson.hand.tool->model);
    } else if (!lesson.hand.cursor_model.empty()) {
        names.push_back(lesson.hand.cursor_model);
    } else if (lesson.hand.tool || has_shaped_cursor(lesson.hand)) {
        LoadedModel tool =
            make_tool_model(lesson.hand.tool ? lesson.hand.tool->shape : lesson.hand.cursor);
        tool.name = kToolModel;
        if (auto added = renderer_->add_model(tool); !added) {
            notices.push_back(to_sentence(added.error()));
        }
    }
    for (const HandDescription& hand : lesson.more_hands) {
        if (!hand.cursor_model.empty()) {
            names.push_back(hand.cursor_model);
            continue;
        }
        LoadedModel tool = make_second_tool_model(hand.cursor);
        tool.name = kSecondToolModel;
        if (auto added = renderer_->add_model(tool); !added) {
            notices.push_back(to_sentence(added.error()));
        }
    }
    if (lesson.bucket.present) {
        names.push_back(lesson.bucket.model);
    }
    for (const BodyDescription& body : lesson.bodies) {
        names.push_back(body.model);
        if (body.solid) {
            names.emplace_back(kClothModel);  // what can be felt may be covered
        }
    }
    for (std::string& notice : load_models(names, lesson_folder)) {
        notices.push_back(std::move(notice));
    }
    return notices;
}

std::vector<std::string> Picture::load_models(const std::vector<std::string>& names,
                                              const std::filesystem::path& lesson_folder) {
    std::vector<std::string> notices;
    for (const std::string& name : names) {
        const std::filesystem::path file = find_model(places_, lesson_folder, name);
        std::error_code error;
        const Loaded wanted{file, std::filesystem::last_write_time(file, error)};
        if (file.empty() || loaded_[name] == wanted) {
            continue;
        }
        loaded_[name] = wanted;
        auto model = load_gltf(file);
        if (!model) {
            notices.push_back(to_sentence(model.error()));
            continue;
        }
        model->name = name;
        if (auto added = renderer_->add_model(*model); !added) {
            notices.push_back(to_sentence(added.error()));
        }
    }
    return notices;
}

Expected<void> save_screenshot(const Places& places, const LessonDescription& lesson,
                               const std::filesystem::path& lesson_folder, const View& view,
                               const std::filesystem::path& file) {
    auto offscreen = Offscreen::create(kScreenshotWidth_px, kScreenshotHeight_px);
    if (!offscreen) {
        return tl::unexpected(offscreen.error());
    }
    auto picture = Picture::create(places);
    if (!picture) {
        return tl::unexpected(picture.error());
    }
    (void)(*picture)->load_models(lesson, lesson_folder);
    (*picture)->draw(view, kScreenshotWidth_px, kScreenshotHeight_px);
    return save_png(file, (*offscreen)->read_back());
}

}  // namespace fulcrum::runtime
