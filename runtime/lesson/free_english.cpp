#include "runtime/lesson/free_english.h"

#include "dialogue/checking/link_grammar/link_judge.h"
#include "dialogue/english/letters.h"

#include <algorithm>
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
            for (const std::string& alternatives : words) {
                if (name == "thing") {
                    add_each(alternatives, things);
                }
            }
        }
    }
    return things;
}

}  // namespace fulcrum::runtime
