#include "runtime/render/overlay/icons.h"

#include "runtime/render/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fulcrum::runtime {

namespace {

constexpr Colour kWhite = from_hex(0xFFFFFF);

Point2 offset(const Point2& middle, float dx, float dy) {
    return {middle[0] + dx, middle[1] + dy};
}

/// Not this.
void draw_cross(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    for (const float way : {-1.0F, 1.0F}) {
        list.line(offset(middle, -r, -way * r), offset(middle, r, way * r), 0.42F * r,
                  theme::kVermillion);
    }
}

/// A speech bubble with three dots.
void draw_speech_icon(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    list.fill(offset(middle, -0.35F * r, 0.62F * r),
              {offset(middle, -0.62F * r, 0.40F * r), offset(middle, 0.0F, 0.55F * r),
               offset(middle, -0.60F * r, 1.0F * r)},
              list.colours().emphasis_ink);
    list.fill_box({middle[0] - r, middle[1] - 0.80F * r, 2.0F * r, 1.45F * r}, 0.5F * r,
                  list.colours().emphasis_ink);
    for (const float dx : {-0.45F, 0.0F, 0.45F}) {
        list.fill_disc(offset(middle, dx * r, -0.08F * r), 0.14F * r, kWhite);
    }
}

/// A bubble, and below it as many arrowheads as it is fast.
void draw_voice(DrawList& list, const Point2& middle, float r, int step) {
    draw_speech_icon(list, offset(middle, 0.0F, -0.22F * r), 0.78F * r);
    if (step == 0) {
        draw_cross(list, offset(middle, 0.55F * r, 0.55F * r), 0.38F * r);
    }
    for (int i = 0; i < step; ++i) {
        const float x = 0.42F * (static_cast<float>(i) - 0.5F * static_cast<float>(step - 1));
        const Point2 tip = offset(middle, (x + 0.14F) * r, 0.80F * r);
        for (const float side : {-0.2F, 0.2F}) {
            list.line(offset(tip, -0.22F * r, side * r), tip, 0.12F * r,
                      list.colours().emphasis_ink);
        }
    }
}

/// A letter on its line.
void draw_letter(DrawList& list, const Point2& middle, float r, int step) {
    const float high = (0.45F + 0.25F * static_cast<float>(step)) * r;
    const Point2 top = offset(middle, 0.0F, 0.8F * r - 2.0F * high + 0.1F * r);
    for (const float side : {-1.0F, 1.0F}) {
        list.line(top, offset(middle, side * 0.72F * high, 0.8F * r), 0.24F * high,
                  list.colours().emphasis_ink);
    }
    const Point2 bar = offset(middle, 0.0F, 0.8F * r - 0.62F * high);
    list.line(offset(bar, -0.44F * high, 0.0F), offset(bar, 0.44F * high, 0.0F), 0.22F * high,
              list.colours().emphasis_ink);
}

/// What somebody says, in a letter of the language.
void draw_language(DrawList& list, const Point2& middle, float r, int step) {
    constexpr std::array<const char*, 3> kLetters{"A", "Ñ", "한"};
    const Colour ink = list.colours().emphasis_ink;
    list.fill_box({middle[0] - r, middle[1] - 0.9F * r, 2.0F * r, 1.45F * r}, 0.35F * r, ink);
    list.fill(offset(middle, -0.35F * r, 0.65F * r),
              {offset(middle, -0.7F * r, 0.4F * r), offset(middle, 0.0F, 0.4F * r),
               offset(middle, -0.6F * r, r)},
              ink);
    ParagraphSettings settings;
    settings.size_px = static_cast<int>(1.15F * r);
    settings.face = Face::bold;
    const Paragraph letter =
        set_text(list.font(),
                 plain_text(kLetters[static_cast<std::size_t>(step) % kLetters.size()]), settings);
    list.text(letter, middle[0] - r, middle[1] - 0.175F * r - 0.5F * letter.height_px, 2.0F * r,
              0.5F, list.colours().paper, list.colours().paper);
}

/// A disc with a light and a dark half, far apart or less so.
void draw_contrast(DrawList& list, const Point2& middle, float r, bool high) {
    const Colour dark = high ? from_hex(0x000000) : from_hex(0x5B6C94);
    const Colour light = high ? kWhite : from_hex(0xBFD0E6);
    list.fill_disc(middle, r, list.colours().ink);
    list.fill_disc(middle, 0.88F * r, light);
    std::vector<Point2> half;
    constexpr int kPieces = 16;
    for (int i = 0; i <= kPieces; ++i) {
        const float turn = std::numbers::pi_v<float> * (0.5F + static_cast<float>(i) / kPieces);
        half.push_back(offset(middle, 0.88F * r * std::cos(turn), 0.88F * r * std::sin(turn)));
    }
    list.fill(offset(middle, -0.4F * r, 0.0F), half, dark);
}

/// A ball that flies, or lies on the ground.
void draw_motion(DrawList& list, const Point2& middle, float r, bool calm) {
    const Colour& ink = list.colours().emphasis_ink;
    if (calm) {
        list.fill_disc(offset(middle, 0.0F, 0.1F * r), 0.52F * r, ink);
        list.line(offset(middle, -0.9F * r, 0.76F * r), offset(middle, 0.9F * r, 0.76F * r),
                  0.14F * r, ink);
        return;
    }
    list.fill_disc(offset(middle, 0.42F * r, -0.2F * r), 0.52F * r, ink);
    for (const float y : {-0.55F, -0.15F, 0.25F}) {
        const float from = y == -0.15F ? -0.95F : -0.75F;
        list.line(offset(middle, from * r, y * r), offset(middle, -0.3F * r, y * r), 0.13F * r,
                  ink);
    }
}

/// One's own hand from above; the left one's thumb is on the right.
void draw_own_hand(DrawList& list, const Point2& middle, float r, bool left) {
    const Colour& ink = list.colours().emphasis_ink;
    const float way = left ? 1.0F : -1.0F;
    list.fill_box({middle[0] - 0.46F * r, middle[1] - 0.1F * r, 0.92F * r, 0.95F * r}, 0.3F * r,
                  ink);
    constexpr std::array<float, 4> kLengths{0.72F, 0.92F, 0.85F, 0.6F};  // from the thumb's side
    for (std::size_t i = 0; i < kLengths.size(); ++i) {
        const float x = way * (0.36F - 0.24F * static_cast<float>(i)) * r;
        list.line(offset(middle, x, 0.15F * r), offset(middle, x, -kLengths.at(i) * r), 0.2F * r,
                  ink);
    }
    list.line(offset(middle, way * 0.3F * r, 0.5F * r), offset(middle, way * 0.82F * r, -0.05F * r),
              0.23F * r, ink);
}

}  // namespace

