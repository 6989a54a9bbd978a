#include "runtime/app/lesson_cards.h"

#include "runtime/app/glosses.h"
#include "runtime/app/installation.h"
#include "runtime/app/lesson_parts.h"
#include "runtime/app/screen_trouble.h"
#include "runtime/lua/process/lesson_process.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace fulcrum::runtime {
namespace {

// What it says, else what the learner will hold, else the first thing there is.
std::string icon_of(const LessonDescription& lesson) {
    if (!lesson.icon.empty()) {
        return lesson.icon;
    }
    const auto movable = std::find_if(lesson.bodies.begin(), lesson.bodies.end(),
                                      [](const BodyDescription& body) { return body.movable; });
    if (movable != lesson.bodies.end()) {
        return movable->model;
    }
    return lesson.bodies.empty() ? "sphere" : lesson.bodies.front().model;
}

std::map<Language, std::string> read_home_titles(const std::filesystem::path& folder) {
    std::map<Language, std::string> titles;
    for (const Language language : kHomeLanguages) {
        if (const auto words = read_lesson_words(folder, language); !words) {
            say(to_sentence(words.error()));
        } else if (words->has("title")) {
            titles[language] = words->say("title");
        }
    }
    return titles;
}

}  // namespace

std::vector<LessonCard> read_lesson_cards(const Places& places) {
    std::vector<LessonCard> cards;
    for (const std::string& name : list_lesson_names(places)) {
        LessonCard card;
        card.name = name;
        card.folder = find_named_lesson(places, name);
        LessonFiles files;
        files.folder = card.folder;
        files.library = places.scripts_lib;
        LessonProcessOptions process_options;
        process_options.waits_on = patience(kLongestWindowWait_s);
        if (const auto process = LessonProcess::start(files, process_options); process) {
            const LessonDescription& lesson = (*process)->description();
            card.id = lesson.id;
            card.order = lesson.order;
            card.title = lesson.title;
            card.home_titles = read_home_titles(card.folder);
            card.level = lesson.level;
            card.minutes = lesson.minutes;
            card.icon = icon_of(lesson);
            card.is_room = lesson.is_room;
        } else {
            card.title = name;
            card.error = to_sentence(process.error());
        }
        cards.push_back(std::move(card));
    }
    put_in_order(cards);
    return cards;
}

void put_in_order(std::vector<LessonCard>& cards) {
    std::ranges::stable_sort(cards, {}, [](const LessonCard& card) {
        return card.order > 0 ? card.order : std::numeric_limits<int>::max();
    });
}

BestStars read_best_stars(ProgressStore& store, const std::string& learner) {
    BestStars best;
    if (learner.empty()) {
        return best;
    }
    const auto kept = store.read({.nickname = learner, .lesson = {}, .results_only = true});
    if (!kept) {
        return best;
    }
    std::map<RecordId, std::string> lesson_of;
    for (const SessionRecord& session : kept->sessions) {
        lesson_of[session.id] = session.lesson;
    }
    for (const SessionEnd& end : kept->ends) {
        if (end.reason == EndReason::finished) {
            std::int32_t& stars = best[lesson_of[end.session]];
            stars = std::max(stars, end.stars);
        }
    }
    return best;
}

std::int32_t best_in(const BestStars& best, const std::string& id) {
    const auto found = best.find(id);
    return found == best.end() ? -1 : found->second;
}

std::vector<KnownLesson> list_known_lessons(const std::vector<LessonCard>& cards,
                                            const BestStars& stars) {
    std::vector<KnownLesson> known;
    for (const LessonCard& card : cards) {
        if (!card.is_room && card.error.empty() && known.size() < kMaxKnownLessons) {
            known.push_back(
                {card.name, card.title, card.level, card.icon, best_in(stars, card.id)});
        }
    }
    return known;
}

}  // namespace fulcrum::runtime
