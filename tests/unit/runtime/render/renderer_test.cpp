// Pictures are drawn without a display and judged by their numbers: what should change the picture
// does, where it should, and nothing breaks it.
#include "runtime/render/renderer.h"

#include "runtime/render/camera.h"
#include "runtime/render/colour.h"
#include "runtime/render/egl/offscreen.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/scene/light.h"
#include "runtime/render/scene/shapes.h"
#include "runtime/render/theme.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <epoxy/gl.h>
#include <limits>
#include <memory>
#include <string>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 360;
const double kNan = std::numeric_limits<double>::quiet_NaN();

/// A screen in memory and a renderer that knows a red ball and a green one of 0.1 m radius.
struct Studio {
    std::unique_ptr<Offscreen> screen;
    std::unique_ptr<Renderer> renderer;

    Image draw(const View& view) const {
        screen->make_current();
        renderer->draw(view, screen->width(), screen->height());
        return screen->read_back();
    }
};

LoadedModel ball(const std::string& name, std::array<float, 4> colour) {
    LoadedModel model = make_ball(0.1F, colour);
    model.name = name;
    return model;
}

/// Nothing, with the reason printed, where there is no OpenGL.
std::unique_ptr<Studio> open_studio(int width = kWidth, int height = kHeight) {
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

View nothing() {
    View view;
    view.tool_visible = false;
    return view;
}

ViewBody body(const std::string& model, const Vector3& position_W) {
    ViewBody result;
    result.model = model;
    result.pose_W.position = position_W;
    return result;
}

std::array<int, 3> pixel(const Image& image, int x, int y) {
    const std::size_t at = 4 * static_cast<std::size_t>(y * image.width + x);
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

/// The pixel where a point of the world is seen.
std::array<int, 3> pixel_at(const Image& image, const View& view, const Vector3& point_W) {
    const Camera camera(view.camera, image.width, image.height);
    const auto seen = camera.project(point_W);
    REQUIRE(seen);
    return pixel(image, static_cast<int>(seen->position_px.x()),
                 static_cast<int>(seen->position_px.y()));
}

int brightness(const std::array<int, 3>& p) {
    return p[0] + p[1] + p[2];
}

/// How many pixels of a box differ visibly; the whole picture when no box is given.
int changed(const Image& a, const Image& b, Box box = {0, 0, 1e6F, 1e6F}) {
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

PanelLayout panels_of(const View& view) {
    Font font(RendererSettings{}.font_folder);
    return lay_out_panels(view, font, Measure(kWidth, kHeight));
}

bool has_words() {
    return Font(RendererSettings{}.font_folder).notice().find("no words") == std::string::npos;
}

}  // namespace

TEST_CASE("picture: an empty view shows sky above and floor below, and no OpenGL error") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    const Image image = studio->draw(nothing());
    const auto top = pixel(image, 100, 2);
    const auto bottom = pixel(image, 100, kHeight - 3);
    CHECK(brightness(top) > 400);
    CHECK(brightness(bottom) > 300);
    CHECK(top != bottom);
    CHECK(glGetError() == GL_NO_ERROR);
    std::size_t opaque = 0;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        opaque += image.rgba[i] == 255 ? 1 : 0;
    }
    CHECK(opaque == image.rgba.size() / 4);
}

TEST_CASE("picture: the same view gives the same picture, whatever its time") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.bodies = {body("red", {0.0, 0.4, 0.0})};
    view.caption = "Hello";
    const Image first = studio->draw(view);
    view.time_s = 123.4;
    CHECK(studio->draw(view).rgba == first.rgba);
}

TEST_CASE("picture: a body is seen where it is, in its colour, nearer ones before others") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.bodies = {body("red", {0.0, 0.4, 0.0})};
    const auto red = pixel_at(studio->draw(view), view, {0.0, 0.4, 0.1});
    CHECK(red[0] > 150);
    CHECK(red[0] > 2 * red[1]);
    view.bodies.push_back(body("green", {0.0, 0.4, 0.5}));
    const auto green = pixel_at(studio->draw(view), view, {0.0, 0.4, 0.6});
    CHECK(green[1] > green[0]);
    std::reverse(view.bodies.begin(), view.bodies.end());
    CHECK(pixel_at(studio->draw(view), view, {0.0, 0.4, 0.6}) == green);
}

