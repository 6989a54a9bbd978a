#include "tests/bench/harness/canvas.h"

#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/svg.h"

#include <cmath>
#include <cstdio>

namespace fulcrum::bench {
namespace {

// Okabe and Ito's colours, which the colour-blind can tell apart; the yellow is too pale for lines.
constexpr std::array<const char*, 7> kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                              "#E69F00", "#56B4E9", "#000000"};
constexpr std::array<const char*, 3> kDashes{"", "7 4", "2 3"};
constexpr double kLegendX = Frame::kRight + 18.0;
constexpr double kLegendLine = 19.0;
constexpr std::size_t kLegendLetters = 32;

const char* colour(std::size_t index) {
    return kColours[index % kColours.size()];
}

std::string px(double value) {
    std::array<char, 24> text{};
    std::snprintf(text.data(), text.size(), "%.1f", value);
    return text.data();
}

std::string text_at(double x, double y, std::string_view anchor, std::string_view text,
                    std::string_view more = {}) {
    return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" text-anchor=\"" + std::string(anchor) +
           "\"" + std::string(more) + ">" + escape_xml(text) + "</text>\n";
}

std::string segment(Spot from, Spot to, std::string_view style) {
    return "<line x1=\"" + px(from.x) + "\" y1=\"" + px(from.y) + "\" x2=\"" + px(to.x) +
           "\" y2=\"" + px(to.y) + "\" " + std::string(style) + "/>\n";
}

std::string points_of(const std::vector<Spot>& spots) {
    std::string text;
    for (const Spot& s : spots) {
        text += px(s.x) + "," + px(s.y) + " ";
    }
    return text;
}

std::string stroke(std::size_t index, double width) {
    return "stroke=\"" + std::string(colour(index)) + "\" stroke-width=\"" + px(width) + "\"";
}

// Each series has a shape of its own as well as a colour.
std::string shape(Spot at, std::size_t index) {
    constexpr double r = 4.5;
    const auto polygon = [&](std::initializer_list<Spot> corners) {
        std::vector<Spot> spots;
        for (const Spot& c : corners) {
            spots.push_back({at.x + r * c.x, at.y + r * c.y});
        }
        return "<polygon points=\"" + points_of(spots) + "\"";
    };
    const std::string fill = " fill=\"" + std::string(colour(index)) + "\"";
    switch (index % 5) {
        case 0:
            return "<circle cx=\"" + px(at.x) + "\" cy=\"" + px(at.y) + "\" r=\"" + px(r) + "\"" +
                   fill;
        case 1:
            return polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) + fill;
        case 2:
            return polygon({{0, -1.3}, {1.2, 0.9}, {-1.2, 0.9}}) + fill;
        case 3:
            return polygon({{0, -1.4}, {1.4, 0}, {0, 1.4}, {-1.4, 0}}) + fill;
        default:
            return polygon({{-1.2, -0.9}, {1.2, -0.9}, {0, 1.3}}) + fill;
    }
}

std::string hinted(std::string element, std::string_view hint) {
    return element + "><title>" + escape_xml(hint) + "</title></" +
           element.substr(1, element.find(' ') - 1) + ">\n";
}

std::string title_of_axis(const Axis& axis) {
    return axis.unit.empty() ? axis.name : axis.name + ", " + axis.unit;
}

// 1e-06 as 10⁻⁶ reads better; other numbers as they are.
std::string tick_text(double value) {
    const double exponent = std::log10(std::abs(value));
    const bool decade = value > 0.0 && std::abs(exponent - std::round(exponent)) < 1e-9;
    if (!decade || std::abs(exponent) < 3.5) {
        return to_text(std::abs(value) < 1e-12 ? 0.0 : value);
    }
    constexpr std::array<const char*, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0.0 ? "10⁻" : "10";
    for (const char c : std::to_string(std::lround(std::abs(exponent)))) {
        text += kDigits[static_cast<std::size_t>(c - '0')];
    }
    return text;
}

std::string shortened(std::string_view text) {
    return text.size() <= kLegendLetters ? std::string(text)
                                         : std::string(text.substr(0, kLegendLetters - 1)) + "…";
}

}  // namespace

