// The panels over the scene: lesson and level, score, caption, feedback, input, stars, banner.
//
//   top     [level, title]               [buttons] [star, score]
//           [banner across]
//                     [feedback]
//           [why the force is felt]                [or here, when it would hide the hand]
//   middle            [stars at the end]
//                     [feedback, when it would hide the hand above]
//   bottom            [caption] / [choice] / … / [input]
//
// Thread: one (it asks the font). Cost: setting the words, each frame.
#pragma once

#include "runtime/render/overlay/buttons.h"
#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/overlay/measure.h"
#include "runtime/render/overlay/why_panel.h"
#include "runtime/scene/view.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// One panel and the words in it.
struct Panel {
    Box box;
    Paragraph words;
    Paragraph second;  ///< a line below, may be empty
};

/// Which panels have moved away from the hand, from frame to frame: they stay where they are until the hand comes there.
struct MovedPanels {
    std::string said;
    bool feedback_is_low = false;  ///< above the bottom's panels instead of below the top row
    bool why_is_right = false;     ///< on the right instead of on the left
};

/// Where the panels are; those that are not shown have no width.
struct PanelLayout {
    Panel banner;
    Panel level;
    Panel score;
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
};

/// Sets all words and finds room for each panel. In the menu there are only banner, caption and
/// feedback. `hand` is where the hand is seen, empty when it is not, and `before` the last frame's.
[[nodiscard]] PanelLayout lay_out_panels(const View& view, Font& font, const Measure& measure,
                                         const Box& hand = {}, const MovedPanels& before = {});

/// Where a choice's picture belongs.
[[nodiscard]] Box choice_picture(const Panel& panel, const Measure& measure);
/// The papers of the choices, on which their pictures lie; before `draw_panels`.
void draw_choice_papers(const View& view, const PanelLayout& layout, const Measure& measure,
                        DrawList& list);

/// Draws what was laid out.
void draw_panels(const View& view, const PanelLayout& layout, const Measure& measure,
                 DrawList& list);

}  // namespace fulcrum::runtime
