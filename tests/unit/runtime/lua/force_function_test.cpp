#include "hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

/// The force that a function body hands over with the tool at `position`, moving with `velocity`.
LinearisedWrench force_of(const std::string& function_body, const Vector3& position,
                         const Vector3& velocity) {
    HostedLesson lesson;
    REQUIRE(lesson.start("world:force(function(tool) " + function_body + " end)") == "");
    LessonFrame frame = lesson.frame();
    frame.time_s = 3.0;
    frame.tool_pose_W.position = position;
    frame.tool_twist_W.linear = velocity;
    REQUIRE(lesson.play(frame) == "");
    REQUIRE(lesson.commands<LessonForceCommand>().size() == 1);
    return lesson.commands<LessonForceCommand>()[0].force;
}

TEST_CASE("force function: the slope of a curved force is right to second order") {
    // F_x = 100 x^2 + 5 v_x^2 at x = 0.2, v = 0.5: dF/dx = 40, dF/dv = 5; a central difference of a parabola is exact.
    const LinearisedWrench force =
        force_of("return 100 * tool.x * tool.x + 5 * tool.vx * tool.vx, 0, 0", Vector3(0.2, 0, 0),
                 Vector3(0.5, 0, 0));
    CHECK(force.force_W.x() == Approx(4.0 + 1.25));
    CHECK(force.stiffness_N_per_m(0, 0) == Approx(40.0).epsilon(1e-9));
    CHECK(force.damping_Ns_per_m(0, 0) == Approx(5.0).epsilon(1e-9));
    CHECK(force.stiffness_N_per_m(1, 1) == 0.0);
    CHECK(force.stamp_s == 3.0);
}

TEST_CASE("force function: rows are the force, columns what moved") {
    const LinearisedWrench force =
        force_of("return 0, 20 * tool.z, 3 * tool.vy", Vector3(0, 0, 0.1), Vector3(0, 1, 0));
    CHECK(force.stiffness_N_per_m(1, 2) == Approx(20.0));
    CHECK(force.stiffness_N_per_m(2, 1) == 0.0);
    CHECK(force.damping_Ns_per_m(2, 1) == Approx(3.0));
    CHECK(force.damping_Ns_per_m(1, 2) == 0.0);
}

TEST_CASE("force function: jumps and giants are limited, with their direction kept") {
    const LinearisedWrench force =
        force_of("return tool.x > 0 and 3e6 or -3e6, 4e6, 0", Vector3(1e-5, 0, 0), Vector3::Zero());
    CHECK(force.force_W.norm() == Approx(kMaxLessonForce_N));
    CHECK(force.force_W.x() == Approx(0.6 * kMaxLessonForce_N));
    CHECK(force.stiffness_N_per_m(0, 0) == kMaxLessonStiffness_N_per_m);
}

TEST_CASE("force function: the tool is as it was afterwards") {
    HostedLesson lesson;
    REQUIRE(
        lesson.load("function L:start(world) world:force(function(tool) return 0, 0, 0 end) end\n"
                    "function L:update(world) local t = world:tool() print(t.x, t.y, t.z, t.vx, "
                    "t.vy, t.vz) end") == "");
    LessonFrame frame = lesson.frame();
    frame.tool_pose_W.position = Vector3(1, 2, 3);
    frame.tool_twist_W.linear = Vector3(4, 5, 6);
    REQUIRE(lesson.play(frame) == "");
    REQUIRE(lesson.play(frame) == "");
    CHECK(lesson.prints == "1.0\t2.0\t3.0\t4.0\t5.0\t6.0;1.0\t2.0\t3.0\t4.0\t5.0\t6.0;");
}

TEST_CASE("force function: what is no force is told where the function stands") {
    const auto sentence = [](const std::string& body) {
        HostedLesson lesson;
        REQUIRE(lesson.start("\nworld:force(function(tool) " + body + " end)") == "");
        return lesson.play();
    };
    const std::string start =
        "lesson.lua:3: the force function gives three finite numbers, in newtons; number ";
    CHECK(sentence("return 1, 2") == start + "3 is nil.");
    CHECK(sentence("return 1, 'x', 3") == start + "2 is string.");
    CHECK(sentence("return 0/0, 0, 0") == start + "1 is infinite or undefined.");
    CHECK(sentence("return 0, 0, math.huge") == start + "3 is infinite or undefined.");
}

}  // namespace
}  // namespace fulcrum::runtime
