#include "runtime/lesson/session.h"

#include "dialogue/unicode.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("session: the first frame tells what each thing weighs in the hand") {
    Play play;
    const auto ready = Play::told<ReadyEvent>(play.frame());
    CHECK(ready.felt_weight_N == play.plan.felt_weight_N);
    CHECK(find<ReadyEvent>(play.frame()) == nullptr);
}

TEST_CASE("session: an answer is judged by the lesson, praised, kept, and told to the lesson") {
    Play play;
    play.ask();
    CHECK(play.session->hud().question_open);
    CHECK(play.session->hud().caption == "Which one is the heaviest?");

    const auto judge = Play::told<JudgeEvent>(play.hear("The apple is the heaviest."));
    CHECK(judge.question == "heaviest");
    CHECK(judge.slots == std::vector<std::pair<std::string, std::string>>{{"thing", "apple"}});
    const SessionOutput output = play.reply({VerdictCommand{"heaviest", true}});
    CHECK(output.sounds == std::vector<std::string>{"right"});
    CHECK(play.session->hud().feedback == "Yes!");
    CHECK_FALSE(play.session->hud().question_open);

    const auto answered = Play::told<AnsweredEvent>(play.frame());
    CHECK(answered.right);
    CHECK(answered.form_right);
    CHECK(answered.over);
    REQUIRE(play.store.data.attempts.size() == 1);
    CHECK(play.store.data.attempts[0].meaning_right);
    CHECK(play.store.data.attempts[0].slots == "thing=apple");
    CHECK(play.store.data.attempts[0].session == play.store.data.sessions[0].id);
}

TEST_CASE("session: words that fit no template leave the question open and are kept as such") {
    Play play;
    play.ask();
    const LessonFrame& frame = play.hear("bla bla bla");
    CHECK(find<JudgeEvent>(frame) == nullptr);
    CHECK(play.session->hud().question_open);
    CHECK(play.session->hud().feedback == "Say it again.");
    REQUIRE(play.store.data.attempts.size() == 1);
    CHECK_FALSE(play.store.data.attempts[0].understood);
}

TEST_CASE("session: names that were never declared are the lesson's error; a late verdict is not") {
    Play play;
    play.frame();
    CHECK_FALSE(play.refuses(VerdictCommand{"heaviest", true}));
    LessonReply unknown;
    unknown.commands = {VerdictCommand{"oldest", true}};
    check_says(refusal_of(play.session->finish_frame(unknown)), {"\"oldest\""});
    CHECK(play.refuses(AskCommand{"lightest"}));
    CHECK(play.refuses(FieldChangeCommand{0, {}}));
    CHECK(play.refuses(LessonForceCommand{}));
    MoveCommand drop;
    for (const std::int32_t body : {-1, 2, 1000}) {
        drop.move.body = body;
        CHECK(play.refuses(drop));
    }
    drop.move.body = 1;
    CHECK_FALSE(play.refuses(drop));
}

TEST_CASE("session: what the world did becomes events and sounds") {
    Play play;
    SessionInput input;
    input.world_events = {{WorldEvent::Kind::caught, 0, 1.0, 3.0},
                          {WorldEvent::Kind::landed, 1, 1.0, 4.0}};
    input.hand.touched_body = 1;
    const LessonFrame& frame = play.frame(input);
    int caught = 0;
    int landed = 0;
    int touched = 0;
    for (const LessonEvent& event : frame.events) {
        if (const auto* body = std::get_if<BodyEvent>(&event)) {
            caught += body->kind == BodyEvent::Kind::caught ? 1 : 0;
            landed += body->kind == BodyEvent::Kind::landed ? 1 : 0;
            touched += body->kind == BodyEvent::Kind::touched ? 1 : 0;
        }
    }
    CHECK(caught == 1);
    CHECK(landed == 1);
    CHECK(touched == 1);
    CHECK(play.reply().sounds == std::vector<std::string>{"catch_apple", "landed"});
    CHECK(play.session->result().caught == 1);
}

