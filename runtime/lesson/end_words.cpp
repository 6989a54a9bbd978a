#include "runtime/lesson/end_words.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMostWords = 3;  // that are named

std::string say_answers(const SessionResult& result, const dialogue::Catalogue& catalogue) {
    const int of = result.questions;
    const int right = result.right_at_first;
    const dialogue::CatalogueSlots slots{{"right", std::to_string(right)},
                                         {"of", std::to_string(of)}};
    if (of == 0) {
        return catalogue.say("end.no_question");
    }
    if (of == 1) {
        return catalogue.say(right == 1 ? "end.one_right" : "end.one_later");
    }
    return catalogue.say(right == of  ? "end.all_right"
                         : right == 0 ? "end.none_right"
                                      : "end.some_right",
                         slots);
}

std::string say_practice(const std::vector<std::string>& to_practise,
                         const dialogue::Catalogue& catalogue) {
    std::string words;
    for (std::size_t i = 0; i < std::min(to_practise.size(), kMostWords); ++i) {
        words += (i == 0 ? "" : ", ") + to_practise[i];
    }
    words += to_practise.size() > kMostWords ? " …" : "";
    return catalogue.say_counted("end.practise", static_cast<long>(to_practise.size()),
                                 {{"n", std::to_string(to_practise.size())}, {"words", words}});
}

}  // namespace

std::string explain_stars(const SessionResult& result, int best_before,
                          const dialogue::Catalogue& catalogue) {
    std::string words;
    if (best_before >= 0 && result.stars > best_before) {
        words = catalogue.say("end.best") + " ";
    }
    words += say_answers(result, catalogue);
    if (!result.to_practise.empty()) {
        words += " " + say_practice(result.to_practise, catalogue);
    }
    return words;
}

std::optional<KnownLesson> find_next_lesson(const std::vector<KnownLesson>& lessons,
                                            const std::string& played) {
    const auto here = std::ranges::find(lessons, played, &KnownLesson::name);
    const auto is_new = [](const KnownLesson& lesson) { return lesson.stars < 0; };
    if (here == lessons.end()) {
        return std::nullopt;
    }
    if (const auto later = std::find_if(here + 1, lessons.end(), is_new); later != lessons.end()) {
        return *later;
    }
    const auto earlier = std::find_if(lessons.begin(), here, is_new);
    return earlier != here ? std::optional(*earlier) : std::nullopt;
}

}  // namespace fulcrum::runtime
