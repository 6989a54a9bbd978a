// The list of lessons in a window: arrow keys or mouse, return or click.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/app/desktop.h"
#include "runtime/app/places.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// A lesson as the list shows it.
struct LessonCard {
    std::filesystem::path folder;
    std::string name;  ///< of the folder
    std::string title;
    std::string level;  ///< CEFR
    double minutes = 0.0;
    std::string icon;   ///< a model
    std::string error;  ///< why it cannot be loaded; empty when it can
};

/// Loads every lesson once to see how it calls itself.
[[nodiscard]] std::vector<LessonCard> read_lesson_cards(const Places& places);

/// Shows the list until a lesson is chosen; nothing when the learner leaves.
[[nodiscard]] std::optional<LessonCard> choose_lesson(Desktop& desktop,
                                                      const std::vector<LessonCard>& cards,
                                                      const dialogue::Catalogue& catalogue);

/// The list as a picture; for tests and screenshots.
[[nodiscard]] View menu_view(const std::vector<LessonCard>& cards, int selected,
                             const dialogue::Catalogue& catalogue);

}  // namespace fulcrum::runtime
