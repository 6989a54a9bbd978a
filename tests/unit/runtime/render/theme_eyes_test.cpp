// Signs are told apart by every pair of eyes, and the hand from what it touches.
#include "runtime/render/force_colour.h"
#include "runtime/render/scene/looks.h"
#include "runtime/render/scene/tool_model.h"
#include "tests/support/colour_vision.h"
#include "tests/unit/runtime/render/picture_fixture.h"

using namespace fulcrum::runtime::test;
using fulcrum::test::all_eyes;
using fulcrum::test::difference;
using fulcrum::test::Eyes;

namespace {

using runtime::Colour;
using runtime::ForceLook;

// Some six times what is just noticed side by side.
constexpr double kClear = 15.0;

// The mean of a square about a place of the world.
Colour mean_at(const Image& image, const runtime::View& view, const Vector3& point_W) {
    const Camera camera(view.camera, image.width, image.height);
    const auto seen = camera.project(point_W);
    REQUIRE(seen);
    constexpr int kHalf = 6;
    Vector3 sum = Vector3::Zero();
    for (int y = -kHalf; y <= kHalf; ++y) {
        for (int x = -kHalf; x <= kHalf; ++x) {
            const auto p = pixel(image, static_cast<int>(seen->position_px.x()) + x,
                                 static_cast<int>(seen->position_px.y()) + y);
            sum += Vector3(p[0], p[1], p[2]);
        }
    }
    const Vector3 mean = sum / (255.0 * (2 * kHalf + 1) * (2 * kHalf + 1));
    return {static_cast<float>(mean.x()), static_cast<float>(mean.y()),
            static_cast<float>(mean.z())};
}

}  // namespace

TEST_CASE("eyes: colours that are one, or close, to some eyes are told as such") {
    const auto eyes = all_eyes();
    const Colour red = runtime::from_hex(0xC00000);
    const Colour brown = runtime::from_hex(0x5C5000);
    CHECK(difference(eyes[0], red, brown) > 60.0);
    CHECK(difference(eyes[1], red, brown) < 12.0);
    for (const Eyes& each : eyes) {
        CHECK(difference(each, red, red) == 0.0);
        // Grey is grey to all.
        const Vector3 grey = seen_by(each, runtime::from_hex(0x808080));
        CHECK(grey.x() == Approx(53.6).margin(0.2));
        CHECK(std::abs(grey.y()) + std::abs(grey.z()) < 1.0);
    }
}

TEST_CASE("eyes: the arrows of different forces are told apart") {
    for (const Eyes& eyes : all_eyes()) {
        for (std::size_t i = 0; i < runtime::kForceLooks; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                INFO(eyes.name << ", " << i << " and " << j);
                CHECK(difference(eyes, runtime::colour_of(static_cast<ForceLook>(i)),
                                 runtime::colour_of(static_cast<ForceLook>(j))) > kClear);
            }
        }
    }
}

TEST_CASE(
    "eyes: the hand is seen before all that it touches, on all grounds, and beside the second") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    LoadedModel hand = runtime::make_tool_model(fulcrum::SphereShape{0.1});
    hand.name = "hand";
    LoadedModel second = runtime::make_second_tool_model(fulcrum::SphereShape{0.1});
    second.name = "second";
    REQUIRE(studio->renderer->add_model(hand));
    REQUIRE(studio->renderer->add_model(second));
    REQUIRE(studio->renderer->add_model(ball("plain", {1.0F, 1.0F, 1.0F, 1.0F})));
    runtime::View view = nothing();
    const Vector3 place(0.0, 0.4, 0.0);
    const auto colour_of = [&](const std::string& model, const std::string& look) {
        view.bodies = {body(model, place)};
        view.bodies[0].look = look;
        return mean_at(studio->draw(view), view, place + Vector3(0.0, 0.0, 0.1));
    };
    const Colour seen = colour_of("hand", "");
    std::vector<std::pair<std::string, Colour>> others{{"the second hand", colour_of("second", "")},
                                                       {"meadow", runtime::theme::kFloor},
                                                       {"rug", runtime::theme::kRug},
                                                       {"sky", runtime::theme::kWallTop},
                                                       {"space", runtime::theme::kSpace}};
    for (const std::string_view look : runtime::kLooks) {
        others.emplace_back(look, colour_of("plain", std::string(look)));
    }
    for (const Eyes& eyes : all_eyes()) {
        for (const auto& [what, colour] : others) {
            INFO(eyes.name << ": " << what);
            CHECK(difference(eyes, seen, colour) > kClear);
        }
    }
}
