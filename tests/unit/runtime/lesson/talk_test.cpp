#include "runtime/lesson/talk.h"

#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("talk: each turn is answered once, in order, and it is known who asked") {
    Talk talk = Talk::build(compile_plan(two_things(), {}, nullptr).value(), words());
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
}
