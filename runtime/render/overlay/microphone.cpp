#include "runtime/render/overlay/microphone.h"

#include "runtime/render/theme.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::runtime {
namespace {

// At 720; see Measure.
constexpr float kMicrophoneRadius = 19.0F;
constexpr float kBarStep = 9.0F;
constexpr float kBarWidth = 5.0F;
constexpr float kTallestBar = 30.0F;

void draw_microphone_shape(DrawList& list, const Point2& middle, float radius_px,
                           const Colour& ink) {
    const float r = radius_px;
    const auto at = [&](float x, float y) -> Point2 {
        return {middle[0] + x * r, middle[1] + y * r};
    };
    list.fill_box({middle[0] - 0.22F * r, middle[1] - 0.78F * r, 0.44F * r, 0.92F * r}, 0.22F * r,
                  ink);
    // The stand: half a ring from side to side, a foot.
    const float thick = 0.13F * r;
    constexpr int kPieces = 8;
    Point2 from = at(-0.42F, -0.12F);
    for (int i = 1; i <= kPieces; ++i) {
        const float angle = std::numbers::pi_v<float> * static_cast<float>(i) / kPieces;
        const Point2 to = at(-0.42F * std::cos(angle), -0.12F + 0.42F * std::sin(angle));
        list.line(from, to, thick, ink);
        from = to;
    }
    list.line(at(0.0F, 0.30F), at(0.0F, 0.62F), thick, ink);
    list.line(at(-0.28F, 0.62F), at(0.28F, 0.62F), thick, ink);
}

}  // namespace

float microphone_width_px(const Measure& measure) {
    return measure.px(2.0F * kMicrophoneRadius + 8.0F + kBarStep * static_cast<float>(kBars));
}

void draw_microphone(DrawList& list, const Point2& right_middle, const Measure& measure,
                     const ViewMicrophone& microphone) {
    const Colour& ink = microphone.hears ? list.colours().emphasis_ink : list.colours().soft_ink;
    const float left = right_middle[0] - microphone_width_px(measure);
    const Point2 middle{left + measure.px(kMicrophoneRadius), right_middle[1]};
    if (microphone.hears) {
        list.fill_disc(middle, measure.px(kMicrophoneRadius), ink);
        list.fill_disc(middle, measure.px(kMicrophoneRadius - 3.0F), list.colours().field_paper);
    }
    draw_microphone_shape(list, middle, measure.px(kMicrophoneRadius), ink);
    const auto n_up = static_cast<int>(
        std::lround(std::clamp(microphone.level, 0.0, 1.0) * static_cast<double>(kBars)));
    for (int i = 0; i < kBars; ++i) {
        const float share = static_cast<float>(i + 1) / static_cast<float>(kBars);
        const float height = measure.px(i < n_up ? kTallestBar * share : kBarWidth);
        const float x = right_middle[0] - measure.px(kBarStep * static_cast<float>(kBars - i));
        list.fill_box({x, right_middle[1] - 0.5F * std::max(height, measure.px(kBarWidth)),
                       measure.px(kBarWidth), std::max(height, measure.px(kBarWidth))},
                      0.5F * measure.px(kBarWidth), ink);
    }
}

}  // namespace fulcrum::runtime
