#include "runtime/render/overlay/draw_list.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::runtime {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr std::size_t kMostCorners = 600'000;  // a safe upper bound for one frame

std::uint8_t to_byte(float part) {
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(part, 0.0F, 1.0F)));
}

/// Outward normals at a closed outline's corners, scaled so that edges move by 1.
std::vector<Point2> outward_normals(const std::vector<Point2>& outline, const Point2& middle) {
    const std::size_t n = outline.size();
    const auto edge_normal = [&](std::size_t i) -> Point2 {
        const Point2& a = outline[i];
        const Point2& b = outline[(i + 1) % n];
        const float dx = b[0] - a[0];
        const float dy = b[1] - a[1];
        const float length = std::max(std::hypot(dx, dy), 1e-6F);
        Point2 normal{dy / length, -dx / length};
        if (normal[0] * (a[0] - middle[0]) + normal[1] * (a[1] - middle[1]) < 0.0F) {
            normal = {-normal[0], -normal[1]};
        }
        return normal;
    };
    std::vector<Point2> normals(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Point2 before = edge_normal((i + n - 1) % n);
        const Point2 after = edge_normal(i);
        Point2 sum{before[0] + after[0], before[1] + after[1]};
        const float square = std::max(sum[0] * sum[0] + sum[1] * sum[1], 0.5F);
        normals[i] = {2.0F * sum[0] / square, 2.0F * sum[1] / square};
    }
    return normals;
}

Point2 moved(const Point2& point, const Point2& normal, float by) {
    return {point[0] + by * normal[0], point[1] + by * normal[1]};
}

}  // namespace

std::vector<Point2> rounded_outline(const Box& box, float radius_px) {
    const float radius = std::clamp(radius_px, 0.0F, 0.5F * std::min(box.width, box.height));
    if (radius < 0.5F) {
        return {{box.right(), box.y},
                {box.right(), box.bottom()},
                {box.x, box.bottom()},
                {box.x, box.y}};
    }
    const int steps = std::clamp(static_cast<int>(2.0F * std::sqrt(radius)), 2, 24);
    const std::array<Point2, 4> centres{{{box.right() - radius, box.y + radius},
                                         {box.right() - radius, box.bottom() - radius},
                                         {box.x + radius, box.bottom() - radius},
                                         {box.x + radius, box.y + radius}}};
    std::vector<Point2> outline;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        for (int i = 0; i <= steps; ++i) {
            const float turn = 0.5F * kPi *
                               (static_cast<float>(corner) - 1.0F +
                                static_cast<float>(i) / static_cast<float>(steps));
            outline.push_back({centres[corner][0] + radius * std::cos(turn),
                               centres[corner][1] + radius * std::sin(turn)});
        }
    }
    return outline;
}

void DrawList::triangle(const Point2& a, float alpha_a, const Point2& b, float alpha_b,
                        const Point2& c, float alpha_c, const Colour& colour) {
    if (corners_.size() + 3 > kMostCorners) {
        return;
    }
    constexpr float kWhite = 1.5F / kAtlasSide;  // inside the atlas' full pixels
    const std::array<std::pair<const Point2*, float>, 3> three{
        {{&a, alpha_a}, {&b, alpha_b}, {&c, alpha_c}}};
    for (const auto& [point, alpha] : three) {
        corners_.push_back(
            {(*point)[0],
             (*point)[1],
             kWhite,
             kWhite,
             {to_byte(colour.r), to_byte(colour.g), to_byte(colour.b), to_byte(colour.a * alpha)}});
    }
}

void DrawList::fill(const Point2& middle, const std::vector<Point2>& outline, const Colour& colour,
                    float grow_px) {
    const std::size_t n = outline.size();
    const std::vector<Point2> normals = outward_normals(outline, middle);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        const Point2 inner_i = moved(outline[i], normals[i], grow_px - 0.5F);
        const Point2 inner_j = moved(outline[j], normals[j], grow_px - 0.5F);
        const Point2 outer_i = moved(outline[i], normals[i], grow_px + 0.5F);
        const Point2 outer_j = moved(outline[j], normals[j], grow_px + 0.5F);
        triangle(middle, 1.0F, inner_i, 1.0F, inner_j, 1.0F, colour);
        triangle(inner_i, 1.0F, outer_i, 0.0F, outer_j, 0.0F, colour);
        triangle(inner_i, 1.0F, outer_j, 0.0F, inner_j, 1.0F, colour);
    }
}

