// The page on which a learner chooses how it looks and sounds: a card for each setting, with its sign, name and step, and one that leads back.
// Arrows and the mouse choose a card, return or a click takes its next step, which is seen and heard at once; F4 and Escape lead back too. What
// was changed is kept with the learner when the page is left; a guest's holds until somebody else plays.
//
// Thread: that of the window.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/app/card_picker.h"
#include "runtime/progress/store.h"

#include <string>

namespace fulcrum::runtime {

/// The page as a picture, of the settings that may be set.
[[nodiscard]] View settings_view(const Desktop& desktop, const MenuChoice& choice,
                                 const dialogue::Catalogue& catalogue);

class SettingsPage {
  public:
    /// Everything given outlives the page.
    SettingsPage(Desktop& desktop, ProgressStore& store, const dialogue::Catalogue& catalogue,
                 std::string learner);

    /// What was done in a frame; false when the page is left, and what was chosen is kept.
    [[nodiscard]] bool take(const WindowEvents& events);
    [[nodiscard]] View view() const { return settings_view(desktop_, choice_, catalogue_); }
    /// Shows it until it is left; false when the window was closed.
    [[nodiscard]] bool show();

  private:
    void keep();

    Desktop& desktop_;
    ProgressStore& store_;
    const dialogue::Catalogue& catalogue_;
    std::string learner_;  // empty: a guest
    ScreenSettings before_;
    MenuChoice choice_;
    double wheel_ = 0.0;
};

}  // namespace fulcrum::runtime