void draw_star_icon(DrawList& list, const Point2& middle, float radius_px, bool earned) {
    const float rim = std::max(0.08F * radius_px, 1.5F);
    const float inside = radius_px - rim;
    list.fill_star(middle, inside, rim, earned ? list.colours().ink : list.colours().soft_ink);
    list.fill_star(middle, inside, 0.0F, earned ? theme::kStar : list.colours().paper);
}

void draw_light_icon(DrawList& list, const Point2& middle, float radius_px, bool lit) {
    constexpr int kRays = 8;
    const float disc = 0.62F * radius_px;
    list.fill_disc(middle, disc, lit ? list.colours().ink : list.colours().soft_ink);
    list.fill_disc(middle, disc - std::max(0.12F * radius_px, 1.5F),
                   lit ? theme::kStar : list.colours().paper);
    for (int i = 0; lit && i < kRays; ++i) {
        const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kRays;
        const float x = std::cos(angle);
        const float y = std::sin(angle);
        list.line(offset(middle, 0.75F * radius_px * x, 0.75F * radius_px * y),
                  offset(middle, radius_px * x, radius_px * y), 0.16F * radius_px,
                  list.colours().ink);
    }
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

void draw_pencil_icon(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    list.line(offset(middle, -0.25F * r, 0.25F * r), offset(middle, 0.60F * r, -0.60F * r),
              0.46F * r, list.colours().emphasis_ink);
    list.fill(offset(middle, -0.50F * r, 0.50F * r),
              {offset(middle, -0.85F * r, 0.85F * r), offset(middle, -0.47F * r, 0.02F * r),
               offset(middle, -0.02F * r, 0.47F * r)},
              list.colours().emphasis_ink);
    list.line(offset(middle, 0.24F * r, -0.58F * r), offset(middle, 0.58F * r, -0.24F * r),
              0.10F * r, kWhite);
}

void draw_tick_icon(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    list.fill_disc(middle, r, list.colours().emphasis_ink);
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
              list.colours().ink);
}

void draw_pause_icon(DrawList& list, const Point2& middle, float radius_px, bool paused) {
    const float r = radius_px;
    if (paused) {
        list.fill(middle,
                  {offset(middle, -0.6F * r, -r), offset(middle, 1.0F * r, 0.0F),
                   offset(middle, -0.6F * r, r)},
                  list.colours().emphasis_ink);
        return;
    }
    for (const float dx : {-0.5F, 0.5F}) {
        list.line(offset(middle, dx * r, -0.75F * r), offset(middle, dx * r, 0.75F * r), 0.42F * r,
                  list.colours().emphasis_ink);
    }
}

