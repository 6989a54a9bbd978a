// Words beside things in the scene, where they hide neither panels nor each other.
//
// Thread: one (it asks the font). Cost: quadratic in the number of labels, at most kMostLabels.
#pragma once

#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/overlay/measure.h"
#include "runtime/scene/view.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Words, and the circle in the picture that they belong to.
struct SceneLabel {
    Point2 middle_px{};
    float radius_px = 0.0F;
    std::string text;
    bool is_force = false;             ///< gets the sign of an arrow
    ForceLook look = ForceLook::hand;  ///< the colour of that sign
    Box covers{};                      ///< the arrow itself: no label may hide it; empty for things
    Point2 arm_from{};       ///< a torque's lever arm, which labels leave free where they can
    Point2 arm_to{};         ///< the same point: there is none
    Point2 direction{0, 1};  ///< of that arrow in the picture, unit length
};

inline constexpr std::size_t kMostLabels = 64;

/// A label and where it found room.
struct PlacedLabel {
    Box box;
    Paragraph words;
    SceneLabel label;
};

/// Finds room right of, left of, below or above each thing, inside the picture and outside the
/// boxes that are taken, and away from other things, and from where the hand is seen (empty: nowhere), where that is possible; a label
/// without room is left out. Forces come first, then in order.
[[nodiscard]] std::vector<PlacedLabel> place_labels(const std::vector<SceneLabel>& labels,
                                                    std::vector<Box> taken, Font& font,
                                                    const Measure& measure, const Box& hand = {});

/// Where the things and arrows that have words are seen.
[[nodiscard]] std::vector<Box> labelled_boxes(const std::vector<SceneLabel>& labels);

void draw_labels(const std::vector<PlacedLabel>& labels, const Measure& measure, DrawList& list);

}  // namespace fulcrum::runtime
