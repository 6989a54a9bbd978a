// The lessons that are here, as a list or a room shows them: how each calls itself, and how well a learner did in it.
//
// Thread: load path; starts each lesson's process once, or reads the store.
#pragma once

#include "runtime/app/places.h"
#include "runtime/progress/store.h"
#include "runtime/scene/lesson_messages.h"
#include "runtime/scene/screen_settings.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// A lesson as the list shows it.
struct LessonCard {
    std::filesystem::path folder;
    std::string name;  ///< of the folder
    std::string id;    ///< as progress is kept
    std::string title;
    std::map<Language, std::string> home_titles{};  ///< as its own words have it (glosses.h)
    std::string level;                              ///< CEFR
    double minutes = 0.0;
    std::string icon = "sphere";  ///< a model
    std::string error;            ///< why it cannot be loaded; empty when it can
    int order = 0;                ///< 0: it says nothing of it
    bool is_room = false;         ///< others are entered from it; it is not in the list
};

/// The most stars that a learner has had, by a lesson's id.
using BestStars = std::map<std::string, std::int32_t>;

/// Of whoever is called so; nothing for nobody, and where it cannot be read.
[[nodiscard]] BestStars read_best_stars(ProgressStore& store, const std::string& learner);

/// In the lesson of this id; -1: it was never played to its end.
[[nodiscard]] std::int32_t best_in(const BestStars& best, const std::string& id);

/// Loads every lesson once to see how it calls itself; in their order.
[[nodiscard]] std::vector<LessonCard> read_lesson_cards(const Places& places);
/// As they want to stand; those that say nothing of it as they are, behind the others.
void put_in_order(std::vector<LessonCard>& cards);
/// What a room is told of them: not of those that cannot be loaded, nor of rooms.
[[nodiscard]] std::vector<KnownLesson> list_known_lessons(const std::vector<LessonCard>& cards,
                                                          const BestStars& stars);

}  // namespace fulcrum::runtime