void draw_leave_icon(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    const Colour& ink = list.colours().emphasis_ink;
    const float width = 0.26F * r;
    const std::array<Point2, 4> door{
        offset(middle, 0.1F * r, -0.9F * r), offset(middle, -0.9F * r, -0.9F * r),
        offset(middle, -0.9F * r, 0.9F * r), offset(middle, 0.1F * r, 0.9F * r)};
    for (std::size_t i = 0; i + 1 < door.size(); ++i) {
        list.line(door[i], door[i + 1], width, ink);
    }
    list.line(offset(middle, -0.4F * r, 0.0F), offset(middle, 1.0F * r, 0.0F), width, ink);
    for (const float up : {-0.45F, 0.45F}) {
        list.line(offset(middle, 0.55F * r, up * r), offset(middle, 1.05F * r, 0.0F), width, ink);
    }
}

void draw_loudspeaker_icon(DrawList& list, const Point2& middle, float radius_px, int waves) {
    const float r = radius_px;
    list.fill_box({middle[0] - r, middle[1] - 0.34F * r, 0.7F * r, 0.68F * r}, 0.1F * r,
                  list.colours().emphasis_ink);
    list.fill(offset(middle, -0.3F * r, 0.0F),
              {offset(middle, -0.7F * r, 0.0F), offset(middle, 0.0F, -0.85F * r),
               offset(middle, 0.0F, 0.85F * r)},
              list.colours().emphasis_ink);
    for (int i = 0; i < waves; ++i) {
        const float wave = i == 0 ? 0.45F : 0.85F;
        const float half = 0.62F * wave * r;
        list.line(offset(middle, wave * r - 0.22F * r, -half), offset(middle, wave * r, 0.0F),
                  0.16F * r, list.colours().emphasis_ink);
        list.line(offset(middle, wave * r, 0.0F), offset(middle, wave * r - 0.22F * r, half),
                  0.16F * r, list.colours().emphasis_ink);
    }
    if (waves == 0) {
        draw_cross(list, offset(middle, 0.55F * r, 0.0F), 0.38F * r);
    }
}

void draw_gear_icon(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    constexpr int kTeeth = 8;
    for (int i = 0; i < kTeeth; ++i) {
        const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kTeeth;
        const float x = std::cos(turn) * r;
        const float y = std::sin(turn) * r;
        list.line(offset(middle, 0.5F * x, 0.5F * y), offset(middle, 0.88F * x, 0.88F * y),
                  0.30F * r, list.colours().emphasis_ink);
    }
    list.fill_disc(middle, 0.72F * r, list.colours().emphasis_ink);
    list.fill_disc(middle, 0.30F * r, list.colours().paper);
}

void draw_setting_icon(DrawList& list, const Point2& middle, float radius_px,
                       const ViewSetting& setting) {
    const int step = setting.step;
    switch (setting.kind) {
        case SettingKind::sound:
            return draw_loudspeaker_icon(list, middle, radius_px, step);
        case SettingKind::voice:
            return draw_voice(list, middle, radius_px, step);
        case SettingKind::text_size:
            return draw_letter(list, middle, radius_px, step);
        case SettingKind::contrast:
            return draw_contrast(list, middle, radius_px, step > 0);
        case SettingKind::motion:
            return draw_motion(list, middle, radius_px, step > 0);
        case SettingKind::hand:
            return draw_own_hand(list, middle, radius_px, step > 0);
        case SettingKind::language:
            return draw_language(list, middle, radius_px, step);
    }
}

void draw_question_icon(DrawList& list, const Point2& middle, float radius_px) {
    const float r = radius_px;
    const auto at = [&](float x, float y) { return offset(middle, x * r, y * r); };
    const std::array<Point2, 8> hook{at(-0.55F, -0.45F), at(-0.4F, -0.82F), at(0.0F, -1.0F),
                                     at(0.4F, -0.82F),   at(0.52F, -0.45F), at(0.35F, -0.1F),
                                     at(0.06F, 0.12F),   at(0.0F, 0.42F)};
    for (std::size_t i = 1; i < hook.size(); ++i) {
        list.line(hook[i - 1], hook[i], 0.32F * r, list.colours().emphasis_ink);
    }
    list.fill_disc(at(0.0F, 0.92F), 0.21F * r, list.colours().emphasis_ink);
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
