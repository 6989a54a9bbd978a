// Painted pictures: colours are linear while painted and sRGB when stored.
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace fulcrum::assets {

/// Linear red, green, blue, 0 to 1.
using Colour = Vector3;

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;  ///< sRGB, rows from the top
};

/// A colour as designers write it, 0xRRGGBB in sRGB, made linear.
[[nodiscard]] Colour srgb(std::uint32_t hex);

/// `a` at 0, `b` at 1.
[[nodiscard]] Colour blend(const Colour& a, const Colour& b, double t);

/// Paints every pixel: `colour(u, v)` at its centre, u to the right, v down.
[[nodiscard]] Picture paint(int width, int height,
                            const std::function<Colour(double u, double v)>& colour);

/// The picture as a PNG file, without compression: quick to read.
/// Source: W3C, Portable Network Graphics Specification (Second Edition), 2003; RFC 1950, RFC 1951
/// section 3.2.4.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const Picture& picture);

}  // namespace fulcrum::assets
