// Sizes of panels and words, as on a screen of 1280 x 720, grown or shrunk with the window.
#pragma once

#include <algorithm>
#include <cmath>

namespace fulcrum::runtime {

/// Multiplies all sizes of the overlay. Words are never below 24 px in a picture 720 px high; in a
/// picture narrower than 4:3 they shrink with its width. `text_scale`: as ViewLook has it.
struct Measure {
    float width_px = 1280.0F;
    float height_px = 720.0F;
    float scale = 1.0F;

    Measure(int width, int height, double text_scale = 1.0)
        : width_px(static_cast<float>(std::max(width, 1))),
          height_px(static_cast<float>(std::max(height, 1))),
          scale(std::min(height_px / 720.0F, width_px / 960.0F) * static_cast<float>(text_scale)) {}

    /// A length of the 720-pixel screen, here.
    [[nodiscard]] float px(float at_720) const { return at_720 * scale; }
    /// A size of words of the 720-pixel screen, here; at least 1.
    [[nodiscard]] int text_px(float at_720) const {
        return std::max(static_cast<int>(std::lround(at_720 * scale)), 1);
    }
};

// Sizes of words at 720.
inline constexpr float kSmallText = 24.0F;   // labels, second lines
inline constexpr float kBodyText = 28.0F;    // banner, titles of cards
inline constexpr float kSpokenText = 34.0F;  // caption, feedback, what is typed
inline constexpr float kHeadline = 46.0F;    // the menu's title

}  // namespace fulcrum::runtime
