#include "runtime/app/lesson_bodies.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

BodyDescription thing(const char* name, const Vector3& at_W, bool solid, bool visible) {
    BodyDescription body;
    body.name = name;
    body.position_W = at_W;
    body.solid = solid;
    body.visible = visible;
    return body;
}

TEST_CASE("lesson bodies: those that are seen or touched are there at first, where they stand") {
    LessonDescription lesson;
    lesson.bodies = {thing("seen", {1, 0, 0}, false, true), thing("later", {2, 0, 0}, false, false),
                     thing("wall", {3, 0, 0}, true, false)};
    const auto placed = place_at_first(lesson);
    REQUIRE(placed.size() == 2);
    CHECK(placed[0].body == 0);
    CHECK(placed[1].body == 2);
    CHECK(placed[1].position_W == Vector3(3, 0, 0));
    CHECK(placed[1].kind == WorldCommand::Kind::place);
}

TEST_CASE("lesson bodies: who looks at a thing looks on until another is nearer by a third") {
    LessonDescription lesson;
    lesson.bodies = {thing("cloud", {0, 0, 0}, false, true), thing("left", {-1, 0, 0}, true, true),
                     thing("right", {1, 0, 0}, true, true)};
    NearestThing nearest;
    CHECK_FALSE(NearestThing().look({}, nullptr, Vector3::Zero()));
    CHECK(nearest.look(lesson, nullptr, Vector3(-0.1, 0, 0)) == Vector3(-1, 0, 0));
    // A little nearer to the other is not enough: 0.7 * 1.1 < 0.9, but 0.7 * 1.3 > 0.7.
    CHECK(nearest.look(lesson, nullptr, Vector3(0.1, 0, 0)) == Vector3(-1, 0, 0));
    CHECK(nearest.look(lesson, nullptr, Vector3(0.3, 0, 0)) == Vector3(1, 0, 0));
    CHECK(nearest.look(lesson, nullptr, Vector3(0.0, 0, 0)) == Vector3(1, 0, 0));
    // What is hidden is not seen, and what moved is seen where it is.
    WorldSnapshot world;
    world.n_bodies = 3;
    world.bodies[1].where = BodyWhere::placed;
    world.bodies[1].pose_W = Pose::at({0, 5, 0});
    world.bodies[2].where = BodyWhere::hidden;
    CHECK(nearest.look(lesson, &world, Vector3(1, 0, 0)) == Vector3(0, 5, 0));
}

}  // namespace
}  // namespace fulcrum::runtime
