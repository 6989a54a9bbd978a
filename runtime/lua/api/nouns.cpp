#include "runtime/lua/api/nouns.h"

#include <algorithm>
#include <cctype>

namespace fulcrum::runtime {
namespace {

std::string_view without_blanks(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
    text.remove_prefix(begin);
    const std::size_t end = text.find_last_not_of(' ');
    return text.substr(0, end == std::string_view::npos ? 0 : end + 1);
}

bool begins_with_word(std::string_view text, std::string_view word) {
    return text.size() > word.size() &&
           std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) {
               return a == std::tolower(static_cast<unsigned char>(b));
           });
}

}  // namespace

std::string_view spoken_noun(std::string_view noun) {
    noun = without_blanks(noun.substr(0, noun.find('|')));
    for (const std::string_view article : {"the ", "a ", "an "}) {
        if (begins_with_word(noun, article)) {
            return without_blanks(noun.substr(article.size()));
        }
    }
    return noun;
}

int count_noun(const LessonDescription& lesson, std::string_view noun) {
    const std::string_view wanted = spoken_noun(noun);
    return static_cast<int>(std::count_if(
        lesson.bodies.begin(), lesson.bodies.end(),
        [&](const BodyDescription& body) { return spoken_noun(body.noun) == wanted; }));
}

std::int32_t body_with_noun(const LessonDescription& lesson, std::string_view noun) {
    if (count_noun(lesson, noun) != 1) {
        return kNoBody;
    }
    const std::string_view wanted = spoken_noun(noun);
    const auto found =
        std::find_if(lesson.bodies.begin(), lesson.bodies.end(),
                     [&](const BodyDescription& body) { return spoken_noun(body.noun) == wanted; });
    return static_cast<std::int32_t>(found - lesson.bodies.begin());
}

}  // namespace fulcrum::runtime
