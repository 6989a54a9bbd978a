#include "dialogue/marking/mark_answer.h"
#include "runtime/audio/voice/voice_program.h"
#include "runtime/lesson/hand_fit.h"
#include "runtime/lesson/learner_feedback.h"
#include "runtime/lesson/learner_model.h"
#include "runtime/lesson/learner_settings.h"
#include "runtime/lesson/learner_throat.h"
#include "runtime/lesson/simulated_pupil.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <cstdio>

using namespace fulcrum::runtime::test;

namespace {

dialogue::Question heaviest() {
    return value_of(
        dialogue::compile_question({"heaviest",
                                    "Which one is the heaviest?",
                                    {"[a|an|the] {thing} is the <superlative:heavy> [one]"},
                                    {{"thing", {"watermelon", "apple", "banana", "egg"}}}}));
}

Expected<bool> is_watermelon(const AnswerSlots& slots) {
    return slots == AnswerSlots{{"thing", "watermelon"}};
}

/// How many of 400 answers are right, wrong, right with an error of form, and not understood.
struct Counts {
    int right = 0;
    int wrong = 0;
    int form = 0;
    int unclear = 0;
};

Counts count(const LearnerRates& rates) {
    LearnerModel model(rates, 7);
    const dialogue::Question question = heaviest();
    Counts counts;
    for (int i = 0; i < 400; ++i) {
        const auto said = value_of(model.answer(question, is_watermelon));
        const dialogue::Mark mark = dialogue::mark_answer(question, said);
        if (!mark.understood) {
            ++counts.unclear;
        } else if (!*is_watermelon(mark.slots)) {
            ++counts.wrong;
        } else {
            ++(mark.form_right() ? counts.right : counts.form);
        }
    }
    return counts;
}

constexpr auto recast = dialogue::FeedbackStep::recast;
constexpr auto rule = dialogue::FeedbackStep::rule;
using Ladder = dialogue::FeedbackLadder;

const LearnerId kMina = random_record_id();
const LearnerId kTom = random_record_id();

SessionRecord session_of(const LearnerId& learner,
                         std::vector<std::pair<std::string, std::string>> settings) {
    return {random_record_id(), learner, "gravity", "", "", 0, std::move(settings)};
}

Expected<bool> anything(const AnswerSlots&) {
    return true;
}

std::optional<std::string> answer(SimulatedPupil& pupil, double asked_at_s, double now_s) {
    const auto question =
        value_of(fulcrum::dialogue::compile_question({"q", "Which?", {"an egg"}}));
    return value_of(pupil.answer(asked_at_s, now_s, question, anything));
}

}  // namespace

TEST_CASE("learner model: who makes no mistakes is always right") {
    CHECK(count({}).right == 400);
}

TEST_CASE("learner model: mistakes come as often as the rates say") {
    const Counts counts = count({.wrong = 0.2, .form = 0.3, .unclear = 0.1});
    // Four standard deviations of 400 draws: 4 sqrt(400 p (1 - p)).
    CHECK(std::abs(counts.wrong - 80) < 32);
    CHECK(std::abs(counts.form - 120) < 37);
    CHECK(std::abs(counts.unclear - 40) < 24);
    CHECK(count({.wrong = 1.0}).wrong == 400);
    CHECK(count({.form = 1.0}).form == 400);
}

TEST_CASE("learner model: the same seed says the same, another seed something else") {
    const auto said = [](std::uint64_t seed) {
        LearnerModel model({.wrong = 0.3, .form = 0.5}, seed);
        const dialogue::Question question = heaviest();
        std::string all;
        for (int i = 0; i < 20; ++i) {
            all += *model.answer(question, is_watermelon) + '\n';
        }
        return all;
    };
    CHECK(said(1) == said(1));
    CHECK(said(1) != said(2));
}

TEST_CASE("learner model: where nothing is right it gives up; a lesson's error is passed on") {
    LearnerModel model({}, 1);
    const auto gives_up = value_of(
        model.answer(heaviest(), [](const AnswerSlots&) { return Expected<bool>(false); }));
    CHECK(gives_up == "I don't know");
    CHECK(error_of(model.answer(heaviest(), [](const AnswerSlots&) -> Expected<bool> {
              return fail("it broke");
          })).message == "it broke");
}

