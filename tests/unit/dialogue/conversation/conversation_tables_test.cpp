#include "dialogue/conversation/conversation.h"
#include "dialogue/conversation/help.h"
#include "dialogue/conversation/recast.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/table.h"
#include "tests/unit/dialogue/words.h"

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

/// The conversation of the law: each law begins one.
Conversation& conversation_of(const std::string& law) {
    static const Catalogue words = english_words();
    static std::string begun_for;
    static std::unique_ptr<Conversation> talk;
    if (!talk || begun_for != law) {
        talk = std::make_unique<Conversation>(words);
        begun_for = law;
    }
    return *talk;
}

std::string told_of(const Feedback& feedback, Conversation::State state, const std::string& field) {
    constexpr std::array kStates{"idle", "asked", "heard", "invited", "done"};
    const std::map<std::string, std::string> texts{
        {"kind", std::string(name_of(feedback.kind))},
        {"text", feedback.text},
        {"keys", spaced(feedback.keys)},
        {"again", feedback.ask_again ? "asks again" : "goes on"},
        {"repeat", feedback.may_repeat ? "may be repeated" : "said once"},
        {"replay", feedback.replay ? "felt again" : "nothing felt"},
        {"state", kStates.at(static_cast<std::size_t>(state))}};
    return texts.at(field);
}

/// What is said to an answer; "wrong" or "right" is its meaning, behind it stands what is told of the feedback.
std::string respond(TableScene& scene, const std::string& in) {
    Conversation& talk = conversation_of(scene.law);
    const std::vector<std::string> asked = listed(scene.with, " ");
    const Feedback feedback = talk.respond(talk.hear(in), asked.at(0) == "right");
    std::vector<std::string> told;
    for (std::size_t i = 1; i < asked.size(); ++i) {
        told.push_back(told_of(feedback, talk.state(), asked[i]));
    }
    return spaced(told, " | ");
}

std::string answer_anew(TableScene& scene, const std::string& in) {
    conversation_of(scene.law).ask(scene.question());
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
