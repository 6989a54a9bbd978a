#include "runtime/render/scene/scene_painter.h"

#include "tests/unit/runtime/render/picture_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>

using namespace fulcrum::runtime::test;

TEST_CASE("picture: what there is is seen, where and as it is") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    runtime::View view = nothing();
    SECTION("an empty view shows sky above and floor below, and no OpenGL error") {
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
    SECTION("the same view gives the same picture, whatever its time") {
        view.bodies = {body("red", {0.0, 0.4, 0.0})};
        view.caption = "Hello";
        const Image first = studio->draw(view);
        view.time_s = 123.4;
        CHECK(studio->draw(view).rgba == first.rgba);
    }
    SECTION("a body is seen where it is, in its colour, nearer ones before others") {
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
    SECTION("squash makes a body flatter and wider") {
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
    SECTION("a line goes round a body that is offered; what is lit shines farther") {
        view.bodies = {body("green", {0.0, 0.45, 0.0})};
        const Image plain = studio->draw(view);
        view.bodies[0].light = fulcrum::runtime::BodyLight::offered;
        const Image outlined = studio->draw(view);
        CHECK(changed(plain, outlined) > 150);
        view.bodies[0].light = fulcrum::runtime::BodyLight::lit;
        CHECK(changed(plain, studio->draw(view)) > 2 * changed(plain, outlined));
        CHECK(pixel_at(plain, view, {0.0, 0.45, 0.1}) ==
              pixel_at(outlined, view, {0.0, 0.45, 0.1}));
    }
    SECTION("in space it is dark all around, with neither floor nor shadow") {
        view.in_space = true;
        const Image image = studio->draw(view);
        int dark = 0;
        for (int y = 0; y < kHeight; y += 4) {
            dark += brightness(pixel(image, 100, y)) < 150 ? 1 : 0;
        }
        CHECK(dark > kHeight / 4 - 12);  // some are stars
        // An orbit is a line, and a body before it hides it.
        view.bodies = {body("orbit", {0.0, 0.4, 0.0})};
        view.bodies[0].scale.setConstant(0.3);
        CHECK(studio->draw(view).rgba != image.rgba);
        CHECK(glGetError() == GL_NO_ERROR);
    }
}

TEST_CASE("picture: shadows and marks tell where a thing is above the floor") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    runtime::View view = nothing();
    SECTION("shadows darken the floor below a body, and only there") {
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
    SECTION("the shadow of a body high above lies where the lamp throws it") {
        view.camera.eye_W = Vector3(0.0, 1.2, 1.2);
        const Image bare = studio->draw(view);
        view.bodies = {body("red", {0.0, 3.0, 0.0})};
        const Image image = studio->draw(view);
        const Light light = light_for(Camera(view.camera, kWidth, kHeight), 0.0,
                                      RendererSettings{}.shadow_map_size);
        const Vector3 to_lamp = light.to_lamp.cast<double>();
        const Vector3 thrown = view.bodies[0].pose_W.position - to_lamp * (3.0 / to_lamp.y());
        const Vector3 edge = thrown * (1.0 + 0.05 / thrown.norm());
        CHECK(brightness(pixel_at(image, view, edge)) <
              brightness(pixel_at(bare, view, edge)) * 85 / 100);
    }
    SECTION("a body shades the one below it, and no body shades itself in stripes") {
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
            const int step = std::abs(brightness(pixel(alone, x + dx, y)) -
                                      brightness(pixel(alone, x + dx + 1, y)));
            CHECK(step < 40);
        }
    }
    SECTION("the mark on the floor shows where a falling body will land") {
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
    SECTION("the hand's mark is dashed, a falling thing's is whole") {
        // How often brightness, on the way around the mark's ring, passes the mean of a dash and a gap.
        const auto changes = [&](const runtime::View& told) {
            const Image image = studio->draw(told);
            // The ring is a quarter larger where a thing is one reach of the light above the floor.
            const double reach_m = kLightReach * Camera(told.camera, kWidth, kHeight).distance_m();
            const double ring_m = 0.1 * (1.0 + 0.25 * 0.45 / reach_m);
            constexpr int kPlaces = 364;
            constexpr int kDash = kPlaces / 28;
            const auto seen = [&](int i) {
                const double turn = 2.0 * std::numbers::pi * i / kPlaces;
                return brightness(
                    pixel_at(image, told, ring_m * Vector3(std::cos(turn), 0.0, std::sin(turn))));
            };
            int count = 0;
            bool was_dark = false;
            for (int i = 0; i < kPlaces; ++i) {
                int around = 0;
                for (int j = -kDash; j < kDash; ++j) {
                    around += seen(i + j);
                }
                constexpr int kClearly = 6;
                const int darker = around / (2 * kDash) - seen(i);
                const bool dark = darker > kClearly || (was_dark && darker > -kClearly);
                count += dark != was_dark ? 1 : 0;
                was_dark = dark;
            }
            return count;
        };
        runtime::View falling = nothing();
        falling.camera.eye_W = Vector3(0.0, 0.9, 0.9);
        falling.camera.target_W = Vector3(0.0, 0.1, 0.0);
        runtime::View held = falling;
        falling.bodies.push_back(body("red", {0.0, 0.55, 0.0}));
        held.tool = body("red", {0.0, 0.55, 0.0});
        held.tool_visible = true;
        INFO("changes: held " << changes(held) << ", falling " << changes(falling));
        CHECK(changes(held) >= 20);  // 14 dashes
        CHECK(changes(held) > 2 * changes(falling));
    }
    SECTION("a far thing that is sunk in the floor grows out of it without an edge") {
        runtime::View hill = nothing();
        hill.camera.eye_W = Vector3(0.0, 1.0, 1.5);
        hill.camera.target_W = Vector3(0.0, 0.4, 0.0);
        hill.bodies.push_back(body("red", {0.0, -0.4, -3.0}));
        hill.bodies.back().scale.setConstant(10.0);  // a ball of 1 m radius, 1.4 m of it sunk
        const auto difference = [](const std::array<int, 3>& a, const std::array<int, 3>& b) {
            return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
        };
        const Image image = studio->draw(hill);
        const double edge_m = -3.0 + std::sqrt(1.0 - 0.4 * 0.4);
        const auto floor = pixel_at(image, hill, {0.0, 0.0, edge_m + 0.3});
        const auto foot = pixel_at(image, hill, {0.0, 0.03, edge_m});
        const auto top = pixel_at(image, hill, {0.0, 0.57, -3.0});
        CHECK(difference(floor, foot) < 20);
        CHECK(difference(floor, top) > 60);
        // What stands on the floor keeps its colour down to it.
        hill.bodies.back().pose_W.position.y() = 1.0;
        const Image standing = studio->draw(hill);
        CHECK(difference(pixel_at(standing, hill, {0.0, 0.2, -2.4}), floor) > 150);
    }
}

TEST_CASE("picture: what is behind a thing is seen through it where it has to be") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    runtime::View view = nothing();
    SECTION("the force is seen through everything before it") {
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
    SECTION("the ghost is seen through") {
        view = {};
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
    SECTION("a hand behind a thing is seen through it, one before it is as any thing is") {
        const Vector3 behind{0.0, 0.4, -0.3};
        const Vector3 before{0.0, 0.4, 0.3};
        view.bodies = {body("green", {0.0, 0.4, 0.0})};
        view.bodies.back().scale = {2.0, 2.0, 2.0};
        const auto alone = pixel_at(studio->draw(view), view, behind);

        view.tool_visible = true;
        view.tool = body("red", behind);
        const auto through = pixel_at(studio->draw(view), view, behind);
        CHECK(through[0] > alone[0] + 30);
        const auto edge = pixel_at(studio->draw(view), view, behind + Vector3(0.09, 0.0, 0.0));
        CHECK(edge[0] > through[0]);  // its outline more than its middle

        view.tool.pose_W.position = before;
        const Image as_hand = studio->draw(view);
        view.tool_visible = false;
        view.bodies.push_back(view.tool);
        const Image as_thing = studio->draw(view);
        for (const double aside_m : {-0.08, -0.04, 0.0, 0.04, 0.08}) {
            const Vector3 point = before + Vector3(aside_m, 0.0, 0.0);
            CHECK(pixel_at(as_hand, view, point) == pixel_at(as_thing, view, point));
        }
        CHECK(glGetError() == GL_NO_ERROR);
    }
    SECTION("what lies in the hand does not let it through") {
        const Vector3 inside{0.0, 0.42, 0.0};
        view.bodies = {body("green", inside)};
        view.bodies.back().scale = {0.5, 0.5, 0.5};
        const Vector3 seen = inside + Vector3(0.0, 0.0, 0.05);
        const auto alone = pixel_at(studio->draw(view), view, seen);
        // A flat hand behind and around it.
        view.tool_visible = true;
        view.tool = body("red", {0.0, 0.4, -0.12});
        view.tool.scale = {2.0, 1.0, 1.5};
        CHECK(pixel_at(studio->draw(view), view, seen) == alone);
        view.tool.pose_W.position.y() += 0.1;  // higher than its lowest point: no longer held
        view.tool.scale = {2.0, 3.0, 1.0};
        view.tool.pose_W.position.z() = -0.5;
        CHECK(pixel_at(studio->draw(view), view, seen) != alone);
    }
}
