#include "runtime/lesson/talk.h"

#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

Talk build(PartnerOrder partner, const LessonDescription& lesson = two_things()) {
    PlanOptions options;
    options.partner = std::move(partner);
    return Talk::build(compile_plan(lesson, options, nullptr).value(), words());
}

PartnerOrder program(const std::string& script) {
    return {.kind = PartnerKind::external, .words = {"sh", "-c", script}};
}

/// What is said to the next turn; own words are "own".
std::string answer(Talk& talk) {
    dialogue::Turn turn;
    turn.told = "own";
    talk.take(turn);
    return value_of(talk.poll(0.0)).reply.text;
}

}  // namespace

TEST_CASE("talk: each turn is answered once, in order, and it is known who asked") {
    Talk talk = build({});
    CHECK(talk.is_own());
    CHECK_FALSE(talk.poll(0.0));
    const dialogue::Question question;
    dialogue::Turn turn;
    turn.told = "one";
    talk.take(turn);
    turn.told = "two";
    turn.asked = &question;
    talk.take(turn);
    const auto one = value_of(talk.poll(0.0));
    CHECK(one.reply.text == "one");
    CHECK(one.was_asked);
    const auto two = value_of(talk.poll(0.0));
    CHECK(two.reply.text == "two");
    CHECK_FALSE(two.was_asked);
    CHECK_FALSE(talk.poll(0.0));
    CHECK(talk.take_notes().empty());
    CHECK(talk.take_troubles().empty());
}

TEST_CASE("talk: who talks is the plan's, and another's words are noted by their turn") {
    Talk none = build({.kind = PartnerKind::none});
    CHECK_FALSE(none.is_own());
    CHECK(answer(none).empty());
    CHECK(none.take_notes().empty());

    Talk recorded = build({.kind = PartnerKind::recorded, .recorded = {{2, "Hello.", 0.0}}});
    CHECK(answer(recorded) == "own");
    CHECK(answer(recorded) == "Hello.");
    CHECK(recorded.take_notes() == std::vector<std::string>{"partner 2: Hello."});
    CHECK(recorded.take_notes().empty());

    Talk external =
        build(program("read -r line; echo '{\"turn\":1,\"text\":\"Hi!\"}'; read -r line"));
    CHECK(answer(external) == "Hi!");
    CHECK(answer(external) == "own");
    CHECK(external.take_notes() == std::vector<std::string>{"partner 1: Hi!"});
    CHECK(external.take_troubles().size() == 1);

    Talk missing = build({.kind = PartnerKind::external});
    CHECK(answer(missing) == "own");
    CHECK(missing.take_troubles() ==
          std::vector<std::string>{"Nobody else talks: no program is named; name one."});
    LessonDescription silent = two_things();
    silent.questions.clear();
    CHECK(build({.kind = PartnerKind::external}, silent).take_troubles().empty());  // not started
}

TEST_CASE("talk: a partner's note is read back as it was written, and no other note is one") {
    const auto words = value_of(read_partner_note(partner_note(31, "He says: 3: 4")));
    CHECK(words.turn == 31);
    CHECK(words.text == "He says: 3: 4");
    CHECK(value_of(read_partner_note(partner_note(1, ""))).text.empty());
    for (const char* other : {"", "note", "partner", "partner x: a", "partner 3 a", "partner -1: a",
                              "partner 0: a", "partner 99999999999: a"}) {
        CHECK_FALSE(read_partner_note(other));
    }
}