TEST_CASE("picture: squash makes a body flatter and wider") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.bodies = {body("red", {0.0, 0.45, 0.0})};
    const Image round = studio->draw(view);
    view.bodies[0].scale = Vector3(1.4, 0.5, 1.4);
    const Image flat = studio->draw(view);
    const Vector3 side(0.125, 0.45, 0.0);
    const Vector3 top(0.0, 0.53, 0.0);
    CHECK(pixel_at(flat, view, side)[0] > 2 * pixel_at(flat, view, side)[1]);
    CHECK(pixel_at(round, view, side)[0] < 2 * pixel_at(round, view, side)[1]);
    CHECK(pixel_at(round, view, top)[0] > 2 * pixel_at(round, view, top)[1]);
    CHECK(pixel_at(flat, view, top)[0] < 2 * pixel_at(flat, view, top)[1]);
}

TEST_CASE("picture: shadows darken the floor below a body, and only there") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.camera.eye_W = Vector3(0.0, 1.2, 1.2);
    const Image bare = studio->draw(view);
    view.bodies = {body("red", {0.0, 0.5, -0.2})};
    const Image shaded = studio->draw(view);
    const Vector3 below(0.0, 0.0, -0.2);
    CHECK(brightness(pixel_at(shaded, view, below)) <
          brightness(pixel_at(bare, view, below)) * 85 / 100);
    const Vector3 away(0.6, 0.0, 0.1);
    CHECK(pixel_at(shaded, view, away) == pixel_at(bare, view, away));
}

TEST_CASE("picture: the shadow of a body high above lies where the lamp throws it") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.camera.eye_W = Vector3(0.0, 1.2, 1.2);
    const Image bare = studio->draw(view);
    view.bodies = {body("red", {0.0, 3.0, 0.0})};
    const Image image = studio->draw(view);
    const Light light =
        light_for(Camera(view.camera, kWidth, kHeight), 0.0, RendererSettings{}.shadow_map_size);
    const Vector3 to_lamp = light.to_lamp.cast<double>();
    const Vector3 thrown = view.bodies[0].pose_W.position - to_lamp * (3.0 / to_lamp.y());
    const Vector3 edge = thrown * (1.0 + 0.05 / thrown.norm());
    CHECK(brightness(pixel_at(image, view, edge)) <
          brightness(pixel_at(bare, view, edge)) * 85 / 100);
}

TEST_CASE("picture: a body shades the one below it, and no body shades itself in stripes") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.camera.eye_W = Vector3(0.0, 0.9, 1.5);
    view.bodies = {body("red", {0.0, 0.1, 0.0})};
    const Image alone = studio->draw(view);
    const Vector3 top(0.0, 0.195, 0.03);
    view.bodies.push_back(body("green", {0.0, 0.9, 0.0}));
    CHECK(brightness(pixel_at(studio->draw(view), view, top)) <
          brightness(pixel_at(alone, view, top)) - 30);
    // Along the lit top of the ball light changes gently from pixel to pixel.
    const Camera camera(view.camera, kWidth, kHeight);
    const auto middle = camera.project(Vector3(0.0, 0.15, 0.09));
    const int y = static_cast<int>(middle->position_px.y());
    const int x = static_cast<int>(middle->position_px.x());
    for (int dx = -12; dx < 12; ++dx) {
        const int step =
            std::abs(brightness(pixel(alone, x + dx, y)) - brightness(pixel(alone, x + dx + 1, y)));
        CHECK(step < 40);
    }
}

TEST_CASE("picture: the mark on the floor shows where a falling body will land") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.camera.eye_W = Vector3(0.0, 1.2, 1.2);
    const Image bare = studio->draw(view);
    view.bodies = {body("red", {0.3, 0.6, -0.3})};
    const Image image = studio->draw(view);
    // The ring is a little larger than the ball; look for its dark line beside the shadow.
    int darkest = 1000;
    for (double r = 0.09; r < 0.15; r += 0.002) {
        const Vector3 place(0.3 + r, 0.0, -0.3);
        darkest = std::min(darkest, brightness(pixel_at(image, view, place)) -
                                        brightness(pixel_at(bare, view, place)));
    }
    CHECK(darkest < -60);
}

TEST_CASE("picture: a highlight draws a line around a body") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.bodies = {body("green", {0.0, 0.45, 0.0})};
    const Image plain = studio->draw(view);
    view.bodies[0].highlight = 1.0;
    const Image outlined = studio->draw(view);
    CHECK(changed(plain, outlined) > 150);
    CHECK(pixel_at(plain, view, {0.0, 0.45, 0.1}) == pixel_at(outlined, view, {0.0, 0.45, 0.1}));
    view.bodies[0].highlight = kNan;
    CHECK(studio->draw(view).rgba == plain.rgba);
}

