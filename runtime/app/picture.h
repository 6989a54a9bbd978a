// Renderer and models for a lesson, in a window or without one.
#pragma once

#include "runtime/app/places.h"
#include "runtime/render/renderer.h"
#include "runtime/scene/description.h"
#include "runtime/scene/view.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Draws views with the models that lessons name; needs a current OpenGL context.
class Picture {
  public:
    [[nodiscard]] static Expected<std::unique_ptr<Picture>> create(const Places& places);

    /// Loads the models that a lesson names, unless the same files are loaded already. A model that cannot be used is drawn as a ball and
    /// gives one sentence here.
    [[nodiscard]] std::vector<std::string> load_models(const LessonDescription& lesson,
                                                       const std::filesystem::path& lesson_folder);
    /// The same for models that every lesson may show.
    [[nodiscard]] std::vector<std::string> load_models(const std::vector<std::string>& names,
                                                       const std::filesystem::path& lesson_folder);
    void draw(const View& view, int width, int height, const PictureQuality& quality = {}) {
        renderer_->draw(view, width, height, quality);
    }
    /// Where `draw` puts the cards of a view's list of lessons.
    [[nodiscard]] MenuLayout menu_layout(const View& view, int width, int height) const {
        return renderer_->menu_layout(view, width, height);
    }
    /// What could be clicked in the picture that was drawn last.
    [[nodiscard]] const ClickBoxes& click_boxes() const { return renderer_->click_boxes(); }

  private:
    explicit Picture(const Places& places) : places_(places) {}
    Places places_;
    std::unique_ptr<Renderer> renderer_;
    // Which file each model's name stands for, as it was when it was loaded. Lessons may use one name for different models.
    struct Loaded {
        std::filesystem::path file;
        std::filesystem::file_time_type written;
        friend bool operator==(const Loaded&, const Loaded&) = default;
    };
    std::map<std::string, Loaded> loaded_;
};

/// Draws one view without a display and keeps it as PNG.
[[nodiscard]] Expected<void> save_screenshot(const Places& places, const LessonDescription& lesson,
                                             const std::filesystem::path& lesson_folder,
                                             const View& view, const std::filesystem::path& file);

}  // namespace fulcrum::runtime
