#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

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
