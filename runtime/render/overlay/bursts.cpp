#include "runtime/render/overlay/bursts.h"

#include "runtime/render/theme.h"

#include <array>
#include <cmath>
#include <numbers>

namespace fulcrum::runtime {

namespace {

constexpr int kSparks = 12;
constexpr float kSpark_px = 8.0F;  // at 720, at first
constexpr std::array<Colour, 3> kLooks{theme::kStar, theme::kCloud, theme::kSkyBlue};

void draw_burst(const Point2& at, double part, const Measure& m, DrawList& list) {
    const auto age = static_cast<float>(part);
    const float out = m.px(kBurstReach) * (1.0F - std::exp(-4.0F * age));
    const float alpha = 1.0F - age * age;
    for (int i = 0; i < kSparks; ++i) {
        const auto number = static_cast<float>(i);
        const float turn = 2.0F * std::numbers::pi_v<float> * (number + 0.5F) / kSparks;
        const float far = i % 2 == 0 ? 1.0F : 0.72F;
        const Point2 place{at[0] + far * out * std::cos(turn),
                           at[1] + far * out * std::sin(turn) + m.px(kBurstFall) * age * age};
        const float radius = m.px(kSpark_px) * (1.0F - 0.5F * age);
        const Colour colour = with_alpha(kLooks.at(static_cast<std::size_t>(i) % 3), alpha);
        if (i % 3 == 0) {
            list.fill_star(place, 1.3F * radius, 0.0F, colour);
        } else {
            list.fill_disc(place, 0.6F * radius, colour);
        }
    }
}

}  // namespace

void draw_bursts(const std::vector<ViewBurst>& bursts, const Camera& camera, const Measure& measure,
                 DrawList& list) {
    for (const ViewBurst& burst : bursts) {
        const auto seen = camera.project(burst.at_W);
        const double part = burst.age_s / kBurstLasts_s;
        if (seen && part >= 0.0 && part < 1.0) {
            draw_burst({static_cast<float>(seen->position_px.x()),
                        static_cast<float>(seen->position_px.y())},
                       part, measure, list);
        }
    }
}

}  // namespace fulcrum::runtime
