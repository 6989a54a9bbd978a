#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// Something to push against, and a force of the lesson's own.
LessonDescription with_forces() {
    LessonDescription lesson = two_things();
    ForceDescription magnet;
    magnet.field.anchor_W = {0.1, 0.2, 0.3};
    lesson.forces.push_back(magnet);
    lesson.hand.lesson_force = true;
    return lesson;
}

}  // namespace

TEST_CASE("commands: a drop pops, a held thing sounds like itself, and the world gets both") {
    Play play;
    play.frame();
    MoveCommand drop;
    drop.move.kind = WorldCommand::Kind::drop;
    drop.move.body = 0;
    MoveCommand hold;
    hold.move.kind = WorldCommand::Kind::hold;
    hold.move.body = 1;
    const SessionOutput output = play.reply({drop, hold});
    CHECK(output.sounds == std::vector<std::string>{"pop", "catch_egg"});
    REQUIRE(output.world.size() == 2);
    CHECK(output.world[0].kind == WorldCommand::Kind::drop);
    CHECK(output.world[1].body == 1);
}

TEST_CASE("commands: a declared force is on where it was declared until the lesson changes it") {
    Play play(with_forces());
    play.frame();
    CHECK(play.reply().force.fields[0].anchor_W == Vector3(0.1, 0.2, 0.3));
    FieldChangeCommand change;
    change.field.anchor_W = {1.0, 0.0, 0.0};
    CHECK(play.reply({change}).force.fields[0].anchor_W == Vector3(1.0, 0.0, 0.0));
    change.force = 1;
    CHECK(play.refuses(change));
}

TEST_CASE("commands: a cloth lies on one body until it is taken away") {
    Play play;
    play.frame();
    (void)play.reply({CoverCommand{1, true}});
    CHECK(play.session->hud().covered == std::vector<bool>{false, true});
    (void)play.reply({CoverCommand{1, false}});
    CHECK(play.session->hud().covered == std::vector<bool>{false, false});
    CHECK(play.refuses(CoverCommand{2, true}));
    CHECK(play.refuses(CoverCommand{-1, true}));
}

TEST_CASE("commands: a force of the lesson's own carries the time of its frame") {
    Play play(with_forces());
    play.time_s = 4.0;
    play.frame();
    LessonForceCommand force;
    force.force.force_W = {0.0, 1.0, 0.0};
    const SessionOutput output = play.reply({force});
    CHECK(output.force.linearised.stamp_s == 4.0);
    CHECK(output.force.linearised.force_W.y() == 1.0);
}

TEST_CASE("commands: an instruction replaces the last; a reply stands until it is read") {
    Play play;
    play.frame();
    play.say_rightly("apple is most heavy");
    CHECK_FALSE(play.session->hud().feedback.empty());
    play.reply({CaptionCommand{"Catch the egg!"}});
    CHECK(play.session->hud().caption == "Catch the egg!");
    CHECK_FALSE(play.session->hud().feedback.empty());
    (void)play.wait(10.0);
    CHECK(play.session->hud().caption == "Catch the egg!");
    CHECK(play.session->hud().feedback.empty());
}

TEST_CASE("commands: a higher level is heard, the first is not") {
    Play play;
    play.frame();
    CHECK(play.reply({LevelCommand{1, "one"}}).sounds.empty());
    CHECK(play.reply({LevelCommand{2, "two"}}).sounds == std::vector<std::string>{"level_up"});
    CHECK(play.reply({LevelCommand{2, "two"}}).sounds.empty());
    CHECK(play.session->hud().level_title == "two");
    CHECK(play.session->result().level == 2);
}

TEST_CASE("commands: sounds, prints and the score go where they belong") {
    Play play;
    play.frame();
    const SessionOutput output =
        play.reply({SoundCommand{"bell"}, PrintCommand{"for the teacher"}, ScoreCommand{7}});
    CHECK(output.sounds == std::vector<std::string>{"bell"});
    CHECK(output.printed == std::vector<std::string>{"for the teacher"});
    CHECK(play.session->hud().score == 7);
    CHECK(play.session->result().score == 7);
}