std::string escape_xml(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

Canvas::Canvas(std::string_view title, const Axis& x, const Axis& y, const Extent& x_extent,
               const Extent& y_extent)
    : x_(x_extent, x.logarithmic, Frame::kLeft, Frame::kRight),
      y_(y_extent, y.logarithmic, Frame::kBottom, Frame::kTop) {
    body_ += text_at(Frame::kLeft, Frame::kTop - 18.0, "start", title,
                     " font-size=\"16\" font-weight=\"bold\"");
    axes(x, y);
}

void Canvas::axes(const Axis& x, const Axis& y) {
    constexpr const char* kGrid = "stroke=\"#e3e3e3\"";
    for (const double tick : x_.ticks()) {
        const double at = x_.place(tick);
        body_ += segment({at, Frame::kTop}, {at, Frame::kBottom}, kGrid);
        body_ += text_at(at, Frame::kBottom + 17.0, "middle", tick_text(tick));
    }
    for (const double tick : y_.ticks()) {
        const double at = y_.place(tick);
        body_ += segment({Frame::kLeft, at}, {Frame::kRight, at}, kGrid);
        body_ += text_at(Frame::kLeft - 7.0, at + 4.0, "end", tick_text(tick));
    }
    body_ += "<rect x=\"" + px(Frame::kLeft) + "\" y=\"" + px(Frame::kTop) + "\" width=\"" +
             px(Frame::kRight - Frame::kLeft) + "\" height=\"" + px(Frame::kBottom - Frame::kTop) +
             "\" fill=\"none\" stroke=\"#777\"/>\n";
    body_ += text_at(0.5 * (Frame::kLeft + Frame::kRight), Frame::kBottom + 40.0, "middle",
                     title_of_axis(x));
    body_ += text_at(0.0, 0.0, "middle", title_of_axis(y),
                     " transform=\"translate(16 " + px(0.5 * (Frame::kTop + Frame::kBottom)) +
                         ") rotate(-90)\"");
}

void Canvas::line(const std::vector<Spot>& spots, std::size_t index, bool theory) {
    if (spots.size() < 2) {
        return;
    }
    // The second round of the colours is dotted.
    const char* const dash = theory ? kDashes[1] : index >= kColours.size() ? kDashes[2] : "";
    body_ += "<polyline points=\"" + points_of(spots) + "\" fill=\"none\" " + stroke(index, 1.8) +
             (*dash != '\0' ? " stroke-dasharray=\"" + std::string(dash) + "\"" : "") + "/>\n";
}

void Canvas::band(const std::vector<Spot>& spots) {
    body_ += "<polyline points=\"" + points_of(spots) +
             "\" fill=\"none\" stroke=\"#bbb\" stroke-width=\"7\" stroke-linejoin=\"round\"/>\n";
}

void Canvas::hair(Spot from, Spot to, std::size_t index) {
    body_ += segment(from, to, stroke(index, 0.8) + " stroke-opacity=\"0.55\"");
}

void Canvas::mark(Spot at, std::size_t index, std::string_view hint) {
    body_ += hinted(shape(at, index), hint);
}

void Canvas::cross(Spot at, std::size_t index, std::string_view hint) {
    constexpr double r = 4.0;
    body_ += hinted("<path d=\"M" + px(at.x - r) + " " + px(at.y - r) + " l" + px(2 * r) + " " +
                        px(2 * r) + " m0 " + px(-2 * r) + " l" + px(-2 * r) + " " + px(2 * r) +
                        "\" fill=\"none\" " + stroke(index, 1.5),
                    hint);
}

void Canvas::ring(Spot at, std::string_view word) {
    body_ += "<circle cx=\"" + px(at.x) + "\" cy=\"" + px(at.y) +
             "\" r=\"9\" fill=\"none\" stroke=\"#000\" stroke-width=\"1.6\"/>\n";
    const bool at_right = at.x > 0.6 * Frame::kRight;
    body_ += text_at(at.x + (at_right ? -13.0 : 13.0), at.y + 18.0, at_right ? "end" : "start",
                     word, " font-weight=\"bold\"");
}

void Canvas::word(Spot at, std::string_view text) {
    body_ += text_at(at.x, at.y - 8.0, "middle", text, " font-size=\"10\" fill=\"#555\"");
}

void Canvas::legend(std::size_t index, std::string_view name, LineStyle style) {
    const Spot left{kLegendX, legend_y_};
    if (style != LineStyle::dots) {
        line({left, {left.x + 24.0, left.y}}, index, style == LineStyle::theory);
    }
    if (style != LineStyle::theory) {
        mark({left.x + 12.0, left.y}, index, name);
    }
    body_ += text_at(left.x + 31.0, left.y + 4.0, "start", shortened(name));
    legend_y_ += kLegendLine;
}

void Canvas::legend_note(std::string_view text) {
    body_ += text_at(kLegendX, legend_y_ + 4.0, "start", text, " fill=\"#555\" font-size=\"11\"");
    legend_y_ += kLegendLine;
}

std::string Canvas::finish() const {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + px(Frame::kWidth) + " " +
           px(Frame::kHeight) +
           "\" font-family=\"Andika, sans-serif\" font-size=\"12\" fill=\"#222\" role=\"img\">\n"
           "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" +
           body_ + "</svg>\n";
}

}  // namespace fulcrum::bench