TEST_CASE("picture: the force is seen through everything before it") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.bodies = {body("green", {0.0, 0.4, 0.3})};
    const Image without = studio->draw(view);
    view.force = {true, {0.0, 0.5, 0.0}, {0.0, -4.0, 0.0}, ""};
    const Image with = studio->draw(view);
    const auto arrow = pixel_at(with, view, {0.0, 0.45, 0.0});
    CHECK(arrow[0] > 150);
    CHECK(arrow[0] > arrow[2] + 80);
    CHECK(changed(without, with) > 200);
    view.force.text = "4 N";
    if (has_words()) {
        CHECK(changed(with, studio->draw(view)) > 300);
    }
}

TEST_CASE("picture: the ghost is seen through") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view;
    view.tool = body("red", {-0.3, 0.4, 0.0});
    const Image without = studio->draw(view);
    view.ghost_visible = true;
    view.ghost_pose_W.position = Vector3(0.2, 0.4, 0.0);
    const Image with = studio->draw(view);
    const auto ghost = pixel_at(with, view, {0.2, 0.4, 0.1});
    const auto behind = pixel_at(without, view, {0.2, 0.4, 0.1});
    CHECK(ghost != behind);
    // Half-way between the ghost's colour and what is behind it.
    CHECK(std::abs(ghost[0] - behind[0]) <
          std::abs(static_cast<int>(255.0F * theme::kGhost.r) - behind[0]));
    CHECK(pixel_at(with, view, {-0.3, 0.4, 0.1}) == pixel_at(without, view, {-0.3, 0.4, 0.1}));
}

TEST_CASE("picture: every panel changes its own place") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    const View plain = nothing();
    const Image before = studio->draw(plain);
    const auto check = [&](const View& view, const Box& box) {
        const Image after = studio->draw(view);
        const int inside = changed(before, after, box);
        CHECK(inside > static_cast<int>(0.5F * box.width * box.height));
        // Beyond its shadow nothing else changes.
        CHECK(changed(before, after) <= changed(before, after, box.grown(20.0F)));
    };
    View caption = plain;
    caption.caption = "Catch the fruit.";
    check(caption, panels_of(caption).caption.box);
    View feedback = plain;
    feedback.feedback = "A melon is *the heaviest*.";
    check(feedback, panels_of(feedback).feedback.box);
    View input = plain;
    input.input_visible = true;
    check(input, panels_of(input).input.box);
    View level = plain;
    level.level = 2;
    level.level_title = "Three fruits";
    check(level, panels_of(level).level.box);
    View stars = plain;
    stars.stars = 2;
    check(stars, panels_of(stars).stars.box);
}

TEST_CASE("picture: a banner lies over a scene that is still seen") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.bodies = {body("red", {0.0, 0.3, 0.0})};
    const Image before = studio->draw(view);
    view.banner = "lesson.lua:3: something is wrong.";
    view.banner_is_error = true;
    const Image error = studio->draw(view);
    CHECK(pixel_at(error, view, {0.0, 0.3, 0.1}) == pixel_at(before, view, {0.0, 0.3, 0.1}));
    view.banner_is_error = false;
    const Image notice = studio->draw(view);
    CHECK(changed(error, notice, panels_of(view).banner.box) > 500);
}

TEST_CASE("picture: score, stars and typed words are told apart") {
    const auto studio = open_studio();
    if (!studio || !has_words()) {
        return;
    }
    View view = nothing();
    view.input_visible = true;
    view.stars = 1;
    const Image before = studio->draw(view);
    View other = view;
    other.score = 8;
    CHECK(changed(before, studio->draw(other)) > 20);
    other = view;
    other.stars = 2;
    CHECK(changed(before, studio->draw(other)) > 300);
    other = view;
    other.input = "the";
    CHECK(changed(before, studio->draw(other)) > 60);
}

TEST_CASE("picture: emphasis changes words, and words are dark on light") {
    const auto studio = open_studio();
    if (!studio || !has_words()) {
        return;
    }
    View view = nothing();
    view.feedback = "the heaviest";
    const Image plain = studio->draw(view);
    const Box box = panels_of(view).feedback.box;
    int darkest = 765;
    for (int x = static_cast<int>(box.x) + 40; x < static_cast<int>(box.right()); ++x) {
        darkest = std::min(darkest, brightness(pixel(plain, x, static_cast<int>(box.middle_y()))));
    }
    CHECK(darkest < 200);
    view.feedback = "*the heaviest*";
    CHECK(changed(plain, studio->draw(view)) > 100);
}

