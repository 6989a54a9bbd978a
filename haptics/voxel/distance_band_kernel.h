// The rows of a brick for distance_band.h, eight corners side by side, in the namespace FULCRUM_KERNEL. Included by distance_band.cpp for
// each version of it, after all other headers: compiler switches of that version are on here.
//
// Thread: any. Cost: see distance_band.h.

// NOLINTBEGIN(misc-definitions-in-headers): each version is a set of functions of its own
namespace fulcrum::FULCRUM_KERNEL {
namespace {

using Floats = float __attribute__((vector_size(32)));  // eight at once

// At x = 0, 1, ... 7 of the row.
Floats evaluate(const BandTriangle::Line& line, const Floats& x, float y, float z) noexcept {
    return line.slope[0] * x + (line.slope[1] * y + line.slope[2] * z + line.offset);
}

Floats larger_of(const Floats& a, const Floats& b) noexcept {
    return a > b ? a : b;
}
Floats smaller_of(const Floats& a, const Floats& b) noexcept {
    return a < b ? a : b;
}

Floats compute_squares(const BandTriangle& t, const Floats& x, float y, float z) noexcept {
    const Floats zero{};
    Floats outermost = zero - kFarAway;
    Floats nearest_edge = zero + kFarAway * kFarAway;
    for (std::size_t i = 0; i < 3; ++i) {
        const Floats beyond = evaluate(t.beyond[i], x, y, z);
        const Floats along = evaluate(t.along[i], x, y, z);
        const Floats past = larger_of(larger_of(-along, along - t.length[i]), zero);
        outermost = larger_of(outermost, beyond + t.not_a_face);
        nearest_edge = smaller_of(nearest_edge, beyond * beyond + past * past);
    }
    const Floats height = evaluate(t.height, x, y, z);
    return height * height + (outermost <= zero ? zero : nearest_edge);
}

void lower_row(const BandTriangle& t, const Floats& x, float y, float z, float* row) noexcept {
    Floats squares;
    std::memcpy(&squares, row, sizeof squares);
    squares = smaller_of(squares, compute_squares(t, x, y, z));
    std::memcpy(row, &squares, sizeof squares);
}

// Corners low to high along one axis that may lie within `reach` of `middle`.
struct Span {
    int low;
    int high;
};
Span find_span(float middle, float reach) noexcept {
    constexpr auto kLast = static_cast<float>(kBrickSide - 1);
    return {static_cast<int>(std::ceil(std::clamp(middle - reach, 0.0F, kLast + 1.0F))),
            static_cast<int>(std::floor(std::clamp(middle + reach, -1.0F, kLast)))};
}

void lower_squares(const BandTriangle& triangle, float band, BrickDistances& squares) noexcept {
    const Floats from_0{0.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F};
    const Floats from_1 = from_0 + 1.0F;
    const float reach = triangle.radius + band;
    const Span zs = find_span(triangle.middle[2], reach);
    for (int z = zs.low; z <= zs.high; ++z) {
        const float dz = static_cast<float>(z) - triangle.middle[2];
        const float in_layer = std::sqrt(std::max(reach * reach - dz * dz, 0.0F));
        const Span ys = find_span(triangle.middle[1], in_layer);
        for (int y = ys.low; y <= ys.high; ++y) {
            const float dy = static_cast<float>(y) - triangle.middle[1];
            const float in_row = std::sqrt(std::max(in_layer * in_layer - dy * dy, 0.0F));
            const Span xs = find_span(triangle.middle[0], in_row);
            float* const row = &squares[brick_corner_at(0, y, z)];
            if (xs.low <= std::min(xs.high, 0)) {
                lower_row(triangle, from_0, static_cast<float>(y), static_cast<float>(z), row);
            }
            if (xs.low <= xs.high && (xs.low > 0 || xs.high == kBrickCells)) {
                lower_row(triangle, from_1, static_cast<float>(y), static_cast<float>(z), row + 1);
            }
        }
    }
}

}  // namespace
}  // namespace fulcrum::FULCRUM_KERNEL
// NOLINTEND(misc-definitions-in-headers)