void DrawList::fill_box(const Box& box, float radius_px, const Colour& colour) {
    fill({box.middle_x(), box.middle_y()}, rounded_outline(box, radius_px), colour);
}

void DrawList::frame_box(const Box& box, float radius_px, float width_px, const Colour& colour) {
    const Point2 middle{box.middle_x(), box.middle_y()};
    const std::vector<Point2> outline = rounded_outline(box.grown(-0.5F * width_px), radius_px);
    const std::vector<Point2> normals = outward_normals(outline, middle);
    const float half = 0.5F * width_px;
    const std::array<std::pair<float, float>, 4> rims{
        {{-half - 0.5F, 0.0F}, {-half + 0.5F, 1.0F}, {half - 0.5F, 1.0F}, {half + 0.5F, 0.0F}}};
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = (i + 1) % outline.size();
        for (std::size_t rim = 0; rim + 1 < rims.size(); ++rim) {
            const auto [low, low_alpha] = rims[rim];
            const auto [high, high_alpha] = rims[rim + 1];
            const Point2 low_i = moved(outline[i], normals[i], low);
            const Point2 low_j = moved(outline[j], normals[j], low);
            const Point2 high_i = moved(outline[i], normals[i], high);
            const Point2 high_j = moved(outline[j], normals[j], high);
            triangle(low_i, low_alpha, high_i, high_alpha, high_j, high_alpha, colour);
            triangle(low_i, low_alpha, high_j, high_alpha, low_j, low_alpha, colour);
        }
    }
}

void DrawList::shadow_box(const Box& box, float radius_px, float blur_px, const Colour& colour) {
    // Rings whose alpha falls as a smooth step, so that no edge shows.
    constexpr int kRings = 6;
    const Point2 middle{box.middle_x(), box.middle_y()};
    const std::vector<Point2> outline =
        rounded_outline(box.grown(-0.5F * blur_px), std::max(radius_px - 0.5F * blur_px, 2.0F));
    const std::vector<Point2> normals = outward_normals(outline, middle);
    const auto strength = [](int ring) {
        const float t = 1.0F - static_cast<float>(ring) / kRings;
        return t * t * (3.0F - 2.0F * t);
    };
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = (i + 1) % outline.size();
        triangle(middle, 1.0F, outline[i], 1.0F, outline[j], 1.0F, colour);
        for (int ring = 0; ring < kRings; ++ring) {
            const float low = blur_px * static_cast<float>(ring) / kRings;
            const float high = blur_px * static_cast<float>(ring + 1) / kRings;
            const Point2 low_i = moved(outline[i], normals[i], low);
            const Point2 low_j = moved(outline[j], normals[j], low);
            const Point2 high_i = moved(outline[i], normals[i], high);
            const Point2 high_j = moved(outline[j], normals[j], high);
            triangle(low_i, strength(ring), high_i, strength(ring + 1), high_j, strength(ring + 1),
                     colour);
            triangle(low_i, strength(ring), high_j, strength(ring + 1), low_j, strength(ring),
                     colour);
        }
    }
}

void DrawList::fill_disc(const Point2& middle, float radius_px, const Colour& colour) {
    fill_box({middle[0] - radius_px, middle[1] - radius_px, 2.0F * radius_px, 2.0F * radius_px},
             radius_px, colour);
}

void DrawList::fill_star(const Point2& middle, float radius_px, float grow_px,
                         const Colour& colour) {
    // Ten corners, the outer ones cut round by three points each.
    constexpr float kInner = 0.52F;
    std::vector<Point2> outline;
    for (int i = 0; i < 5; ++i) {
        const float turn = -0.5F * kPi + 2.0F * kPi * static_cast<float>(i) / 5.0F;
        for (const float off : {-0.14F, -0.10F, -0.05F, 0.0F, 0.05F, 0.10F, 0.14F}) {
            const float reach = radius_px * (0.97F - 5.0F * off * off);
            outline.push_back({middle[0] + reach * std::cos(turn + off),
                               middle[1] + reach * std::sin(turn + off)});
        }
        const float between = turn + 0.2F * kPi;
        outline.push_back({middle[0] + kInner * radius_px * std::cos(between),
                           middle[1] + kInner * radius_px * std::sin(between)});
    }
    fill(middle, outline, colour, grow_px);
}