TEST_CASE("picture: the menu shows cards instead of the scene, and which one is chosen") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.bodies = {body("red", {0.0, 0.4, 0.0})};
    view.menu = {{"One", "A1", "red"}, {"Two", "A2", "green"}, {"Three", "B1", "nobody"}};
    const Image first = studio->draw(view);
    view.menu_selected = 2;
    const Image last = studio->draw(view);
    CHECK(changed(first, last) > 1000);
    view.bodies.clear();
    CHECK(studio->draw(view).rgba == last.rgba);
    view.menu_selected = 1000;
    CHECK(studio->draw(view).rgba == last.rgba);
    // The icon of the first card is a red ball.
    int red = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth / 2; ++x) {
            const auto p = pixel(last, x, y);
            red += p[0] > 120 && p[0] > 2 * p[1] ? 1 : 0;
        }
    }
    CHECK(red > 500);
}

TEST_CASE("picture: numbers that are not finite, huge or upside down break nothing") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    const Image empty = studio->draw(view);
    view.bodies = {body("red", {kNan, 0.0, 0.0}), body("red", {0.0, 1e300, 0.0})};
    view.bodies.push_back(body("red", {0.0, 0.4, 0.0}));
    view.bodies.back().scale = Vector3(0.0, 1.0, kNan);
    view.bodies.push_back(body("red", {0.0, 0.4, 0.0}));
    view.bodies.back().pose_W.orientation.coeffs().setConstant(kNan);
    view.tool_visible = true;
    view.tool = body("red", {0.0, -kNan, 0.0});
    view.ghost_visible = true;
    view.ghost_pose_W.position.setConstant(kNan);
    view.force = {true, {0.0, 0.0, 0.0}, {kNan, 0.0, 0.0}, "nan"};
    CHECK(studio->draw(view).rgba == empty.rgba);
    view.camera.eye_W.setConstant(kNan);
    view.camera.vertical_angle_deg = -1e300;
    view.ground_height_m = kNan;
    view.stars = 99;
    view.level = -5;
    view.score = std::numeric_limits<int>::min();
    (void)studio->draw(view);
    CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("picture: hostile words break nothing") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    std::string bytes;
    for (int i = 0; i < 50'000; ++i) {
        bytes += static_cast<char>(i * 31 + i / 7);
    }
    for (const std::string& words :
         {bytes, std::string(100'000, '*'), std::string(5'000, 'W'),
          std::string("\xF0\x9F\x8D\x8E \xED\x95\x9C\xEA\xB5\xAD \xD7\xA9\xCC\x81")}) {
        View view = nothing();
        view.bodies = {body("red", {0.0, 0.4, 0.0})};
        view.bodies[0].label = words;
        view.title = view.caption = view.feedback = view.input = view.banner = words;
        view.level_title = view.force.text = words;
        view.input_visible = true;
        view.force.visible = true;
        view.force.force_W = Vector3(0.0, 2.0, 0.0);
        (void)studio->draw(view);
        view.menu = {{words, words, words}};
        (void)studio->draw(view);
        CHECK(glGetError() == GL_NO_ERROR);
    }
}

TEST_CASE("picture: any size is drawn, none at all is left alone") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.caption = "Catch the fruit.";
    view.bodies = {body("red", {0.0, 0.4, 0.0})};
    const Image before = studio->draw(view);
    studio->renderer->draw(view, 0, 0);
    studio->renderer->draw(view, -5, 100);
    CHECK(studio->screen->read_back().rgba == before.rgba);
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 400}, {400, 3}, {3840, 2160}}) {
        REQUIRE(studio->screen->resize(width, height));
        const Image image = studio->draw(view);
        CHECK(image.width == width);
        CHECK(image.height == height);
        CHECK(glGetError() == GL_NO_ERROR);
        if (width > 1000) {
            CHECK(pixel_at(image, view, {0.0, 0.4, 0.1})[0] > 150);
        }
    }
}

TEST_CASE("picture: edges are smooth") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    View view = nothing();
    view.bodies = {body("red", {0.0, 0.45, 0.0})};
    const Image image = studio->draw(view);
    // Going out of the ball, some pixel is neither the ball's nor the background's.
    int between = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 1; x + 1 < kWidth; ++x) {
            const auto left = pixel(image, x - 1, y);
            const auto here = pixel(image, x, y);
            const auto right = pixel(image, x + 1, y);
            const int low = std::min(left[1], right[1]);
            const int high = std::max(left[1], right[1]);
            between += high - low > 100 && here[1] > low + 25 && here[1] < high - 25 ? 1 : 0;
        }
    }
    CHECK(between > 30);
}

