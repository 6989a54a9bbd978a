// Pictures are drawn without a display and judged by their numbers: what should change the picture
// does, where it should, and nothing breaks it.
#pragma once

#include "runtime/render/camera.h"
#include "runtime/render/colour.h"
#include "runtime/render/egl/offscreen.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/renderer.h"
#include "runtime/render/scene/light.h"
#include "runtime/render/scene/shapes.h"
#include "runtime/render/theme.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <epoxy/gl.h>
#include <limits>
#include <memory>
#include <string>

namespace fulcrum::runtime::test {

inline constexpr int kWidth = 640;
inline constexpr int kHeight = 360;
inline const double kNan = std::numeric_limits<double>::quiet_NaN();

/// A screen in memory and a renderer that knows a red ball and a green one of 0.1 m radius.
struct Studio {
    std::unique_ptr<Offscreen> screen;
    std::unique_ptr<Renderer> renderer;

    Image draw(const View& view, const PictureQuality& quality = {}) const {
        screen->make_current();
        renderer->draw(view, screen->width(), screen->height(), quality);
        return screen->read_back();
    }
};

inline LoadedModel ball(const std::string& name, std::array<float, 4> colour) {
    LoadedModel model = make_ball(0.1F, colour);
    model.name = name;
    return model;
}

/// Nothing, with the reason printed, where there is no OpenGL.
inline std::unique_ptr<Studio> open_studio(int width = kWidth, int height = kHeight) {
    auto studio = std::make_unique<Studio>();
    auto screen = Offscreen::create(width, height);
    if (!screen) {
        WARN("skipped: " << to_sentence(screen.error()));
        return nullptr;
    }
    studio->screen = std::move(*screen);
    auto renderer = Renderer::create();
    REQUIRE(renderer);
    studio->renderer = std::move(*renderer);
    REQUIRE(studio->renderer->add_model(ball("red", {0.8F, 0.02F, 0.02F, 1.0F})));
    REQUIRE(studio->renderer->add_model(ball("green", {0.02F, 0.6F, 0.05F, 1.0F})));
    return studio;
}

inline View nothing() {
    View view;
    view.tool_visible = false;
    return view;
}

inline ViewBody body(const std::string& model, const Vector3& position_W) {
    ViewBody result;
    result.model = model;
    result.pose_W.position = position_W;
    return result;
}

inline std::array<int, 3> pixel(const Image& image, int x, int y) {
    const std::size_t at = 4 * static_cast<std::size_t>(y * image.width + x);
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

/// The pixel where a point of the world is seen.
inline std::array<int, 3> pixel_at(const Image& image, const View& view, const Vector3& point_W) {
    const Camera camera(view.camera, image.width, image.height);
    const auto seen = camera.project(point_W);
    REQUIRE(seen);
    return pixel(image, static_cast<int>(seen->position_px.x()),
                 static_cast<int>(seen->position_px.y()));
}

inline int brightness(const std::array<int, 3>& p) {
    return p[0] + p[1] + p[2];
}

/// How many pixels of a box differ visibly; the whole picture when no box is given.
inline int changed(const Image& a, const Image& b, Box box = {0, 0, 1e6F, 1e6F}) {
    REQUIRE(a.rgba.size() == b.rgba.size());
    constexpr int kVisible = 12;
    int count = 0;
    for (int y = std::max(0, static_cast<int>(box.y));
         y < std::min<int>(a.height, static_cast<int>(box.bottom())); ++y) {
        for (int x = std::max(0, static_cast<int>(box.x));
             x < std::min<int>(a.width, static_cast<int>(box.right())); ++x) {
            const auto p = pixel(a, x, y);
            const auto q = pixel(b, x, y);
            const int difference =
                std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]);
            count += difference > kVisible ? 1 : 0;
        }
    }
    return count;
}

inline PanelLayout panels_of(const View& view) {
    Font font(RendererSettings{}.font_folder);
    return lay_out_panels(view, font, Measure(kWidth, kHeight));
}

inline bool has_words() {
    return Font(RendererSettings{}.font_folder).notice().find("no words") == std::string::npos;
}

}  // namespace fulcrum::runtime::test
