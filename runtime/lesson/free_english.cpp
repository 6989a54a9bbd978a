#include "runtime/lesson/free_english.h"

#include "dialogue/checking/link_grammar/link_judge.h"
#include "dialogue/english/letters.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

namespace fulcrum::runtime {

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
    const auto add = [&things](std::string_view called) {
        // Of "wooden block" what comes last is the thing; the Sun has a name.
        std::string noun(called.substr(called.rfind(' ') + 1));
        if (!noun.empty() && noun == dialogue::lower_case(noun) &&
            std::find(things.begin(), things.end(), noun) == things.end()) {
            things.push_back(std::move(noun));
        }
    };
    for (const BodyDescription& body : lesson.bodies) {
        add(body.noun);
    }
    for (const QuestionDescription& question : lesson.questions) {
        for (const auto& [name, words] : question.lists) {
            if (name == "thing") {
                for (std::string_view alternatives : words) {
                    for (bool more = true; more;) {
                        const std::size_t bar = alternatives.find('|');
                        add(alternatives.substr(0, bar));
                        more = bar != std::string_view::npos;
                        alternatives.remove_prefix(more ? bar + 1 : 0);
                    }
                }
            }
        }
    }
    return things;
}

}  // namespace fulcrum::runtime