TEST_CASE("renderer: wrong settings and models are refused in one sentence") {
    const auto studio = open_studio(64, 64);
    if (!studio) {
        return;
    }
    RendererSettings settings;
    settings.samples = 0;
    CHECK_FALSE(Renderer::create(settings));
    settings = {};
    settings.shadow_map_size = 100'000;
    CHECK_FALSE(Renderer::create(settings));

    const auto refused = [&](auto&& spoil) {
        LoadedModel model = ball("bad", {1, 1, 1, 1});
        spoil(model);
        const auto added = studio->renderer->add_model(model);
        CHECK_FALSE(studio->renderer->has_model("bad"));
        return !added && to_sentence(added.error()).find("bad") == 0;
    };
    CHECK(refused([](LoadedModel& m) { m.primitives.clear(); }));
    CHECK(refused([](LoadedModel& m) { m.primitives[0].indices[7] = 1'000'000; }));
    CHECK(refused([](LoadedModel& m) { m.primitives[0].indices.pop_back(); }));
    CHECK(refused([](LoadedModel& m) { m.primitives[0].positions[3] = NAN; }));
    CHECK(refused([](LoadedModel& m) { m.primitives[0].positions.pop_back(); }));
    CHECK(refused([](LoadedModel& m) { m.primitives[0].normals.pop_back(); }));
    CHECK(refused([](LoadedModel& m) { m.primitives[0].uvs.push_back(0.0F); }));
    CHECK(refused([](LoadedModel& m) { m.primitives[0].image = 0; }));
    CHECK(refused([](LoadedModel& m) { m.images.push_back({4, 4, {1, 2, 3}}); }));
    CHECK(refused([](LoadedModel& m) { m.images.push_back({1 << 30, 1 << 30, {}}); }));
    LoadedModel bare = ball("bare", {1, 1, 1, 1});
    bare.primitives[0].normals.clear();
    bare.primitives[0].uvs.clear();
    CHECK(studio->renderer->add_model(bare));
    CHECK(studio->renderer->has_model("bare"));
}

TEST_CASE("renderer: a model's picture is seen on it") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    LoadedModel model = ball("painted", {1, 1, 1, 1});
    model.images.push_back({1, 2, {0, 0, 255, 255, 0, 0, 255, 255}});
    model.primitives[0].image = 0;
    REQUIRE(studio->renderer->add_model(model));
    View view = nothing();
    view.bodies = {body("painted", {0.0, 0.4, 0.0})};
    const auto p = pixel_at(studio->draw(view), view, {0.0, 0.4, 0.1});
    CHECK(p[2] > 150);
    CHECK(p[2] > 2 * p[0]);
}

TEST_CASE("renderer: a missing font is a notice, and the picture is drawn") {
    auto screen = Offscreen::create(320, 180);
    if (!screen) {
        WARN("skipped: " << to_sentence(screen.error()));
        return;
    }
    RendererSettings settings;
    settings.font_folder = "/no/such/fonts";
    auto renderer = Renderer::create(settings);
    REQUIRE(renderer);
    REQUIRE((*renderer)->notices().size() == 1);
    View view = nothing();
    view.caption = "Words";
    (*renderer)->draw(view, 320, 180);
    CHECK(brightness(pixel((*screen)->read_back(), 160, 20)) > 300);
}

TEST_CASE("offscreen: sizes that cannot be are refused, the old one stays") {
    auto screen = Offscreen::create(64, 32);
    if (!screen) {
        WARN("skipped: " << to_sentence(screen.error()));
        return;
    }
    CHECK_FALSE((*screen)->resize(0, 10));
    CHECK_FALSE((*screen)->resize(100'000, 10));
    CHECK((*screen)->width() == 64);
    const Image image = (*screen)->read_back();
    CHECK(image.rgba.size() == 64UL * 32UL * 4UL);
    CHECK_FALSE(Offscreen::create(-1, 5));
}

TEST_CASE("offscreen: rows come from the top") {
    auto screen = Offscreen::create(8, 8);
    if (!screen) {
        WARN("skipped: " << to_sentence(screen.error()));
        return;
    }
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 6, 8, 2);
    glClearColor(1.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    const Image image = (*screen)->read_back();
    CHECK(pixel(image, 3, 0) == std::array{255, 0, 0});
    CHECK(pixel(image, 3, 7) == std::array{0, 0, 0});
}
