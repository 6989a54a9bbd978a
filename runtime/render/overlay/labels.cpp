#include "runtime/render/overlay/labels.h"

#include "runtime/render/force_colour.h"
#include "runtime/render/overlay/icons.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/overlay/paper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace fulcrum::runtime {

namespace {

constexpr float kLabelPadX = 14.0F;
constexpr float kLabelPadY = 3.0F;
constexpr float kAway = 10.0F;  // between a thing and its label
constexpr float kLabelIconRoom = 30.0F;
constexpr float kLabelIcon = 14.0F;
constexpr float kWidest = 420.0F;
constexpr float kInscribed = 0.7F;  // half a square's side in a circle of radius 1

bool inside(const Box& box, const Measure& m) {
    return box.x >= 0.0F && box.y >= 0.0F && box.right() <= m.width_px &&
           box.bottom() <= m.height_px;
}

float common_area(const Box& a, const Box& b) {
    const float width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
    const float height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
    return std::max(width, 0.0F) * std::max(height, 0.0F);
}

/// Square pixels of a box over what other things cover, about.
float area_over_others(const Box& box, const std::vector<SceneLabel>& labels,
                       const SceneLabel& label, float margin) {
    float area = 0.0F;
    for (const SceneLabel& other : labels) {
        if (&other == &label || other.is_force) {
            continue;
        }
        const float half = kInscribed * other.radius_px + margin;
        area += common_area(
            box, {other.middle_px[0] - half, other.middle_px[1] - half, 2.0F * half, 2.0F * half});
    }
    return area;
}

/// Pixels of the lever arms that a box would hide.
float hidden_arms(const Box& box, const std::vector<SceneLabel>& labels) {
    float hidden = 0.0F;
    for (const SceneLabel& label : labels) {
        // The part of the way from 0 to 1 that lies within the box.
        float begin = 0.0F;
        float end = 1.0F;
        const std::array<float, 2> low{box.x, box.y};
        const std::array<float, 2> high{box.right(), box.bottom()};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const float from = label.arm_from[axis];
            const float way = label.arm_to[axis] - from;
            if (way == 0.0F) {
                end = from > low[axis] && from < high[axis] ? end : begin;
                continue;
            }
            const float a = (low[axis] - from) / way;
            const float b = (high[axis] - from) / way;
            begin = std::max(begin, std::min(a, b));
            end = std::min(end, std::max(a, b));
        }
        hidden += std::max(end - begin, 0.0F) * std::hypot(label.arm_to[0] - label.arm_from[0],
                                                           label.arm_to[1] - label.arm_from[1]);
    }
    return hidden;
}

/// Places around a circle, the best first. A force's words stand left of its arrow, or under or over it.
std::array<Box, 6> candidates(const SceneLabel& label, float width, float height, float away) {
    const float x = label.middle_px[0];
    const float y = label.middle_px[1];
    const float off = label.radius_px + away;
    const Box right{x + off, y - 0.5F * height, width, height};
    const Box left{x - off - width, y - 0.5F * height, width, height};
    const Box below{x - 0.5F * width, y + off, width, height};
    const Box above{x - 0.5F * width, y - off - height, width, height};
    const Box lower_right{x + 0.7F * off, y + 0.7F * off, width, height};
    const Box upper_right{x + 0.7F * off, y - 0.7F * off - height, width, height};
    if (label.is_force) {
        const Box& arrow = label.covers;
        const bool long_one = arrow.width > 0.0F;
        const Box at_foot{below.x, long_one ? std::max(below.y, arrow.bottom()) : below.y, width,
                          height};
        const Box at_head{above.x, long_one ? std::min(above.y, arrow.y - height) : above.y, width,
                          height};
        return {left, right, at_foot, at_head, lower_right, upper_right};
    }
    return {right, left, below, above, lower_right, upper_right};
}

/// Beside its own thing alone, where that is possible; else over others as little as may be. None
/// where everything is taken.
std::optional<Box> find_room(const SceneLabel& label, const std::vector<SceneLabel>& labels,
                             const std::vector<Box>& taken, const Box& hand, float width,
                             float height, const Measure& measure) {
    std::optional<Box> room;
    float least = std::numeric_limits<float>::max();
    for (const Box& box : candidates(label, width, height, measure.px(kAway))) {
        const bool free = std::none_of(taken.begin(), taken.end(),
                                       [&](const Box& other) { return box.meets(other); });
        const float area = label.is_force
                               ? hidden_arms(box, labels)  // it belongs to what it stands on
                               : area_over_others(box, labels, label, measure.px(2.0F * kAway)) +
                                     common_area(box, hand);
        if (free && area < least && inside(box, measure)) {
            least = area;
            room = box;
        }
    }
    return room;
}

}  // namespace

std::vector<PlacedLabel> place_labels(const std::vector<SceneLabel>& labels, std::vector<Box> taken,
                                      Font& font, const Measure& measure, const Box& hand) {
    std::vector<PlacedLabel> placed;
    for (const SceneLabel& label : labels) {
        if (label.covers.width > 0.0F) {
            taken.push_back(label.covers);
        }
    }
    const auto try_to_place = [&](const SceneLabel& label) {
        ParagraphSettings settings;
        settings.size_px = measure.text_px(kSmallText);
        settings.width_px = measure.px(kWidest);
        settings.most_lines = 2;
        PlacedLabel result;
        result.words = set_text(font, plain_text(label.text), settings);
        result.label = label;
        const float width =
            result.words.width_px +
            measure.px(2.0F * kLabelPadX + (label.is_force ? kLabelIconRoom : 0.0F));
        const float height = result.words.height_px + measure.px(2.0F * kLabelPadY);
        const auto room = find_room(label, labels, taken, hand, width, height, measure);
        if (room) {
            result.box = *room;
            taken.push_back(*room);
            placed.push_back(std::move(result));
        }
    };
    for (const bool forces : {true, false}) {
        for (std::size_t i = 0; i < std::min(labels.size(), kMostLabels); ++i) {
            if (labels[i].is_force == forces && !labels[i].text.empty()) {
                try_to_place(labels[i]);
            }
        }
    }
    return placed;
}

std::vector<Box> labelled_boxes(const std::vector<SceneLabel>& labels) {
    std::vector<Box> boxes;
    for (const SceneLabel& label : labels) {
        const Box middle{label.middle_px[0], label.middle_px[1], 0.0F, 0.0F};
        boxes.push_back(label.is_force ? label.covers : middle.grown(label.radius_px));
    }
    return boxes;
}

void draw_labels(const std::vector<PlacedLabel>& labels, const Measure& measure, DrawList& list) {
    for (const PlacedLabel& placed : labels) {
        const Box& box = placed.box;
        const float radius = measure.px(0.5F * kSmallText);
        list.shadow_box({box.x, box.y + measure.px(2.0F), box.width, box.height}, radius,
                        measure.px(8.0F), with_alpha(list.colours().ink, 0.20F));
        list.fill_box(box, radius, list.colours().paper);
        draw_edge(list, box, measure, radius);
        float x = box.x + measure.px(kLabelPadX);
        if (placed.label.is_force) {
            draw_arrow_icon(list, {x + measure.px(kLabelIcon - 4.0F), box.middle_y()},
                            measure.px(kLabelIcon), placed.label.direction,
                            colour_of(placed.label.look));
            x += measure.px(kLabelIconRoom);
        }
        list.text(placed.words, x, box.middle_y() - 0.5F * placed.words.height_px, 0.0F, 0.0F,
                  list.colours().ink, list.colours().emphasis_ink);
    }
}

}  // namespace fulcrum::runtime
