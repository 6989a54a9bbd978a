#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

std::string sentence(const std::string& in_start) {
    return HostedLesson().start(in_start);
}

TEST_CASE("arguments: a place may be a list, named, a body or the tool") {
    HostedLesson lesson;
    REQUIRE(lesson.start("local a = world:body { name = 'a', at = { 1, 2, 3 } } world:body { name "
                         "= 'b', at = { x = 4, y = 5, z = 6 } } "
                         "world:body { name = 'c', at = a } world:body { name = 'd', at = "
                         "world:tool() } world:body { name = 'e', at = a.position }") == "");
    const auto& bodies = lesson.host->description().bodies;
    CHECK(bodies[0].position_W == Vector3(1, 2, 3));
    CHECK(bodies[1].position_W == Vector3(4, 5, 6));
    CHECK(bodies[2].position_W == Vector3(1, 2, 3));
    CHECK(bodies[3].position_W == Vector3(0, 0, 0));
    CHECK(bodies[4].position_W == Vector3(1, 2, 3));
    CHECK(
        sentence("world:body { name = 'a', at = 3 }") ==
        "lesson.lua:2: body.at is a place such as {0, 0.5, 0} in metres, -10000 to 10000; got 3.");
    CHECK(sentence("world:body { name = 'a', at = { 1, 'x', 3 } }") ==
          "lesson.lua:2: body.at is a place such as {0, 0.5, 0}; its y is the text \"x\".");
    CHECK(sentence("world:body { name = 'a', at = { 1, 2e4, 3 } }") ==
          "lesson.lua:2: body.at is a place such as {0, 0.5, 0} in metres, -10000 to 10000; got "
          "20000 for y.");
}

TEST_CASE("arguments: the ends of a range belong to it") {
    CHECK(sentence("world:gravity(0)") == "");
    CHECK(sentence("world:gravity(100)") == "");
    CHECK(sentence("world:gravity(100.001)") ==
          "lesson.lua:2: world:gravity is in metres per second squared, 0 to 100; got 100.001.");
    CHECK(sentence("world:gravity(-1e-9)") ==
          "lesson.lua:2: world:gravity is in metres per second squared, 0 to 100; got -1e-09.");
}

TEST_CASE("arguments: too many, too few and wrong kinds are told") {
    CHECK(sentence("world:gravity(1, 2)") == "lesson.lua:2: world:gravity takes 1 value; got 2.");
    CHECK(sentence("world:gravity()") ==
          "lesson.lua:2: world:gravity is missing; it is a number in metres per second squared, 0 "
          "to 100.");
    CHECK(sentence("world:body(3)") ==
          "lesson.lua:2: world:body takes a table of fields { … }; got 3.");
    CHECK(sentence("world:body({}, {})") == "lesson.lua:2: world:body takes 1 value; got 2.");
    CHECK(sentence("world:body { 'a' }") ==
          "lesson.lua:2: body takes fields with names, such as { name = … }; the text \"a\" has "
          "none.");
    CHECK(sentence("world:body { name = 'a', mass = 1,5 }") ==
          "lesson.lua:2: body takes fields with names, such as { name = … }; 5 has none; a "
          "fraction has a point, 1.5, and a place has braces, {0, 1, 0}.");
    CHECK(sentence("world:bucket { weight = 3 }") ==
          "lesson.lua:2: bucket has no field \"weight\"; it has model, radius, depth and holds.");
    CHECK(sentence("world:body { name = 'a', movable = 'yes' }") ==
          "lesson.lua:2: body.movable is true or false; got the text \"yes\".");
    CHECK(sentence("world:hand():force(3)") == "lesson.lua:2: hand:force is a function; got 3.");
    CHECK(sentence("world:level(1.5)") ==
          "lesson.lua:2: world:level's level is a whole number, 0 to 99; got 1.5.");
    CHECK(sentence("world:caption(('x'):rep(1001))") ==
          "lesson.lua:2: world:caption is a text of at most 1000 letters; got 1001 letters.");
}

