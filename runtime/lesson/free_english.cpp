#include "runtime/lesson/free_english.h"

#include "dialogue/checking/link_grammar/link_judge.h"
#include "dialogue/english/letters.h"

#include <algorithm>
#include <array>
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
constexpr std::array<std::string_view, 9> kMeasured = {
    "weight", "lift", "drag", "tension", "gravity", "torque", "force", "speed", "friction"};

/// Each of the answers that says {name} has an article before it, or "no": "at the {place}", "a {missing}".
bool takes_article(const QuestionDescription& question, const std::string& name) {
    const std::string slot = "{" + name + "}";
    bool any = false;
    for (const std::string& answer : question.answers) {
        for (std::size_t at = answer.find(slot); at != std::string::npos;
             at = answer.find(slot, at + 1)) {
            const std::string_view before = std::string_view(answer).substr(0, at);
            if (!before.ends_with("the ") && !before.ends_with(" a ") &&
                !before.ends_with(" no ") && before != "a ") {
                return false;
            }
            any = true;
        }
    }
    return any;
}

}  // namespace

Expected<dialogue::FormCheck> open_free_english(std::vector<std::string> things) {
    auto lexicon = dialogue::Lexicon::open();
    if (!lexicon) {
        return fail(lexicon.error().message, {}, {});
    }
    auto judge = dialogue::make_link_judge();
    if (!judge) {
        return fail(judge.error().message, {}, {});
    }
    const auto checker =
        std::make_shared<dialogue::EnglishChecker>(std::move(*lexicon), std::move(*judge));
    checker->set_things(std::move(things));
    return [checker](std::string_view text) { return checker->check(text); };
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
                    if (std::ranges::find(kMeasured, called) == kMeasured.end()) {
                        add_thing(called, things);
                    }
                }
            }
        }
    }
    return things;
}

}  // namespace fulcrum::runtime
