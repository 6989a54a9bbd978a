#include "runtime/render/overlay/face.h"

#include "runtime/render/theme.h"

#include <array>

namespace fulcrum::runtime {

namespace {

constexpr Colour kFaceWhite = theme::kCloud;

/// A smile from corner to corner, `deep` below them in its middle.
void draw_smile(DrawList& list, const Point2& middle, float half, float deep, float width) {
    constexpr int kParts = 8;
    const auto at = [&](int i) {
        const float x = 2.0F * static_cast<float>(i) / kParts - 1.0F;
        return Point2{middle[0] + half * x, middle[1] + deep * (1.0F - x * x)};
    };
    for (int i = 0; i < kParts; ++i) {
        list.line(at(i), at(i + 1), width, kFaceWhite);
    }
}

}  // namespace

void draw_face(DrawList& list, const Point2& middle, float radius_px, ViewMood mood, bool speaks) {
    const float r = radius_px;
    const auto at = [&](float x, float y) { return Point2{middle[0] + x * r, middle[1] + y * r}; };
    const Colour body = list.colours().emphasis_ink;
    // A triangle with round corners.
    const std::array<Point2, 3> corners{at(0.0F, -0.42F), at(-0.62F, 0.62F), at(0.62F, 0.62F)};
    list.fill(at(0.0F, 0.27F), {corners.begin(), corners.end()}, body);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        list.line(corners[i], corners[(i + 1) % corners.size()], 0.62F * r, body);
    }
    list.line(at(-0.95F, -0.84F), at(0.95F, -0.84F), 0.20F * r, theme::kOrange);

    const bool thinks = mood == ViewMood::thoughtful;
    const Point2 look = thinks ? Point2{0.06F, -0.07F} : Point2{0.0F, 0.0F};
    for (const float side : {-0.27F, 0.27F}) {
        list.fill_disc(at(side, 0.08F), 0.18F * r, kFaceWhite);
        list.fill_disc(at(side + look[0], 0.08F + look[1]), 0.09F * r, body);
    }
    if (speaks) {
        list.fill_disc(at(0.0F, 0.56F), 0.19F * r, kFaceWhite);
    } else if (thinks) {
        list.line(at(-0.06F, 0.56F), at(0.20F, 0.50F), 0.11F * r, kFaceWhite);
    } else {
        const bool happy = mood == ViewMood::happy;
        draw_smile(list, at(0.0F, 0.46F), (happy ? 0.42F : 0.26F) * r, (happy ? 0.26F : 0.12F) * r,
                   0.11F * r);
    }
}

}  // namespace fulcrum::runtime
