// The list of lessons in a window, and who plays: as typed there, or as found before (who_screen.h). Its last card leads to somebody else.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/app/card_picker.h"
#include "runtime/app/lesson_cards.h"
#include "runtime/progress/store.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Who plays in a window.
struct MenuPlayer {
    std::string learner{};  ///< nickname; empty: a guest
    std::string guest{};    ///< what the guest is kept as
    bool is_found = false;  ///< before the list, so that no name is typed in it
};

/// How the list was left.
struct LessonPick {
    PickEnd end = PickEnd::closed;
    LessonCard card;  ///< where one was picked
};

/// Shows the list until a lesson is chosen or it is left. Whose name is typed plays; the last card makes the next guest of whoever plays,
/// or leads back to where the player was found.
[[nodiscard]] LessonPick choose_lesson(Desktop& desktop, const std::vector<LessonCard>& cards,
                                       const dialogue::Catalogue& catalogue, ProgressStore& store,
                                       MenuPlayer& player);

/// The list as a picture; for tests and screenshots.
[[nodiscard]] View menu_view(const std::vector<LessonCard>& cards, const MenuChoice& choice,
                             const dialogue::Catalogue& catalogue, const MenuPlayer& player = {},
                             const BestStars& stars = {}, Language language = Language::english);

}  // namespace fulcrum::runtime
