// The paper that figures are drawn on: a frame with axes, marks, lines, a legend, as SVG text.
#pragma once

#include "tests/bench/harness/report.h"
#include "tests/bench/harness/scale.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::bench {

/// A place on the paper, in pixels from its upper left corner.
struct Spot {
    double x = 0.0, y = 0.0;
};

/// Where axes are drawn; the legend stands right of it.
struct Frame {
    static constexpr double kWidth = 860.0, kHeight = 440.0;
    static constexpr double kLeft = 78.0, kRight = 630.0, kTop = 44.0, kBottom = 384.0;
};

class Canvas {
  public:
    /// Paper with frame, grid, ticks, titles of the axes and of the whole.
    Canvas(std::string_view title, const Axis& x, const Axis& y, const Extent& x_extent,
           const Extent& y_extent);

    [[nodiscard]] Spot spot(double x, double y) const { return {x_.place(x), y_.place(y)}; }

    /// A line through spots in the colour of series `index`; dashed when `theory`.
    void line(const std::vector<Spot>& spots, std::size_t index, bool theory);
    /// Broad and grey, below what is drawn later.
    void band(const std::vector<Spot>& spots);
    /// Thin and pale in the colour of series `index`.
    void hair(Spot from, Spot to, std::size_t index);
    /// The mark of series `index`; `hint` is shown when pointed at.
    void mark(Spot at, std::size_t index, std::string_view hint);
    /// A cross in that series' colour: it has no value.
    void cross(Spot at, std::size_t index, std::string_view hint);
    /// A ring around a spot, with a word.
    void ring(Spot at, std::string_view word);
    /// A small word right above a spot.
    void word(Spot at, std::string_view text);
    /// A line of the legend, in the order of calls: with that series' mark, or its line.
    void legend(std::size_t index, std::string_view name, LineStyle style);
    /// A line of the legend without a mark.
    void legend_note(std::string_view text);

    /// The finished file.
    [[nodiscard]] std::string finish() const;

  private:
    void axes(const Axis& x, const Axis& y);

    Scale x_, y_;
    std::string body_;
    double legend_y_ = Frame::kTop + 8.0;
};

}  // namespace fulcrum::bench