TEST_CASE("session: where something is caught or answered rightly there is a burst, for a while") {
    Play play;
    SessionInput input;
    WorldSnapshot world;
    world.n_bodies = 2;
    world.bodies[0].pose_W.position = Vector3(0.1, 0.2, 0.3);
    input.world = &world;
    input.world_events = {{WorldEvent::Kind::landed, 1, 1.0, 4.0}};
    play.frame(input);
    CHECK(play.session->hud().bursts.empty());
    input.world_events = {{WorldEvent::Kind::caught, 0, 1.0, 3.0}};
    const double caught_s = play.time_s;
    play.frame(input);
    REQUIRE(play.session->hud().bursts.size() == 1);
    CHECK(play.session->hud().bursts[0].at_W == world.bodies[0].pose_W.position);
    CHECK(play.session->hud().bursts[0].at_s == caught_s);
    play.wait(0.9 * kBurstLasts_s);
    CHECK(play.session->hud().bursts.size() == 1);
    play.wait(0.2 * kBurstLasts_s);
    CHECK(play.session->hud().bursts.empty());

    play.ask();
    CHECK(play.session->hud().mood == ViewMood::calm);
    play.answer("apple is most heavy", false);
    CHECK(play.session->hud().mood == ViewMood::thoughtful);
    CHECK(play.session->hud().bursts.empty());
    play.ask();
    play.answer("apple is most heavy", true);
    CHECK(play.session->hud().mood == ViewMood::happy);
    CHECK(play.session->hud().bursts.size() == 1);
}

TEST_CASE("session: a body is touched from the first hand that comes until the last one leaves") {
    Play play;
    const auto told = [&](std::int32_t first, std::int32_t second) {
        SessionInput input;
        input.hand.touched_body = first;
        input.more_hands.resize(1);
        input.more_hands[0].touched_body = second;
        std::string events;
        for (const LessonEvent& event : play.frame(input).events) {
            if (const auto* body = std::get_if<BodyEvent>(&event)) {
                events += (body->kind == BodyEvent::Kind::touched ? '+' : '-') +
                          std::to_string(body->body);
            }
        }
        (void)play.reply();
        return events;
    };
    CHECK(told(kNoBody, kNoBody).empty());
    CHECK(told(0, kNoBody) == "+0");
    CHECK(told(0, 0).empty());
    CHECK(told(kNoBody, 0).empty());
    CHECK(told(1, 0) == "+1");
    CHECK(told(0, 1).empty());
    CHECK(told(kNoBody, 1) == "-0");
    CHECK(told(0, kNoBody) == "-1+0");
    CHECK(told(kNoBody, kNoBody) == "-0");
}

TEST_CASE("session: the lesson hears where each hand is, and leads each simulated one") {
    Play play;
    SessionInput input;
    input.more_hands.resize(1);
    input.more_hands[0].tool_pose_W.position = {-0.1, 0.2, 0.3};
    input.more_hands[0].applied_W.force = {0.0, 1.5, 0.0};
    const LessonFrame& frame = play.frame(input);
    REQUIRE(frame.more_hands.size() == 1);
    CHECK(frame.more_hands[0].tool_pose_W.position == Vector3(-0.1, 0.2, 0.3));
    CHECK(frame.more_hands[0].applied_W.force == Vector3(0.0, 1.5, 0.0));
    LessonReply reply;
    reply.more_aims = {{true, Pose::at(Vector3(0.0, 0.5, 0.0)), 1}};
    const auto output = value_of(play.session->finish_frame(reply));
    REQUIRE(output.more_aims.size() == 1);
    CHECK(output.more_aims[0].target_W.position == Vector3(0.0, 0.5, 0.0));
    CHECK(play.frame().more_hands.empty());
}

TEST_CASE("session: the end is kept once, with stars and score") {
    Play play;
    play.frame();
    play.reply({ScoreCommand{12}, LevelCommand{2, "two"}, FinishCommand{9}});
    CHECK(play.session->result().finished);
    CHECK(play.session->result().stars == 3);
    play.session->end(EndReason::left);
    REQUIRE(play.store.data.ends.size() == 1);
    CHECK(play.store.data.ends[0].stars == 3);
    CHECK(play.store.data.ends[0].score == 12);
    CHECK(play.store.data.ends[0].level_reached == 2);
    CHECK(play.store.data.ends[0].reason == EndReason::finished);
}

TEST_CASE("session: a write that fails is tried again; a second failure is told, no more") {
    Play play;
    play.ask();
    play.store.refusals = 1;
    play.hear("the apple is the heaviest");
    play.reply({VerdictCommand{"heaviest", true}});
    CHECK(play.store.data.attempts.size() == 1);
    CHECK(play.session->store_trouble().empty());
    play.store.refusals = 2;
    play.session->end(EndReason::left);
    CHECK(play.store.data.ends.empty());
    check_says(play.session->store_trouble(), {"the disk is full"});
}

