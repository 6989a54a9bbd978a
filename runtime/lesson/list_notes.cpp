#include "runtime/lesson/list_notes.h"

#include "dialogue/checking/grammar_words.h"
#include "dialogue/english/common_noun.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/noun.h"
#include "dialogue/template/compile.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kLeastLetters = 3;  // "N" is a unit

bool has_capital(std::string_view word) {
    return !word.empty() && word.front() >= 'A' && word.front() <= 'Z';
}

/// The first word of one way to say an entry, without its article: "Apple" of "the Apple pie".
std::string_view first_word(std::string_view said) {
    const auto trim = [&] {
        said.remove_prefix(std::min(said.find_first_not_of(' '), said.size()));
    };
    trim();
    for (const std::string_view article : {"the ", "an ", "a "}) {
        if (said.starts_with(article)) {
            said.remove_prefix(article.size());
            trim();
        }
    }
    return said.substr(0, said.find_first_of(" |"));
}

/// "Wooden block", where "wooden block" is meant: an adjective that stands before a small word begins no name, as in "Big Ben".
bool describes_small(std::string_view said) {
    const std::string_view word = first_word(said);
    const std::string_view rest = said.substr(0, said.find('|'));
    const std::size_t behind = rest.rfind(word) + word.size();
    const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    return has_capital(word) && dialogue::describes(word) && behind < rest.size() &&
           std::ranges::none_of(rest.substr(behind), is_capital);
}

/// The words with a capital that are no names, in the order of bodies and lists.
class Capitals {
  public:
    explicit Capitals(const dialogue::CommonNouns& nouns) : nouns_(nouns) {}

    void look_at(const BodyDescription& body, std::vector<std::string>& notes) {
        const std::string word(first_word(body.noun));
        if (is_to_be_small(body.noun) && told_.insert(word).second) {
            notes.push_back(tell("lesson.lua:" + std::to_string(body.line) + ": ", word,
                                 "the noun of \"" + body.name + "\""));
        }
    }

    void look_at(const dialogue::NamedLists& lists, const std::string& head,
                 std::vector<std::string>& notes) {
        for (const auto& [name, entries] : lists) {
            for (const std::string& entry : entries) {
                for (std::size_t at = 0; at < entry.size();) {
                    const std::size_t bar = std::min(entry.find('|', at), entry.size());
                    const std::string_view said = std::string_view(entry).substr(at, bar - at);
                    const std::string word(first_word(said));
                    if (is_to_be_small(said) && told_.insert(word).second) {
                        notes.push_back(tell(head, word, "the list \"" + name + '"'));
                    }
                    at = bar + 1;
                }
            }
        }
    }

    [[nodiscard]] bool is_to_be_small(std::string_view said) const {
        return is_common(std::string(first_word(said))) || describes_small(said);
    }

  private:
    [[nodiscard]] bool is_common(const std::string& word) const {
        return has_capital(word) && word.size() >= kLeastLetters &&
               !dialogue::is_planet(dialogue::lower_case(word)) && nouns_.has(word);
    }

    static std::string tell(const std::string& head, const std::string& word,
                            const std::string& where) {
        return head + "\"" + word + "\" in " + where +
               " has a capital, so it is taken for a name, which has no article; write \"" +
               dialogue::lower_case(word) + "\", if it is none.";
    }

    const dialogue::CommonNouns& nouns_;
    std::set<std::string> told_;
};

}  // namespace

LessonDescription with_small_nouns(LessonDescription lesson) {
    const auto nouns = dialogue::CommonNouns::open();
    if (!nouns) {
        return lesson;
    }
    const Capitals capitals(*nouns);
    for (BodyDescription& body : lesson.bodies) {
        if (capitals.is_to_be_small(body.noun)) {
            const std::string word(first_word(body.noun));
            body.noun.replace(body.noun.find(word), word.size(), dialogue::lower_case(word));
        }
    }
    return lesson;
}

std::vector<std::string> list_notes(const LessonDescription& lesson) {
    std::vector<std::string> notes;
    const auto nouns = dialogue::CommonNouns::open();
    if (!nouns) {
        return notes;
    }
    Capitals capitals(*nouns);
    for (const BodyDescription& body : lesson.bodies) {
        capitals.look_at(body, notes);
    }
    const auto line = [](int number) { return "lesson.lua:" + std::to_string(number) + ": "; };
    for (const QuestionDescription& question : lesson.questions) {
        capitals.look_at(question.lists,
                         line(question.line) + "question \"" + question.id + "\": ", notes);
    }
    for (const KnowledgeDescription& known : lesson.knowledge) {
        capitals.look_at(
            known.lists,
            line(known.line) + "what the lesson knows as \"" + known.id + "\": ", notes);
    }
    return notes;
}

}  // namespace fulcrum::runtime
