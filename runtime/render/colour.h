// Colours as on the screen, their luminance and contrast.
//
//   linear c = s/12.92 below 0.04045, ((s + 0.055)/1.055)^2.4 above;  L = 0.2126 R + 0.7152 G +
//   0.0722 B contrast = (L_light + stray) / (L_dark + stray), stray = 0.05 on a good screen
//
// Thread: any. Cost: a few pow.
// Source: IEC 61966-2-1, 1999 (sRGB); W3C, Web Content Accessibility Guidelines 2.1, 2018,
// "contrast ratio".
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fulcrum::runtime {

/// sRGB-encoded red, green, blue and straight alpha, each 0 to 1.
struct Colour {
    float r = 0.0F;
    float g = 0.0F;
    float b = 0.0F;
    float a = 1.0F;
};

/// 0xRRGGBB and an alpha.
[[nodiscard]] constexpr Colour from_hex(std::uint32_t rgb, float alpha = 1.0F) {
    return {static_cast<float>((rgb >> 16U) & 255U) / 255.0F,
            static_cast<float>((rgb >> 8U) & 255U) / 255.0F,
            static_cast<float>(rgb & 255U) / 255.0F, alpha};
}

/// The same colour with another alpha.
[[nodiscard]] constexpr Colour with_alpha(Colour colour, float alpha) {
    colour.a = alpha;
    return colour;
}

/// Light that an sRGB-encoded channel stands for, both 0 to 1.
[[nodiscard]] inline float to_linear(float encoded) {
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

/// Relative luminance, 0 black to 1 white; alpha is not looked at.
[[nodiscard]] inline double relative_luminance(const Colour& colour) {
    return 0.2126 * static_cast<double>(to_linear(colour.r)) +
           0.7152 * static_cast<double>(to_linear(colour.g)) +
           0.0722 * static_cast<double>(to_linear(colour.b));
}

/// Stray light as a part of white's light: on a good screen, and on a projector in a room with
/// daylight, where white is only ten times as bright as black: (1 + x) / x = 10.
inline constexpr double kScreenStrayLight = 0.05;
inline constexpr double kProjectorStrayLight = 1.0 / 9.0;

/// 1 (the same) to 21 (black and white on a good screen).
[[nodiscard]] inline double contrast_ratio(const Colour& one, const Colour& other,
                                           double stray_light = kScreenStrayLight) {
    const double a = relative_luminance(one) + stray_light;
    const double b = relative_luminance(other) + stray_light;
    return std::max(a, b) / std::min(a, b);
}

}  // namespace fulcrum::runtime
