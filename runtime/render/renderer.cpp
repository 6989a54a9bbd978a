#include "runtime/render/renderer.h"

#include "runtime/render/camera.h"
#include "runtime/render/gl/frame_target.h"
#include "runtime/render/overlay/bursts.h"
#include "runtime/render/overlay/draw_panels.h"
#include "runtime/render/overlay/find_measure.h"
#include "runtime/render/overlay/labels.h"
#include "runtime/render/overlay/menu.h"
#include "runtime/render/overlay/overlay_pass.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/scene/arrow.h"
#include "runtime/render/scene/kite_models.h"
#include "runtime/render/scene/scene_content.h"
#include "runtime/render/scene/scene_painter.h"
#include "runtime/render/text/font.h"

#include <algorithm>
#include <cmath>
#include <epoxy/gl.h>
#include <initializer_list>
#include <optional>
#include <utility>

namespace fulcrum::runtime {

namespace {

constexpr int kLeastGl = 33;

Expected<void> check(const RendererSettings& settings) {
    if (settings.samples < 1 || settings.samples > 16) {
        return fail("the samples a pixel are " + std::to_string(settings.samples),
                    "RendererSettings::samples", "choose 1 to 16");
    }
    if (settings.shadow_map_size < 64 || settings.shadow_map_size > 4096) {
        return fail("the shadow map's side is " + std::to_string(settings.shadow_map_size),
                    "RendererSettings::shadow_map_size", "choose 64 to 4096");
    }
    if (epoxy_gl_version() < kLeastGl) {
        return fail("OpenGL 3.3 is needed and not there", {},
                    "update the graphics driver or install libgl1-mesa-dri");
    }
    return {};
}

constexpr double kLeastPicture = 0.25;

int shrink(int side_px, double scale) {
    return std::max(1, static_cast<int>(std::lround(side_px * std::max(scale, kLeastPicture))));
}

/// Whatever others left switched on goes off.
void start_from_known_state() {
    for (const GLenum on :
         std::initializer_list<GLenum>{GL_SCISSOR_TEST, GL_CULL_FACE, GL_STENCIL_TEST, GL_BLEND,
                                       GL_POLYGON_OFFSET_FILL, GL_DEPTH_CLAMP}) {
        glDisable(on);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glBlendEquation(GL_FUNC_ADD);
}

}  // namespace

struct Renderer::Parts {
    Parts(const RendererSettings& given, ScenePainter scene_painter, OverlayPass overlay_pass)
        : settings(given),
          painter(std::move(scene_painter)),
          overlay(std::move(overlay_pass)),
          font(given.font_folder),
          list(font) {
        if (!font.notice().empty()) {
            notices.push_back(font.notice());
        }
    }

    RendererSettings settings;
    ScenePainter painter;
    OverlayPass overlay;
    gl::FrameTarget target;
    gl::FrameTarget coarse;  ///< of a scene that is drawn smaller
    Font font;
    DrawList list;
    MovedPanels moved;
    std::vector<Box> labelled;  // of the last frame
    ClickBoxes click_boxes;     ///< of the view drawn last
    std::vector<std::string> notices;
    std::optional<KiteSettings> kite;  ///< as it was drawn last

    /// A kite looks as it is built; made again when it is built anew.
    void make_kite_ready(const View& view) {
        if (!view.kite_design || view.kite_design == kite) {
            return;
        }
        kite = view.kite_design;
        for (const LoadedModel& model : make_kite_models(*kite)) {
            if (auto added = painter.add_model(model); !added) {
                notices.push_back(to_sentence(added.error()));
            }
        }
    }

    /// Answers to choose from lie over the scene, each with a picture of its own.
    void draw_choices(const View& view, const PanelLayout& panels, const Measure& measure,
                      int width, int height) {
        if (panels.choices.empty()) {
            return;
        }
        draw_overlay([&] { draw_choice_papers(view, panels.choices, measure, list); }, width,
                     height);
        glClear(GL_DEPTH_BUFFER_BIT);
        for (std::size_t i = 0; i < panels.choices.size(); ++i) {
            if (!view.choices[i].picture.empty()) {
                painter.draw_icon(view.choices[i].picture, view.choices[i].look,
                                  choice_picture(panels.choices[i], measure), width, height);
            }
        }
    }

    /// Into `coarse` or `target`; into that in any case where there are choices, which lie over it as fine as words do.
    std::vector<SceneLabel> draw_scene(const View& view, const PanelLayout& panels,
                                       const Measure& measure, const Camera& camera,
                                       bool is_coarse) {
        const int width = static_cast<int>(measure.width_px);
        const int height = static_cast<int>(measure.height_px);
        auto labels = painter.draw_scene(view, camera, is_coarse ? coarse : target, width, height);
        labelled = labelled_boxes(labels);
        if (is_coarse && !panels.choices.empty()) {
            coarse.resolve_to(target);
            glViewport(0, 0, width, height);
        }
        draw_choices(view, panels, measure, width, height);
        return labels;
    }

