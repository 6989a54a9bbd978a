// A font, a picture in which much stands, and how boxes of the overlay lie to one another.
#pragma once

#include "runtime/render/overlay/measure.h"
#include "runtime/render/renderer.h"
#include "runtime/scene/view.h"

#include <catch2/catch.hpp>

#include <vector>

namespace fulcrum::runtime {

inline Font andika() {
    return Font(RendererSettings{}.font_folder);
}

inline View busy() {
    View view;
    view.title = "Which fruit is the heaviest?";
    view.level = 3;
    view.level_title = "Four fruits";
    view.caption = "Weigh the apple, then the watermelon. Move the bucket under each and wait.";
    view.feedback = "Yes. A watermelon is *the heaviest*.";
    view.input_visible = true;
    view.input = "the watermelon";
    view.banner = "The arm is not plugged in, so the mouse moves the bucket.";
    view.score = 12;
    view.buttons = {ScreenButton::ask, ScreenButton::why, ScreenButton::say_again,
                    ScreenButton::pause};
    return view;
}

inline bool overlap(const Box& a, const Box& b) {
    constexpr float kTouch = 0.01F;
    return a.x + kTouch < b.right() && b.x + kTouch < a.right() && a.y + kTouch < b.bottom() &&
           b.y + kTouch < a.bottom();
}

inline bool inside(const Box& box, const Measure& m) {
    return box.x >= -0.01F && box.y >= -0.01F && box.right() <= m.width_px + 0.01F &&
           box.bottom() <= m.height_px + 0.01F;
}

/// Each lies inside the picture, and none over another.
inline void check_apart(const std::vector<Box>& boxes, const Measure& measure) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        INFO(measure.width_px << " x " << measure.height_px << ", box " << i);
        CHECK(inside(boxes[i], measure));
        for (std::size_t j = 0; j < i; ++j) {
            CHECK_FALSE(overlap(boxes[i], boxes[j]));
        }
    }
}

/// The box, or the paper, of each.
template <class Things, class Which>
std::vector<Box> boxes_of(const Things& things, Which which) {
    std::vector<Box> boxes;
    for (const auto& thing : things) {
        boxes.push_back(thing.*which);
    }
    return boxes;
}

}  // namespace fulcrum::runtime
