// Draws a View. Needs a current OpenGL 3.3 core context and a framebuffer; knows neither window nor
// lesson.
//
//   shadow map -> lit scene (4 samples a pixel, linear light) -> resolve to sRGB -> words and
//   panels on top
//
// The picture depends on View and quality alone: nothing moves by itself, the same View gives the same
// picture.
// Thread: the one that holds the context. Cost: one pass over each model's triangles for the shadow
// and one for the picture; memory for 4 samples of colour and depth a pixel.
#pragma once

#include "haptics/base/error.h"
#include "runtime/render/overlay/menu.h"
#include "runtime/render/picture_quality.h"
#include "runtime/scene/model.h"
#include "runtime/scene/view.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Fixed when the renderer is made.
struct RendererSettings {
    /// Where Andika-Regular.ttf and Andika-Bold.ttf lie.
    std::filesystem::path font_folder{"/usr/share/fonts/truetype/andika"};
    int samples = 4;             ///< a pixel at most, 1 to 16; fewer when the driver has fewer
    int shadow_map_size = 1024;  ///< texels a side, 64 to 4096
};

/// Everything drawn on a screen.
/// Without width where it is not shown.
struct ClickBoxes {
    Box input;                 ///< the line to type in
    std::vector<Box> choices;  ///< as the view's, so are the others
    std::vector<Box> buttons;
};

class Renderer {
  public:
    /// Makes shaders, buffers and fonts in the current context. An error when there is no OpenGL
    /// 3.3 core context or a setting is out of range. A missing font is no error: see `notices`.
    [[nodiscard]] static Expected<std::unique_ptr<Renderer>> create(
        const RendererSettings& settings = {});

    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    /// Needs the context to be current still.
    ~Renderer();

    /// Takes in a model under its name, in place of an older one of that name. Lengths, indices and
    /// numbers are checked; an error changes nothing.
    [[nodiscard]] Expected<void> add_model(const LoadedModel& model);

    /// Whether a model of this name was added. A body whose model was not is drawn as a plain ball.
    [[nodiscard]] bool has_model(const std::string& name) const;

    /// Draws the whole frame into the framebuffer that is bound for drawing, from its lower left
    /// corner, `width` x `height` pixels; does nothing when a side is not positive. Things with a
    /// number that is not finite are left out.
    void draw(const View& view, int width, int height, const PictureQuality& quality = {});

    /// Where `draw` puts the cards of a view's list of lessons; for what a pointer means.
    [[nodiscard]] MenuLayout menu_layout(const View& view, int width, int height) const;

    /// What could be clicked in the view that was drawn last.
    [[nodiscard]] const ClickBoxes& click_boxes() const;

    /// What did not go as wished, one sentence each, e.g. a font that is not installed.
    [[nodiscard]] const std::vector<std::string>& notices() const;

  private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace fulcrum::runtime
