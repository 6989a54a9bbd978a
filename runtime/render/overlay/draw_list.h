// Flat shapes and words as triangles, in pixels from the top left corner.
//
//   Every edge carries a fringe one pixel wide in which alpha falls to 0: smooth without samples.
//
// Thread: one. Cost: a few dozen corners a shape, six a letter.
#pragma once

#include "runtime/render/colour.h"
#include "runtime/render/text/font.h"
#include "runtime/render/text/paragraph.h"
#include "runtime/render/theme.h"

#include <array>
#include <cstdint>
#include <vector>

namespace fulcrum::runtime {

/// A corner: place in pixels, place in the font's atlas (0 to 1), colour.
struct OverlayCorner {
    float x = 0.0F;
    float y = 0.0F;
    float u = 0.0F;
    float v = 0.0F;
    std::array<std::uint8_t, 4> rgba{};  ///< sRGB, straight alpha
};

/// An upright rectangle, pixels.
struct Box {
    float x = 0.0F;
    float y = 0.0F;
    float width = 0.0F;
    float height = 0.0F;
    [[nodiscard]] float right() const { return x + width; }
    [[nodiscard]] float bottom() const { return y + height; }
    [[nodiscard]] float middle_x() const { return x + 0.5F * width; }
    [[nodiscard]] float middle_y() const { return y + 0.5F * height; }
    [[nodiscard]] bool holds(double x_px, double y_px) const {
        return x_px >= static_cast<double>(x) && x_px < static_cast<double>(right()) &&
               y_px >= static_cast<double>(y) && y_px < static_cast<double>(bottom());
    }
    /// They lie over one another; one without width meets none.
    [[nodiscard]] bool meets(const Box& other) const {
        return width > 0.0F && other.width > 0.0F && x < other.right() && other.x < right() &&
               y < other.bottom() && other.y < bottom();
    }
    /// Grown by so much on every side.
    [[nodiscard]] Box grown(float by) const {
        return {x - by, y - by, width + 2.0F * by, height + 2.0F * by};
    }
};

using Point2 = std::array<float, 2>;

/// Triangles in the order in which they are drawn.
class DrawList {
  public:
    explicit DrawList(Font& font) : font_(font) {}

    /// A shape that is seen whole from `middle` (a star, any convex one), its corners in either
    /// turning direction, its edges moved out by `grow_px`.
    void fill(const Point2& middle, const std::vector<Point2>& outline, const Colour& colour,
              float grow_px = 0.0F);
    void fill_box(const Box& box, float radius_px, const Colour& colour);
    /// A line of a box's shape, `width_px` thick, inside the box.
    void frame_box(const Box& box, float radius_px, float width_px, const Colour& colour);
    /// The soft shadow that a box throws on what is behind it.
    void shadow_box(const Box& box, float radius_px, float blur_px, const Colour& colour);
    void fill_disc(const Point2& middle, float radius_px, const Colour& colour);
    /// A star with five rounded points, one of them up, grown by `grow_px` on every side.
    void fill_star(const Point2& middle, float radius_px, float grow_px, const Colour& colour);
    /// A straight line with round ends.
    void line(const Point2& from, const Point2& to, float width_px, const Colour& colour);

    /// Words with their upper left corner at x, y; each line is moved right by `align` (0 left, 0.5
    /// centred, 1 right) of the room that it leaves in `width_px`. Emphasised letters are bold,
    /// have the colour `emphasis` and are underlined.
    void text(const Paragraph& paragraph, float x, float y, float width_px, float align,
              const Colour& ink, const Colour& emphasis);

    [[nodiscard]] const std::vector<OverlayCorner>& corners() const { return corners_; }
    [[nodiscard]] Font& font() { return font_; }
    /// Of papers and inks from now on: one of the theme's, which outlives the list.
    void colour_by(const theme::Palette& palette) { palette_ = &palette; }
    [[nodiscard]] const theme::Palette& colours() const { return *palette_; }
    void clear() { corners_.clear(); }

  private:
    void triangle(const Point2& a, float alpha_a, const Point2& b, float alpha_b, const Point2& c,
                  float alpha_c, const Colour& colour);
    void letter(const Paragraph& paragraph, const PlacedLetter& placed, float x, float base,
                const Colour& colour);
    void underline(const TextLine& line, float x, float base, int size_px, const Colour& colour);

    Font& font_;
    const theme::Palette* palette_ = &theme::kUsual;
    std::vector<OverlayCorner> corners_;
};

/// The outline of a box with round corners.
[[nodiscard]] std::vector<Point2> rounded_outline(const Box& box, float radius_px);

}  // namespace fulcrum::runtime
