#include "dialogue/conversation/conversation.h"
#include "dialogue/conversation/help.h"
#include "dialogue/conversation/recast.h"
#include "dialogue/marking/mark_answer.h"
#include "dialogue/partner/own_words.h"
#include "tests/support/english_words.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/table.h"
#include "tests/unit/dialogue/talk.h"

using namespace fulcrum::dialogue;

namespace {

std::string rule(TableScene& scene, const std::string& in) {
    const Mark mark = mark_answer(scene.question(), in);
    REQUIRE(mark.main_error() != nullptr);
    return rule_key(*mark.main_error());
}

std::string key_of_recast(TableScene&, const std::string& in) {
    Mark mark;
    mark.corrected = in;
    return std::string(recast_key(mark));
}

/// "frame: … is the heaviest."
std::string help(TableScene& scene, const std::string& in) {
    const Help help = help_for(scene.question(), std::stoi(in));
    constexpr std::array kKinds{"frame", "example", "choices"};
    CHECK((help.kind == Help::Kind::choices) == help.sentence.empty());
    return kKinds.at(static_cast<std::size_t>(help.kind)) + std::string(": ") + help.sentence +
           spaced(help.choices, ", ");
}

/// A checker that finds one word wrong: `told` as how sure it is.
CheckedText check_word(std::string_view text, const std::string& said, const std::string& right,
                       ErrorCode code, bool proven) {
    CheckedText checked{{}, std::string(text), std::string(text)};
    if (const std::size_t at = text.find(said); at != std::string_view::npos) {
        checked.errors.push_back({code, at, at + said.size(), said, right});
        checked.corrected.replace(at, said.size(), right);
        checked.marked.replace(at, said.size(), '*' + right + '*');
        checked.proven = proven;
    }
    return checked;
}

/// Who checks what fits no answer, by the words behind "checked".
FormCheck form_check(const std::string& name) {
    const std::map<std::string, FormCheck> checks{
        {"nobody", {}},
        {"have",
         [](std::string_view text) {
             return check_word(text, "have", "has", ErrorCode::agreement, true);
         }},
        {"unsure",
         [](std::string_view text) {
             return check_word(text, "have", "has", ErrorCode::agreement, false);
         }},
        {"goed",
         [](std::string_view text) {
             const CheckedText went =
                 check_word(text, "goed", "went", ErrorCode::verb_inflection, true);
             return went.errors.empty()
                        ? check_word(text, "upper", "down", ErrorCode::verb_inflection, false)
                        : went;
         }},
        {"unread",
         [](std::string_view text) {
             return CheckedText{{}, std::string(text), std::string(text)};
         }},
        {"good", [](std::string_view text) {
             CheckedText checked{{}, std::string(text), std::string(text)};
             checked.proven = true;
             return checked;
         }}};
    return checks.at(name);
}

/// The conversation of the law, which begins one, as "@talk ladder prompt,rule; tries 3; unheard 4; checked have" says.
Talk& conversation_of(const TableScene& scene) {
    static const Catalogue words = english_words();
    static std::string begun_for;
    static std::unique_ptr<Talk> talk;
    if (talk && begun_for == scene.law + scene.talk) {
        return *talk;
    }
    begun_for = scene.law + scene.talk;
    ConversationSettings settings;
    FormCheck check;
    for (const std::string& setting : listed(scene.talk, "; ")) {
        const std::size_t blank = setting.find(' ');
        const std::string name = setting.substr(0, blank);
        const std::string value = setting.substr(blank + 1);
        if (name == "ladder") {
            settings.ladder = read_ladder_text(value).value();
        } else if (name == "tries") {
            settings.tries = std::stoi(value);
        } else if (name == "unheard") {
            settings.unheard_tries = std::stoi(value);
        } else {
            REQUIRE(name == "checked");
            check = form_check(value);
        }
    }
    talk = std::make_unique<Talk>(words, settings);
    if (scene.talk.find("checked") != std::string::npos) {
        talk->set_form_check(form_check("have"));  // the next one takes its place
    }
    talk->set_form_check(check);
    return *talk;
}

std::string errors_of(const Said& feedback) {
    std::vector<std::string> told;
    for (const FreeError& error : feedback.free_errors) {
        told.push_back(std::string(errant_code(error.code)) + " at " + std::to_string(error.begin));
    }
    return told.empty() ? "no errors" : spaced(told);
}

std::string told_of(const Mark& mark, const Said& feedback, CourseState state,
                    const std::string& field) {
    constexpr std::array kStates{"idle",    "asked",       "heard", "replaying",
                                 "invited", "heard_again", "left",  "done"};
    const std::map<std::string, std::string> texts{
        {"kind", std::string(name_of(feedback.kind))},
        {"text", feedback.text},
        {"keys", spaced(feedback.keys)},
        {"again", feedback.ask_again ? "asks again" : "goes on"},
        {"repeat", feedback.may_repeat ? "may be repeated" : "said once"},
        {"replay", feedback.replay ? "felt again" : "nothing felt"},
        {"uptake",
         feedback.uptake == Uptake::none ? "none" : std::string(name_of(feedback.uptake))},
        {"attempt", std::to_string(feedback.attempt)},
        {"opposite", mark.opposite_said.empty() ? "no opposite" : "an opposite"},
        {"errors", errors_of(feedback)},
        {"state", kStates.at(static_cast<std::size_t>(state))}};
    return texts.at(field);
}

/// What is said to an answer; "wrong" or "right" is its meaning, behind it stand how sure it was heard, "unformed" where its form
/// was not, and what is told of the feedback.
std::string respond(TableScene& scene, const std::string& in) {
    Talk& talk = conversation_of(scene);
    const std::vector<std::string> asked = listed(scene.with, " ");
    std::size_t i = 1;
    const bool is_told = i < asked.size() && asked[i].front() == '0';
    const double sure = is_told ? std::stod(asked[i++]) : 1.0;
    const bool formed = !(i < asked.size() && asked[i] == "unformed");
    i += formed ? 0 : 1;
    if (talk.state() == CourseState::replaying) {
        talk.ask_again();
    }
    const Mark mark = talk.hear(in, sure, formed);
    const Said feedback = talk.respond(mark, asked.at(0) == "right");
    std::vector<std::string> told;
    for (; i < asked.size(); ++i) {
        told.push_back(told_of(mark, feedback, talk.state(), asked[i]));
    }
    return spaced(told, " | ");
}

std::string answer_anew(TableScene& scene, const std::string& in) {
    conversation_of(scene).ask(scene.question());
    return respond(scene, in);
}

const std::map<std::string, Probe> kConversationProbes{{"rule", rule},
                                                       {"recast_key", key_of_recast},
                                                       {"help", help},
                                                       {"answer", answer_anew},
                                                       {"respond", respond}};

}  // namespace

TEST_CASE("conversation: each answer gets the feedback that the tables say") {
    hold_tables("conversation", kConversationProbes);
}
