#include "runtime/render/overlay/icons.h"

#include "runtime/render/theme.h"

#include <algorithm>
#include <array>

namespace fulcrum::runtime {

namespace {

constexpr Colour kWhite = from_hex(0xFFFFFF);

Point2 offset(const Point2& middle, float dx, float dy) {
    return {middle[0] + dx, middle[1] + dy};
}

}  // namespace

void draw_star_icon(DrawList& list, const Point2& middle, float radius_px, bool earned) {
    const float rim = std::max(0.08F * radius_px, 1.5F);
    const float inside = radius_px - rim;
    list.fill_star(middle, inside, rim, earned ? theme::kInk : theme::kSoftInk);
    list.fill_star(middle, inside, 0.0F, earned ? theme::kStar : theme::kPaper);
}

void draw_warning_icon(DrawList& list, const Point2& middle, float radius_px) {
    const auto triangle = [&](float r) -> std::vector<Point2> {
        return {offset(middle, 0.0F, -r),
                offset(middle, 0.08F * r, -0.97F * r),
                offset(middle, 0.98F * r, 0.68F * r),
                offset(middle, 0.90F * r, 0.80F * r),
                offset(middle, -0.90F * r, 0.80F * r),
                offset(middle, -0.98F * r, 0.68F * r),
                offset(middle, -0.08F * r, -0.97F * r)};
    };
    list.fill(offset(middle, 0.0F, 0.2F * radius_px), triangle(radius_px), theme::kVermillion);
    const float thick = 0.20F * radius_px;
    list.line(offset(middle, 0.0F, -0.36F * radius_px), offset(middle, 0.0F, 0.22F * radius_px),
              thick, kWhite);
    list.fill_disc(offset(middle, 0.0F, 0.54F * radius_px), 0.62F * thick, kWhite);
}

void draw_notice_icon(DrawList& list, const Point2& middle, float radius_px) {
    list.fill_disc(middle, radius_px, theme::kBlue);
    const float thick = 0.22F * radius_px;
    list.fill_disc(offset(middle, 0.0F, -0.5F * radius_px), 0.62F * thick, kWhite);
    list.line(offset(middle, 0.0F, -0.12F * radius_px), offset(middle, 0.0F, 0.5F * radius_px),
              thick, kWhite);
}

void draw_speech_icon(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    list.fill(offset(middle, -0.35F * r, 0.62F * r),
              {offset(middle, -0.62F * r, 0.40F * r), offset(middle, 0.0F, 0.55F * r),
               offset(middle, -0.60F * r, 1.0F * r)},
              theme::kEmphasisInk);
    list.fill_box({middle[0] - r, middle[1] - 0.80F * r, 2.0F * r, 1.45F * r}, 0.5F * r,
                  theme::kEmphasisInk);
    for (const float dx : {-0.45F, 0.0F, 0.45F}) {
        list.fill_disc(offset(middle, dx * r, -0.08F * r), 0.14F * r, kWhite);
    }
}

void draw_pencil_icon(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    list.line(offset(middle, -0.25F * r, 0.25F * r), offset(middle, 0.60F * r, -0.60F * r),
              0.46F * r, theme::kEmphasisInk);
    list.fill(offset(middle, -0.50F * r, 0.50F * r),
              {offset(middle, -0.85F * r, 0.85F * r), offset(middle, -0.47F * r, 0.02F * r),
               offset(middle, -0.02F * r, 0.47F * r)},
              theme::kEmphasisInk);
    list.line(offset(middle, 0.24F * r, -0.58F * r), offset(middle, 0.58F * r, -0.24F * r),
              0.10F * r, kWhite);
}

void draw_tick_icon(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    list.fill_disc(middle, r, theme::kEmphasisInk);
    list.line(offset(middle, -0.45F * r, 0.02F * r), offset(middle, -0.12F * r, 0.38F * r),
              0.24F * r, kWhite);
    list.line(offset(middle, -0.12F * r, 0.38F * r), offset(middle, 0.48F * r, -0.34F * r),
              0.24F * r, kWhite);
}

void draw_more_icon(DrawList& list, const Point2& middle, float radius_px, bool up) {
    const float way = up ? -1.0F : 1.0F;
    list.fill(middle,
              {offset(middle, -radius_px, -0.5F * way * radius_px),
               offset(middle, radius_px, -0.5F * way * radius_px),
               offset(middle, 0.0F, 0.6F * way * radius_px)},
              theme::kInk);
}

void draw_pause_icon(DrawList& list, const Point2& middle, float radius_px, bool paused) {
    const float r = radius_px;
    if (paused) {
        list.fill(middle,
                  {offset(middle, -0.6F * r, -r), offset(middle, 1.0F * r, 0.0F),
                   offset(middle, -0.6F * r, r)},
                  theme::kEmphasisInk);
        return;
    }
    for (const float dx : {-0.5F, 0.5F}) {
        list.line(offset(middle, dx * r, -0.75F * r), offset(middle, dx * r, 0.75F * r), 0.42F * r,
                  theme::kEmphasisInk);
    }
}

void draw_loudspeaker_icon(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    list.fill_box({middle[0] - r, middle[1] - 0.34F * r, 0.7F * r, 0.68F * r}, 0.1F * r,
                  theme::kEmphasisInk);
    list.fill(offset(middle, -0.3F * r, 0.0F),
              {offset(middle, -0.7F * r, 0.0F), offset(middle, 0.0F, -0.85F * r),
               offset(middle, 0.0F, 0.85F * r)},
              theme::kEmphasisInk);
    for (const float wave : {0.45F, 0.85F}) {
        const float half = 0.62F * wave * r;
        list.line(offset(middle, wave * r - 0.22F * r, -half), offset(middle, wave * r, 0.0F),
                  0.16F * r, theme::kEmphasisInk);
        list.line(offset(middle, wave * r, 0.0F), offset(middle, wave * r - 0.22F * r, half),
                  0.16F * r, theme::kEmphasisInk);
    }
}

void draw_question_icon(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    const auto at = [&](float x, float y) { return offset(middle, x * r, y * r); };
    const std::array<Point2, 8> hook{at(-0.55F, -0.45F), at(-0.4F, -0.82F), at(0.0F, -1.0F),
                                     at(0.4F, -0.82F),   at(0.52F, -0.45F), at(0.35F, -0.1F),
                                     at(0.06F, 0.12F),   at(0.0F, 0.42F)};
    for (std::size_t i = 1; i < hook.size(); ++i) {
        list.line(hook[i - 1], hook[i], 0.32F * r, theme::kEmphasisInk);
    }
    list.fill_disc(at(0.0F, 0.92F), 0.21F * r, theme::kEmphasisInk);
}

void draw_arrow_icon(DrawList& list, const Point2& middle, float radius_px, const Point2& direction,
                     const Colour& colour) {
    const float r = radius_px;
    const auto at = [&](float along, float across) -> Point2 {
        return {middle[0] + r * (along * direction[0] - across * direction[1]),
                middle[1] + r * (along * direction[1] + across * direction[0])};
    };
    list.line(at(-0.85F, 0.0F), at(0.2F, 0.0F), 0.34F * r, colour);
    list.fill(at(0.35F, 0.0F), {at(1.0F, 0.0F), at(0.0F, 0.62F), at(0.0F, -0.62F)}, colour);
}

}  // namespace fulcrum::runtime