TEST_CASE("arguments: lists and tables are checked item by item, and come sorted by name") {
    HostedLesson lesson;
    REQUIRE(lesson.load("L:question 'q' { prompt = 'p', answers = { 'a', 'b' }, lists = { z = { "
                        "'1' }, a = { '2', '3' } }, rules = { s = 'x', r = 'y' }, right = print }\n"
                        "L:test { say = { 'x' }, expect = { score = 7, finished = true, "
                        "caught = 3 } }") == "");
    const auto& question = lesson.host->description().questions.at(0);
    CHECK(question.answers == std::vector<std::string>{"a", "b"});
    REQUIRE(question.lists.size() == 2);
    CHECK(question.lists[0].first == "a");
    CHECK(question.lists[0].second == std::vector<std::string>{"2", "3"});
    using Pairs = std::vector<std::pair<std::string, std::string>>;
    CHECK(question.rules == Pairs{{"r", "y"}, {"s", "x"}});
    CHECK(lesson.host->description().tests.at(0).expect ==
          Pairs{{"caught", "3"}, {"finished", "true"}, {"score", "7"}});
    const auto wrong = [](const std::string& fields) {
        return HostedLesson().load("L:question 'q' { prompt = 'p', right = print, " + fields +
                                   " }");
    };
    CHECK(wrong("answers = { 3 }") ==
          "lesson.lua:2: question.answers[1] is a text of at most 1000 letters; got 3; put it in "
          "quotation marks, \"3\".");
    CHECK(wrong("answers = { 'a', ('x'):rep(1001) }") ==
          "lesson.lua:2: question.answers[2] is a text of at most 1000 letters; got 1001 letters.");
    CHECK(wrong("answers = { 'a', again = 'b' }") ==
          "lesson.lua:2: question.answers has a field \"again\" among its texts; write texts "
          "alone, { "
          "\"…\", \"…\" }, or a comma and a brace where it should end.");
    CHECK(wrong("answers = { 'a' }, lists = { feel = { hard = true } }") ==
          "lesson.lua:2: question.lists.feel has a field \"hard\" among its texts; write texts "
          "alone, "
          "{ \"…\", \"…\" }.");
    CHECK(HostedLesson().load(
              "local none local t = { 'a' } t[3] = 'c' L:question 'q' { prompt = 'p', "
              "right = print, answers = t }") ==
          "lesson.lua:2: question.answers has nothing at one of its places before the text \"c\"; "
          "is a "
          "name there that has no value?");
    CHECK(
        HostedLesson().load("L:test { expect = { stars = '3' } }") ==
        "lesson.lua:2: test.expect.stars is a number, true or false; got the text \"3\"; take its "
        "quotation marks away.");
    CHECK(wrong("answers = 'a'") ==
          "lesson.lua:2: question.answers is a list of texts; got the text \"a\"; put braces "
          "around it, { \"…\", \"…\" }.");
    CHECK(wrong("answers = {}") ==
          "lesson.lua:2: question.answers is empty; give at least one sentence that a learner may "
          "answer with.");
    CHECK(wrong("answers = { 'a' }, lists = { ['a b'] = {} }") ==
          "lesson.lua:2: question.lists has a list \"a b\"; a list's name is plain (a to z, 0 to "
          "9, _ and -).");
    CHECK(wrong("answers = { 'a' }, lists = { a = 3 }") ==
          "lesson.lua:2: question.lists.a is a list of texts; got 3; put braces around it, { "
          "\"…\", \"…\" }.");
    CHECK(wrong("answers = { 'a' }, lists = { 'red', 'blue' }") ==
          "lesson.lua:2: question.lists has the text \"red\" without a name; write { name = … }, "
          "such as { colour = { \"red\", \"blue\" } }.");
    CHECK(wrong("answers = { '<r>' }, rules = { r = { 'a' } }") ==
          "lesson.lua:2: question.rules.r is a text of at most 1000 letters; got a table.");
    CHECK(wrong("answers = { '<r>' }, rules = { 'a' }") ==
          "lesson.lua:2: question.rules has the text \"a\" without a name; write { name = … }, "
          "such as { place = \"(on|under) the table\" }.");
    CHECK(wrong("answers = { '<r>' }, rules = { ['a b'] = 'c' }") ==
          "lesson.lua:2: question.rules has a rule \"a b\"; a rule's name is plain (a to z, 0 to "
          "9, _ and -).");
    CHECK(wrong("answers = { '<r>' }, rules = 'a'") ==
          "lesson.lua:2: question.rules is a table of texts with names; got the text \"a\".");
    CHECK(HostedLesson().load("L:question { prompt = 'p', answers = { 'a' }, right = print }") ==
          "lesson.lua:2: L:question takes its name before the braces: L:question \"name\" { … }.");
}

TEST_CASE("arguments: what is left out is as the table says") {
    HostedLesson lesson;
    REQUIRE(lesson.start("world:body { name = 'a' } world:camera {} world:bucket() world:spring { "
                         "at = { 0, 0, 0 }, stiffness = 5 }") == "");
    const LessonDescription& scene = lesson.host->description();
    CHECK(scene.level == "A1");
    CHECK(scene.minutes == 10.0);
    CHECK(scene.bodies[0].radius_m == 0.05);
    CHECK(scene.bodies[0].mass_kg == 1.0);
    CHECK(scene.bodies[0].exaggeration == 1.0);
    CHECK_FALSE(scene.bodies[0].movable);
    CHECK(scene.camera.eye_W == CameraDescription{}.eye_W);
    CHECK(scene.camera.target_W == CameraDescription{}.target_W);
    CHECK(scene.camera.vertical_angle_deg == CameraDescription{}.vertical_angle_deg);
    CHECK(scene.bucket.present);
    CHECK(scene.bucket.opening_radius_m == BucketDescription{}.opening_radius_m);
    CHECK(scene.bucket.depth_m == BucketDescription{}.depth_m);
    CHECK(scene.bucket.holds == 1);
    CHECK(scene.forces[0].name == "spring1");
    CHECK(scene.forces[0].field.damping_Ns_per_m == 0.0);
}

}  // namespace
}  // namespace fulcrum::runtime