    /// The list of lessons, but for its words.
    void draw_menu(const View& view, const MenuLayout& menu, const Measure& measure,
                   const Camera& camera, int width, int height) {
        painter.draw_wall(camera, target);
        draw_overlay([&] { draw_menu_papers(menu, measure, list); }, width, height);
        for (const MenuCard& card : menu.cards) {
            const ViewMenuItem& item = view.menu[card.index];
            for (const auto& [icon, box] :
                 {std::pair(&item.icon, card.icon), {&item.second_icon, card.second_icon}}) {
                if (!icon->empty()) {
                    painter.draw_icon(*icon, "", box, width, height);
                }
            }
        }
    }

    /// Composes flat shapes and words; once more when the letters' atlas ran full meanwhile.
    template <class Compose>
    void draw_overlay(const Compose& compose, int width, int height) {
        list.clear();
        compose();
        if (font.is_full()) {
            font.clear();
            list.clear();
            compose();
        }
        overlay.draw(list, font, width, height);
    }
};

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::~Renderer() = default;

Expected<std::unique_ptr<Renderer>> Renderer::create(const RendererSettings& settings) {
    if (auto fine = check(settings); !fine) {
        return tl::make_unexpected(fine.error());
    }
    // Making passes binds framebuffers of theirs; the caller's is bound again afterwards.
    GLint screen = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &screen);
    auto painter = ScenePainter::create(settings.shadow_map_size);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(screen));
    if (!painter) {
        return tl::make_unexpected(painter.error());
    }
    auto overlay = OverlayPass::create();
    if (!overlay) {
        return tl::make_unexpected(overlay.error());
    }
    return std::unique_ptr<Renderer>(
        new Renderer(std::make_unique<Parts>(settings, std::move(*painter), std::move(*overlay))));
}

Expected<void> Renderer::add_model(const LoadedModel& model) {
    return parts_->painter.add_model(model);
}

bool Renderer::has_model(const std::string& name) const {
    return parts_->painter.has_model(name);
}

const std::vector<std::string>& Renderer::notices() const {
    return parts_->notices;
}

MenuLayout Renderer::menu_layout(const View& view, int width, int height) const {
    const Measure measure = find_measure(view, parts_->font, width, height);
    return lay_out_menu(view, measure, lay_out_panels(view, parts_->font, measure).papers());
}

const ClickBoxes& Renderer::click_boxes() const {
    return parts_->click_boxes;
}

void Renderer::draw(const View& view, int width, int height, const PictureQuality& quality) {
    if (width <= 0 || height <= 0) {
        return;
    }
    GLint screen = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &screen);
    start_from_known_state();
    const bool is_coarse = quality.scale < 1.0 && view.menu.empty();
    const int samples = is_coarse ? 1 : std::clamp(quality.samples, 1, parts_->settings.samples);
    if (!parts_->target.resize(width, height, samples) ||
        (is_coarse &&
         !parts_->coarse.resize(shrink(width, quality.scale), shrink(height, quality.scale), 1))) {
        glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(screen));
        return;
    }
    const gl::FrameTarget* drawn = &parts_->target;

    parts_->make_kite_ready(view);
    // Words decide how much room is left for cards and labels.
    const Measure measure = find_measure(view, parts_->font, width, height);
    parts_->list.colour_by(view.look.high_contrast ? theme::kHighContrast : theme::kUsual);
    Camera camera(view.camera, width, height);
    camera.draw_dots(is_coarse ? quality.scale : 1.0);
    const Box hand = view.menu.empty() ? parts_->painter.hand_seen(view, camera) : Box{};
    const PanelLayout panels =
        lay_out_panels(view, parts_->font, measure, hand, parts_->moved, parts_->labelled);
    parts_->moved = panels.moved;
    parts_->click_boxes = {panels.input.box, {}, panels.buttons};
    for (const Panel& choice : panels.choices) {
        parts_->click_boxes.choices.push_back(choice.box);
    }
    const MenuLayout menu = lay_out_menu(view, measure, panels.papers());
    std::vector<SceneLabel> labels;

    if (view.menu.empty()) {
        labels = parts_->draw_scene(view, panels, measure, camera, is_coarse);
        drawn = is_coarse && panels.choices.empty() ? &parts_->coarse : drawn;
    } else {
        parts_->draw_menu(view, menu, measure, camera, width, height);
    }

    drawn->resolve_to(static_cast<GLuint>(screen), width, height);
    glViewport(0, 0, width, height);
    const auto words = [&] {
        draw_bursts(view.bursts, camera, measure, parts_->list);
        draw_labels(place_labels(labels, panels.shown(), parts_->font, measure, hand), measure,
                    parts_->list);
        if (!view.menu.empty()) {
            draw_menu_words(view, menu, measure, parts_->list);
        }
        draw_panels(view, panels, measure, parts_->list);
    };
    parts_->draw_overlay(words, width, height);
    glBindVertexArray(0);
    glUseProgram(0);
}

}  // namespace fulcrum::runtime
