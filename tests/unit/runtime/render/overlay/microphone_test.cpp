#include "runtime/render/overlay/microphone.h"

#include "runtime/render/overlay/panels.h"
#include "runtime/render/renderer.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::runtime;

namespace {

const Measure kMeasure(1280, 720);
constexpr Point2 kRightMiddle{600.0F, 400.0F};

std::vector<OverlayCorner> drawn(const ViewMicrophone& microphone) {
    Font font(RendererSettings{}.font_folder);
    DrawList list(font);
    draw_microphone(list, kRightMiddle, kMeasure, microphone);
    return list.corners();
}

// How high the bars stand above their middle, right of the microphone itself.
float bars_px(double level) {
    float top = kRightMiddle[1];
    for (const OverlayCorner& corner : drawn({true, false, level, {}})) {
        const bool is_bar = corner.x > kRightMiddle[0] - kMeasure.px(45.0F);
        top = is_bar ? std::min(top, corner.y) : top;
    }
    return kRightMiddle[1] - top;
}

PanelLayout laid_out(const View& view) {
    Font font(RendererSettings{}.font_folder);
    return lay_out_panels(view, font, kMeasure);
}

}  // namespace

TEST_CASE("microphone: it stays in its room, and its bars rise with the sound") {
    for (const double level : {0.0, 0.5, 1.0}) {
        for (const bool hears : {false, true}) {
            for (const OverlayCorner& corner : drawn({true, hears, level, {}})) {
                CHECK(corner.x > kRightMiddle[0] - microphone_width_px(kMeasure) - 3.0F);
                CHECK(corner.x < kRightMiddle[0] + 3.0F);
                CHECK(std::abs(corner.y - kRightMiddle[1]) < kMeasure.px(22.0F));
            }
        }
    }
    CHECK(bars_px(0.0) < kMeasure.px(4.0F));
    CHECK(bars_px(0.5) > 2.0F * bars_px(0.0));
    CHECK(bars_px(1.0) > 1.3F * bars_px(0.5));
    CHECK(bars_px(7.0) == bars_px(1.0));
    CHECK(bars_px(-1.0) == bars_px(0.0));
}

TEST_CASE(
    "microphone: whether it takes in what is said is seen by its shape, not by colour alone") {
    CHECK(drawn({true, true, 0.0, {}}).size() > drawn({true, false, 0.0, {}}).size());
}

TEST_CASE("microphone: the line to type in says how to speak, until something is typed beside it") {
    View view;
    view.input_visible = true;
    view.microphone = {true, false, 0.0, "Hold Control and speak, or type."};
    CHECK(laid_out(view).input.words.width_px > kMeasure.px(300.0F));
    view.input = "it";
    CHECK(laid_out(view).input.words.width_px < kMeasure.px(60.0F));
    // Long words leave the microphone its room.
    view.input = std::string(300, 'a');
    const float beside = laid_out(view).input.words.width_px;
    view.microphone.visible = false;
    CHECK(laid_out(view).input.words.width_px - beside >
          microphone_width_px(kMeasure) - kMeasure.px(30.0F));
}