void DrawList::line(const Point2& from, const Point2& to, float width_px, const Colour& colour) {
    const float dx = to[0] - from[0];
    const float dy = to[1] - from[1];
    const float along = std::atan2(dy, dx);
    constexpr int kRound = 8;
    std::vector<Point2> outline;
    for (const auto& [end, start_turn] :
         {std::pair{to, along - 0.5F * kPi}, std::pair{from, along + 0.5F * kPi}}) {
        for (int i = 0; i <= kRound; ++i) {
            const float turn = start_turn + kPi * static_cast<float>(i) / kRound;
            outline.push_back({end[0] + 0.5F * width_px * std::cos(turn),
                               end[1] + 0.5F * width_px * std::sin(turn)});
        }
    }
    fill({0.5F * (from[0] + to[0]), 0.5F * (from[1] + to[1])}, outline, colour);
}

void DrawList::letter(const Paragraph& paragraph, const PlacedLetter& placed, float x, float base,
                      const Colour& colour) {
    const auto size = static_cast<float>(paragraph.size_px);
    const float pen = x + placed.x_px + placed.shaped.shift_em * size;
    // Small letters may stand at quarters of a pixel; at large sizes whole ones do.
    constexpr int kLargestAtQuarters = 48;
    const float quarters = paragraph.size_px <= kLargestAtQuarters ? std::floor(4.0F * pen + 0.5F)
                                                                   : 4.0F * std::round(pen);
    const float whole = std::floor(quarters / 4.0F);
    const int quarter = static_cast<int>(quarters - 4.0F * whole);
    const Glyph glyph = font_.glyph(placed.shaped, paragraph.size_px, quarter);
    if (glyph.width == 0 || corners_.size() + 6 > kMostCorners) {
        return;
    }
    const float left = whole + static_cast<float>(glyph.left);
    const float top =
        std::round(base - placed.shaped.rise_em * size) - static_cast<float>(glyph.top);
    const std::array<std::uint8_t, 4> rgba{to_byte(colour.r), to_byte(colour.g), to_byte(colour.b),
                                           to_byte(colour.a)};
    const auto corner = [&](int right, int down) {
        const int dx = right * glyph.width;
        const int dy = down * glyph.height;
        return OverlayCorner{left + static_cast<float>(dx), top + static_cast<float>(dy),
                             static_cast<float>(glyph.x + dx) / kAtlasSide,
                             static_cast<float>(glyph.y + dy) / kAtlasSide, rgba};
    };
    for (const auto& [right, down] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
        corners_.push_back(corner(right, down));
    }
}

void DrawList::underline(const TextLine& line, float x, float base, int size_px,
                         const Colour& colour) {
    const auto size = static_cast<float>(size_px);
    const float thick = std::max(2.0F, std::round(0.08F * size));
    for (std::size_t i = 0; i < line.letters.size();) {
        if (!line.letters[i].emphasised) {
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < line.letters.size() && line.letters[end].emphasised) {
            ++end;
        }
        const float from = x + line.letters[i].x_px;
        const float to = x + line.letters[end - 1].x_px + line.letters[end - 1].advance_px;
        fill_box({from, std::round(base + 0.15F * size), to - from, thick}, 0.5F * thick, colour);
        i = end;
    }
}

void DrawList::text(const Paragraph& paragraph, float x, float y, float width_px, float align,
                    const Colour& ink, const Colour& emphasis) {
    // The words stand in the middle of their line's height.
    const LineMetrics& m = paragraph.metrics;
    float base = y + 0.5F * (m.line_px - m.ascent_px - m.descent_px) + m.ascent_px;
    for (const TextLine& line : paragraph.lines) {
        const float start = x + align * (width_px - line.width_px);
        underline(line, start, base, paragraph.size_px, emphasis);
        for (const PlacedLetter& placed : line.letters) {
            letter(paragraph, placed, start, base, placed.emphasised ? emphasis : ink);
        }
        base += m.line_px;
    }
}

}  // namespace fulcrum::runtime
