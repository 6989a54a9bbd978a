#include "runtime/lesson/free_english.h"

#include "dialogue/checking/grammar_words.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/noun.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

namespace fulcrum::runtime {
namespace {

// Of "wooden block" what comes last is the thing; the Sun has a name.
void add_thing(std::string_view called, std::vector<std::string>& things) {
    std::string noun(called.substr(called.rfind(' ') + 1));
    if (!noun.empty() && noun == dialogue::lower_case(noun) &&
        std::find(things.begin(), things.end(), noun) == things.end()) {
        things.push_back(std::move(noun));
    }
}

// "stone|rock": one thing by several names.
void add_each(std::string_view alternatives, std::vector<std::string>& things) {
    while (!alternatives.empty()) {
        const std::size_t bar = std::min(alternatives.find('|'), alternatives.size());
        add_thing(alternatives.substr(0, bar), things);
        alternatives.remove_prefix(std::min(bar + 1, alternatives.size()));
    }
}

/// What is measured, not held: "weight is in newtons" is as good as "the weight is in newtons".
bool is_measure(std::string_view word) {
    return dialogue::is_measured(word) || word == "force" || word == "speed";
}

constexpr auto kArticles =
    std::to_array<std::string_view>({"the", "a", "an", "my", "your", "its", "our", "this", "that"});

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Where the bracket opens in whose choices `end` stands, or before which a choice ends there.
std::size_t find_opening(std::string_view text, std::size_t end) {
    int depth = 1;
    while (end > 0 && depth > 0) {
        --end;
        depth += text[end] == ')' ? 1 : (text[end] == '(' ? -1 : 0);
    }
    return end;
}

/// An article stands before `at` in a template, whichever choices are taken: "the (line|string)", "(my|the) hand"; not where it may
/// be left out. `or_no`: "no" will do. As deep as brackets are. NOLINTBEGIN(misc-no-recursion)
bool has_article(std::string_view text, std::size_t at, bool or_no) {
    while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '(')) {
        --at;
    }
    if (at == 0) {
        return false;
    }
    if (text[at - 1] == '|') {
        return has_article(text, find_opening(text, at - 1), or_no);
    }
    if (text[at - 1] == ')') {
        const std::size_t opening = find_opening(text, at - 1);
        for (std::size_t end = at - 1; end > opening;) {
            if (!has_article(text, end, or_no)) {
                return false;
            }
            end = text.rfind('|', end - 1);
            end = end == std::string_view::npos || end < opening ? opening : end;
        }
        return true;
    }
    std::size_t begin = at;
    while (begin > 0 && is_letter(text[begin - 1])) {
        --begin;
    }
    const std::string_view word = text.substr(begin, at - begin);
    return std::ranges::find(kArticles, word) != kArticles.end() || (or_no && word == "no");
}
// NOLINTEND(misc-no-recursion)

/// Each of the answers that says {name} has an article before it, or "no": "at the {place}", "a {missing}".
bool takes_article(const QuestionDescription& question, const std::string& name) {
    const std::string slot = "{" + name + "}";
    bool any = false;
    for (const std::string& answer : question.answers) {
        for (std::size_t at = answer.find(slot); at != std::string::npos;
             at = answer.find(slot, at + 1)) {
            if (!has_article(answer, at, true)) {
                return false;
            }
            any = true;
        }
    }
    return any;
}

/// By word: an article each time.
using Determined = std::map<std::string, bool, std::less<>>;

/// Counts the words of `text`, a template or what a list says without an article.
void add_words(std::string_view text, bool in_template, Determined& always) {
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && is_letter(text[end])) {
            ++end;
        }
        if (end > at) {
            bool& has = always.emplace(text.substr(at, end - at), true).first->second;
            has = has && in_template && has_article(text, at, false);
        }
        at = std::max(end, at + 1);
    }
}

void add_words(const QuestionDescription& question, Determined& always) {
    for (const std::string& answer : question.answers) {
        add_words(answer, true, always);
    }
    for (const auto& [name, rule] : question.rules) {
        add_words(rule, true, always);
    }
    for (const auto& [name, words] : question.lists) {
        if (!takes_article(question, name)) {
            for (const std::string& word : words) {
                add_words(word, false, always);
            }
        }
    }
}

/// Nouns that stand in a lesson's answers and rules as they are, and never without an article: "the line", "the (pole|axis)".
void add_told(const LessonDescription& lesson, std::vector<std::string>& things) {
    Determined always;
    for (const QuestionDescription& question : lesson.questions) {
        add_words(question, always);
    }
    for (const auto& [word, has] : always) {
        if (has && word.size() > 2 && !dialogue::describes(word) && !dialogue::is_mass_noun(word) &&
            !is_measure(word)) {
            add_thing(word, things);
        }
    }
}

}  // namespace

namespace {

Expected<std::shared_ptr<dialogue::EnglishChecker>> open_checker(std::vector<std::string> things,
                                                                 dialogue::GrammarOpens when) {
    auto lexicon = dialogue::Lexicon::open();
    if (!lexicon) {
        return fail(lexicon.error().message, {}, {});
    }
    auto judge = dialogue::make_link_judge(when);
    if (!judge) {
        return fail(judge.error().message, {}, {});
    }
    auto checker =
        std::make_shared<dialogue::EnglishChecker>(std::move(*lexicon), std::move(*judge));
    checker->set_things(std::move(things));
    return checker;
}

}  // namespace

Expected<dialogue::FormCheck> open_free_english(std::vector<std::string> things,
                                                dialogue::GrammarOpens when) {
    auto checker = open_checker(std::move(things), when);
    if (!checker) {
        return tl::unexpected(checker.error());
    }
    return [checker = *checker](std::string_view text) { return checker->advise(text); };
}

Expected<dialogue::FormCheck> open_english_review(std::vector<std::string> things) {
    auto checker = open_checker(std::move(things), dialogue::GrammarOpens::at_once);
    if (!checker) {
        return tl::unexpected(checker.error());
    }
    return [checker = *checker](std::string_view text) { return checker->review(text); };
}

std::vector<std::string> things_of(const LessonDescription& lesson) {
    std::vector<std::string> things;
    for (const BodyDescription& body : lesson.bodies) {
        add_thing(body.noun, things);
    }
    for (const QuestionDescription& question : lesson.questions) {
        for (const auto& [name, words] : question.lists) {
            const bool thing = name == "thing";
            const bool one_of = !thing && takes_article(question, name);
            for (const std::string& alternatives : words) {
                if (thing) {
                    add_each(alternatives, things);
                } else if (
                    one_of) {  // the word that it is called by first; "top" of "pole|top" stands in "on top"
                    const std::string called = alternatives.substr(0, alternatives.find('|'));
                    // "A {size} tail": "longer" is no thing.
                    if (!is_measure(called) && !dialogue::describes(called)) {
                        add_thing(called, things);
                    }
                }
            }
        }
    }
    add_told(lesson, things);
    return things;
}

}  // namespace fulcrum::runtime