TEST_CASE("session: every reply has a fresh stamp for the hand; a lesson's own force too") {
    Play play;
    play.time_s = 3.0;
    play.frame();
    const SessionOutput output = play.reply();
    CHECK(output.force.stamp_s == 3.0);
    CHECK(output.force.lesson_alive);
    CHECK(output.force.linearised.stamp_s < 0.0);
}

TEST_CASE("session: whatever bytes are said, the lesson gets clean words") {
    Play play;
    play.frame();
    for (const char* said :
         {"the apple is\x85 the heaviest", "\xC2\x85 apple", "\xFF\xFE", "the \x01\x02 apple"}) {
        play.reply({AskCommand{"heaviest"}});
        const LessonFrame& frame = play.hear(said);
        if (find<JudgeEvent>(frame) != nullptr) {
            play.reply({VerdictCommand{"heaviest", true}});
        }
        for (const LessonEvent& event : play.frame().events) {
            if (const auto* answered = std::get_if<AnsweredEvent>(&event)) {
                CHECK(answered->said.find('\x01') == std::string::npos);
                check_lacks(answered->said, {"\x85"});
            }
        }
    }
    play.reply({AskCommand{"heaviest"}});
    play.hear(std::string(100'000, 'a'));
    CHECK(play.store.data.attempts.back().said.size() <= 400);
}

TEST_CASE(
    "session: an answer is the same however its letters are composed and whatever their case") {
    LessonDescription lesson = two_things();
    lesson.questions[0].answers = {"it is a café"};
    for (const char* said :
         {"it is a café", "it is a cafe\u0301", "IT IS A CAFÉ", "It is a CAFE\u0301."}) {
        CAPTURE(said);
        Play play(lesson);
        play.ask();
        const AnsweredEvent answered = play.answer(said, true);
        CHECK(answered.understood);
        CHECK(answered.said == fulcrum::dialogue::composed(said));
    }
    Play play(lesson);
    play.ask();
    play.hear("it is a cafe");
    REQUIRE(play.store.data.attempts.size() == 1);
    CHECK_FALSE(play.store.data.attempts[0].understood);
}

TEST_CASE("session: of whom the meaning alone is heard the form is not known") {
    const bool form = GENERATE(true, false);
    CAPTURE(form);
    PlanOptions options;
    options.speech = SpeechInput::external;
    options.hearing.words = {"sh", "-c",
                             std::string("echo '{\"ready\":1,\"name\":\"ear\"") +
                                 (form ? "" : ",\"form\":false") +
                                 "}'; while read -r line; do case $line in *end*) echo "
                                 "'{\"heard\":1,\"text\":\"the apple is the "
                                 "heaviest\",\"confidence\":0.9}';; esac; done"};
    Play play(two_things(), options);
    play.ask();
    play.session->hear_utterance(std::vector<std::int16_t>(100, 1));
    REQUIRE(find<JudgeEvent>(play.frame()) != nullptr);
    play.reply({VerdictCommand{"heaviest", true}});
    CHECK((play.session->hud().feedback == "Yes!") == form);
    const auto answered = Play::told<AnsweredEvent>(play.frame());
    CHECK(answered.right);
    CHECK(answered.form_known == form);
    CHECK(answered.form_right == form);
    const AttemptRecord& attempt = play.store.data.attempts.at(0);
    CHECK(attempt.meaning_right);
    CHECK(attempt.form_known == form);
    CHECK(attempt.form_right == form);
    CHECK(attempt.target_right == form);
    CHECK(attempt.confidence == 0.9);
}

TEST_CASE("session: what was said stands beside the sentence that is told for it, where one is") {
    Play play;
    play.ask();
    play.answer("apple is most heavy", false);
    CHECK(play.session->hud().said == "apple is most heavy");
    CHECK(play.session->hud().better.empty());
    play.ask();
    play.answer("apple is most heavy", true);
    CHECK(play.session->hud().better == "*An* apple is *the heaviest*.");
    CHECK(play.session->hud().feedback == "Yes. " + play.session->hud().told);
    // The second time it is to be said once more: nothing is told yet.
    play.say_rightly("apple is most heavy");
    CHECK(play.session->hud().said == "apple is most heavy");
    CHECK(play.session->hud().better.empty());
    play.answer("apple is most heavy", true);
    CHECK(play.session->hud().better == "*An* apple is *the heaviest*.");
    play.ask();
    play.answer("the apple is the heaviest", true);
    CHECK(play.session->hud().said == "the apple is the heaviest");
    CHECK(play.session->hud().better.empty());
}
