// The panels over the scene: lesson and level, score, caption, feedback, input, stars, banner.
//
//   top     [level, title]               [buttons] [star, score]
//           [lights]
//           [banner across; a notice narrow on the left or right, or above the bottom's, when it would hide anything]
//                     [feedback]
//           [why the force is felt]                [or here, when it would hide the hand]
//   middle            [stars at the end]
//                     [feedback, when it would hide the hand above]
//   bottom            [caption] / [choices, in two columns where more than two] / [input]
//                     caption and choices, each of them, stand below the top row instead when they would hide the hand or more things
//
// Thread: one (it asks the font). Cost: setting the words, each frame.
#pragma once

#include "runtime/render/overlay/buttons.h"
#include "runtime/render/overlay/choice_panels.h"
#include "runtime/render/overlay/why_panel.h"
#include "runtime/scene/view.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Where a notice stands.
enum class BannerPlace : std::uint8_t { across_top, left, right, across_bottom };

/// Which panels have moved away from the hand, from frame to frame: they stay where they are until the hand comes there.
struct MovedPanels {
    std::string said;
    bool feedback_is_low = false;  ///< above the bottom's panels instead of below the top row
    bool why_is_right = false;     ///< on the right instead of on the left
    std::string notice{};
    BannerPlace notice_place = BannerPlace::across_top;
    std::string caption{};
    bool caption_is_high = false;  ///< below the top row instead of above the input
    std::vector<std::string>
        choices{};  ///< what they said; so long they stay, or no pointer would ever come to one
    bool choices_are_high = false;
};

/// Where the panels are; those that are not shown have no width.
struct PanelLayout {
    Panel banner;
    Panel level;
    Panel score;
    Panel lights;  ///< how many bodies are lit
    Panel feedback;
    Panel caption;
    Panel input;
    std::vector<Panel> choices;  ///< as the view's
    Panel stars;
    std::vector<Box> buttons;  ///< as the view's
    WhyLayout why;
    MovedPanels moved;  ///< for the next frame

    /// The boxes of all that are shown.
    [[nodiscard]] std::vector<Box> shown() const;
    /// The same without the buttons, which stand beside the menu's headline.
    [[nodiscard]] std::vector<Box> papers() const;
};

/// Sets all words and finds room for each panel. In the menu there are only banner, caption,
/// feedback and buttons. `hand` is where the hand is seen, empty when it is not, `things` what else is better not hidden, and `before` the
/// last frame's.
[[nodiscard]] PanelLayout lay_out_panels(const View& view, Font& font, const Measure& measure,
                                         const Box& hand = {}, const MovedPanels& before = {},
                                         const std::vector<Box>& things = {});

}  // namespace fulcrum::runtime