TEST_CASE("throat: the learner's newest counts, and of one session what was heard in it") {
    ProgressData data;
    CHECK_FALSE(find_throat(data, kMina));
    data.sessions = {session_of(kMina, {{"felt_scale", "1.9"}}),
                     session_of(kMina, {{kThroat, "1.50"}})};
    CHECK(find_throat(data, kMina) == 1.5);
    data.sessions.push_back(session_of(kMina, {{kThroat, "1.50"}, {kThroatHeard, "1.20"}}));
    data.sessions.push_back(session_of(kTom, {{kThroatHeard, "1.00"}}));
    data.sessions.push_back(session_of(kMina, {}));
    CHECK(find_throat(data, kMina) == 1.2);
    CHECK(find_throat(data, kTom) == 1.0);
}

TEST_CASE("learner's feedback: the newest that was chosen counts, for this learner alone") {
    ProgressData data;
    CHECK(find_feedback(data, kMina).empty());
    data.sessions = {session_of(kMina, {{kFeedback, "rule"}}),
                     session_of(kTom, {{kFeedback, "recast"}}),
                     session_of(kMina, {{kFeedback, "recast,rule"}}),
                     session_of(kMina, {})};  // played once more, and nothing was chosen
    CHECK(find_feedback(data, kMina) == Ladder{recast, rule});
    CHECK(find_feedback(data, kTom) == Ladder{recast});
    data.sessions.push_back(session_of(kMina, {{kFeedback, feedback_text({})}}));
    CHECK(find_feedback(data, kMina).empty());
}

TEST_CASE("throat, learner's feedback: what could be none is passed over") {
    ProgressData data;
    data.sessions = {
        session_of(kMina, {{kThroatHeard, "1.35"}, {kFeedback, feedback_text({recast})}})};
    for (const char* odd : {"", "nan", "inf", "0.9", "2.1", "-1", "1.2x", "one", "1,2"}) {
        data.sessions.push_back(session_of(kMina, {{kThroatHeard, odd}}));
    }
    for (const char* odd : {"", ",", "recast,", "recat", "RULE", "recast rule", "1",
                            "rule,rule,rule,rule,rule,rule,rule,rule,rule"}) {
        data.sessions.push_back(session_of(kMina, {{kFeedback, odd}}));
    }
    CHECK(find_throat(data, kMina) == 1.35);
    CHECK(find_feedback(data, kMina) == Ladder{recast});
    for (const double throat : {1.0, 1.2, 1.35, 2.0}) {
        data.sessions.push_back(session_of(kMina, {{kThroat, throat_text(throat)}}));
        CHECK(find_throat(data, kMina) == throat);
    }
}

TEST_CASE("throat, learner's feedback: read from the store; from an unreadable one there is none") {
    MemoryStore store;
    const Learner mina{kMina, "Mina", 1};
    store.data.sessions = {session_of(kMina, {{kThroatHeard, "1.20"}, {kFeedback, "rule"}})};
    CHECK(read_throat(store, mina) == 1.2);
    CHECK(read_feedback(store, mina) == Ladder{rule});
    const auto nothing = make_null_store();
    CHECK_FALSE(read_throat(*nothing, mina));
    CHECK(read_feedback(*nothing, mina).empty());
}

TEST_CASE("settings: the learner's newest are kept, each by itself, and those of nobody else") {
    MemoryStore store;
    ScreenSettings chosen;
    chosen.set(SettingKind::text_size, 2);
    chosen.set(SettingKind::sound, 0);
    chosen.set(SettingKind::hand, 1);
    REQUIRE(keep_settings(store, "Mina", {}, chosen));
    REQUIRE(store.data.hands.size() == 3);  // what was not changed is none
    const LearnerId mina = store.data.hands[0].learner;
    CHECK(find_settings(store.data, mina) == chosen);
    CHECK(find_settings(store.data, kTom) == ScreenSettings{});
    // The hand is what --handed keeps.
    CHECK(find_fit(store.data, mina, "mouse").fit.left_handed == true);
    CHECK(find_fit(store.data, mina, "mouse").notices.empty());
    // Back to the usual.
    store.data.hands.push_back({random_record_id(), mina, "screen", "text", "usual", 0});
    chosen.set(SettingKind::text_size, 0);
    CHECK(find_settings(store.data, mina) == chosen);
    for (const char* odd : {"", "huge", "USUAL", "2", "off"}) {
        store.data.hands.push_back({random_record_id(), mina, "screen", "text", odd, 0});
    }
    store.data.hands.push_back({random_record_id(), mina, "mouse", "text", "large", 0});
    CHECK(find_settings(store.data, mina) == chosen);
}

