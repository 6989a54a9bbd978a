#include "runtime/render/renderer.h"

#include "tests/unit/runtime/render/picture_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("picture: nothing breaks it, and its edges are smooth") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    runtime::View view = nothing();
    SECTION("numbers that are not finite, huge or upside down break nothing") {
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
    SECTION("hostile words break nothing") {
        std::string bytes;
        for (int i = 0; i < 50'000; ++i) {
            bytes += static_cast<char>(i * 31 + i / 7);
        }
        for (const std::string& words :
             {bytes, std::string(100'000, '*'), std::string(5'000, 'W'),
              std::string("\xF0\x9F\x8D\x8E \xED\x95\x9C\xEA\xB5\xAD \xD7\xA9\xCC\x81")}) {
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
    SECTION("any size is drawn, none at all is left alone") {
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
    SECTION("edges are smooth") {
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
    runtime::View view = nothing();
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
    runtime::View view = nothing();
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