TEST_CASE("settings: who has chosen nothing has what is usual here, and may choose otherwise") {
    MemoryStore store;
    ScreenSettings usual;
    usual.set(SettingKind::language, static_cast<int>(Language::korean));
    CHECK(find_settings(store.data, kTom, usual) == usual);
    ScreenSettings english = usual;
    english.set(SettingKind::language, static_cast<int>(Language::english));
    REQUIRE(keep_settings(store, "Mina", usual, english));
    REQUIRE(store.data.hands.size() == 1);
    CHECK(store.data.hands[0].name == "language");
    CHECK(store.data.hands[0].value == "en");
    CHECK(find_settings(store.data, store.data.hands[0].learner, usual) == english);
}

TEST_CASE("settings: nothing is kept of a guest, nor of what stayed as it was") {
    MemoryStore store;
    ScreenSettings chosen;
    chosen.go_on(SettingKind::contrast);
    REQUIRE(keep_settings(store, "", {}, chosen));
    REQUIRE(keep_settings(store, "Mina", chosen, chosen));
    CHECK(store.data.hands.empty());
    CHECK_FALSE(read_settings(store, ""));
    CHECK(read_settings(store, "Mina") == ScreenSettings{});
    store.refusals = 2;
    CHECK_FALSE(keep_settings(store, "Mina", {}, chosen));
}

TEST_CASE("settings: each goes through its steps and begins again") {
    for (const SettingRow& row : kScreenSettings) {
        ScreenSettings settings;
        CHECK(settings.step(row.kind) == row.usual);
        for (int i = 1; i <= row.n_steps; ++i) {
            settings.go_on(row.kind);
            CHECK(settings.step(row.kind) == (row.usual + i) % row.n_steps);
            settings.set(row.kind, row.n_steps);
            settings.set(row.kind, -1);
            CHECK(settings.step(row.kind) == (row.usual + i) % row.n_steps);
        }
        CHECK(settings == ScreenSettings{});
    }
    ScreenSettings usual;
    CHECK(usual.volume() == 1.0);
    CHECK(usual.voice_speed() == VoiceSettings{}.speed);
    CHECK(usual.text_scale() == 1.0);
}

TEST_CASE("simulated pupil: thinks first, then says one line a question") {
    SimulatedPupil pupil({"first", "second"}, 1.0);
    CHECK_FALSE(answer(pupil, 10.0, 10.5));
    CHECK(answer(pupil, 10.0, 11.0) == "first");
    CHECK_FALSE(answer(pupil, 10.0, 12.0));
    CHECK_FALSE(answer(pupil, 20.0, 20.9));
    CHECK(answer(pupil, 20.0, 21.5) == "second");
    CHECK_FALSE(answer(pupil, 30.0, 40.0));
}

TEST_CASE("simulated pupil: one who is a model never runs out of answers, and thinks as long") {
    SimulatedPupil pupil(LearnerModel({}, 1), 1.0);
    CHECK_FALSE(answer(pupil, 10.0, 10.5));
    for (const double asked_at_s : {10.0, 20.0, 30.0}) {
        CHECK(answer(pupil, asked_at_s, asked_at_s + 1.0) == "An egg.");
    }
}

TEST_CASE("simulated pupil: what is to be asked comes in its turn, and an open question waits") {
    SimulatedPupil pupil({"first", "?how heavy is it", "?what is this", "second"}, 1.0);
    CHECK(answer(pupil, 10.0, 11.0) == "first");
    CHECK_FALSE(answer(pupil, 12.0, 13.5));
    CHECK(answer(pupil, 12.0, 14.0) == "how heavy is it");
    CHECK_FALSE(answer(pupil, 12.0, 16.0));
    CHECK(pupil.ask(17.0) == "what is this");
    CHECK_FALSE(pupil.ask(30.0));
    CHECK(answer(pupil, 12.0, 18.0) == "second");
    CHECK_FALSE(answer(pupil, 12.0, 30.0));
}

TEST_CASE("simulated pupil: blank lines and remarks in the file are passed over") {
    char path[] = "pupil_XXXXXX";
    const int file = mkstemp(path);
    REQUIRE(file >= 0);
    std::ofstream(path) << "# remark\n\n  a watermelon is the heaviest \r\n\t\nthe egg";
    const auto lines = SimulatedPupil::read_lines(path);
    std::remove(path);
    REQUIRE(lines);
    REQUIRE(lines->size() == 2);
    CHECK((*lines)[0] == "a watermelon is the heaviest");
    CHECK((*lines)[1] == "the egg");
}

TEST_CASE("simulated pupil: a missing file is one sentence with its path") {
    CHECK(error_of(SimulatedPupil::read_lines("no/such/file.txt")).where == "no/such/file.txt");
}
