#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/lua/lesson_folder.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

/// The force that a function body hands over with the tool at `position`, moving with `velocity`.
LinearisedWrench force_of(const std::string& function_body, const Vector3& position,
                          const Vector3& velocity) {
    HostedLesson lesson;
    REQUIRE(lesson.start("world:hand {}:force(function(tool) " + function_body + " end)") == "");
    LessonFrame frame = lesson.frame();
    frame.time_s = 3.0;
    frame.tool_pose_W.position = position;
    frame.tool_twist_W.linear = velocity;
    REQUIRE(lesson.play(frame) == "");
    REQUIRE(lesson.commands<LessonForceCommand>().size() == 1);
    return lesson.commands<LessonForceCommand>()[0].force;
}

}  // namespace

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
    CHECK(force_of("return 0, -1e200, 0", Vector3::Zero(), Vector3::Zero()).force_W.y() ==
          Approx(-kMaxLessonForce_N));
    // Of whatever length: no number is beyond what the program takes, by a bit of rounding either.
    for (int newtons = 101; newtons < 400; ++newtons) {
        const LinearisedWrench along = force_of("return 0, -" + std::to_string(newtons) + ", 0",
                                                Vector3::Zero(), Vector3::Zero());
        REQUIRE(along.force_W.y() >= -kMaxLessonForce_N);
        REQUIRE(along.force_W.y() < -kMaxLessonForce_N * (1.0 - 1.0e-15));
    }
}

TEST_CASE("force function: the tool is as it was afterwards") {
    HostedLesson lesson;
    REQUIRE(
        lesson.load(
            "function L:start(world) world:hand {}:force(function(tool) return 0, 0, 0 end) end\n"
            "function L:update(world) local t = world:tool() print(t.x, t.y, t.z, t.vx, "
            "t.vy, t.vz) end") == "");
    LessonFrame frame = lesson.frame();
    frame.tool_pose_W.position = Vector3(1, 2, 3);
    frame.tool_twist_W.linear = Vector3(4, 5, 6);
    REQUIRE(lesson.play(frame) == "");
    REQUIRE(lesson.play(frame) == "");
    CHECK(lesson.prints == "1.0\t2.0\t3.0\t4.0\t5.0\t6.0;1.0\t2.0\t3.0\t4.0\t5.0\t6.0;");
}

TEST_CASE("force function: three numbers give no torque and no slope of one") {
    const LinearisedWrench force =
        force_of("return tool.x, tool.y, tool.z", Vector3(1, 2, 3), Vector3::Zero());
    CHECK(force.force_W == Vector3(1, 2, 3));
    CHECK(force.torque_W == Vector3::Zero());
    CHECK(force.torque_stiffness_Nm_per_m == Matrix3::Zero());
}

TEST_CASE("force function: a torque's slope has the torque as rows, what moved as columns") {
    // T_y = 3 z + x^2 at x = 0.5: dT_y/dx = 1, dT_y/dz = 3. T_z follows the velocity: no slope of it is handed over.
    const LinearisedWrench force =
        force_of("return tool.y, 0, 0, 0.5, 3 * tool.z + tool.x * tool.x, 8 * tool.vx",
                 Vector3(0.5, 0.25, -0.1), Vector3(0.1, 0, 0));
    CHECK((force.force_W - Vector3(0.25, 0, 0)).norm() < 1e-12);
    CHECK((force.torque_W - Vector3(0.5, -0.05, 0.8)).norm() < 1e-12);
    Matrix3 slope;
    slope << 0, 0, 0, 1, 0, 3, 0, 0, 0;
    constexpr double kRounding = 1e-9;  // of a difference of numbers below 1, divided by 2e-4
    CHECK((force.torque_stiffness_Nm_per_m - slope).norm() < kRounding);
    CHECK(force.damping_Ns_per_m == Matrix3::Zero());
    CHECK(force.stiffness_N_per_m(0, 1) == Approx(1.0));
}

TEST_CASE("force function: a torque's jumps and giants are limited, with their direction kept") {
    const LinearisedWrench force = force_of("return 0, 0, 0, 0, tool.x > 0 and 3e6 or -3e6, 4e6",
                                            Vector3(1e-5, 0, 0), Vector3::Zero());
    CHECK(force.torque_W.norm() == Approx(kMaxLessonTorque_Nm));
    CHECK(force.torque_W.y() == Approx(0.6 * kMaxLessonTorque_Nm));
    CHECK(force.torque_stiffness_Nm_per_m(1, 0) == kMaxLessonTorqueStiffness_Nm_per_m);
    CHECK(force.force_W == Vector3::Zero());
}

TEST_CASE("force function: a lesson process hands force, torque and slopes over") {
    const LessonFolder folder;
    // F = -K (x - 0.1) - B v with coupling between axes.
    auto process = folder.start(lesson_text(R"(
function L:start(world)
  world:hand {}:force(function(tool)
    return -200 * (tool.x - 0.1) + 30 * tool.y, -50 * tool.y - 2 * tool.vy, 7 * tool.vx,
           0.25, -3 * tool.z, 4 * tool.x + 9 * tool.vz
  end)
end)"));
    REQUIRE(process);
    CHECK((*process)->description().hand.lesson_force);
    CHECK((*process)->description().hand.force_line == 4);
    LessonFrame frame = frame_for((*process)->description(), 2.0);
    frame.tool_pose_W.position = Vector3(0.11, 0.02, -0.3);
    frame.tool_twist_W.linear = Vector3(0.5, -0.25, 0.0);
    const auto reply = (*process)->exchange(frame);
    REQUIRE(reply);
    const LinearisedWrench force = std::get<LessonForceCommand>(reply->commands.at(0)).force;
    Matrix3 stiffness;
    stiffness << -200, 30, 0, 0, -50, 0, 0, 0, 0;
    Matrix3 damping;
    damping << 0, 0, 0, 0, -2, 0, 7, 0, 0;
    Matrix3 torque_stiffness;
    torque_stiffness << 0, 0, 0, 0, 0, -3, 4, 0, 0;
    constexpr double kRounding = 1e-7;  // of a difference of numbers near 1, divided by 2e-4
    CHECK((force.force_W - Vector3(-1.4, -0.5, 3.5)).norm() < 1e-12);
    CHECK((force.torque_W - Vector3(0.25, 0.9, 0.44)).norm() < 1e-12);
    CHECK((force.torque_stiffness_Nm_per_m - torque_stiffness).norm() < kRounding);
    CHECK((force.stiffness_N_per_m - stiffness).norm() < kRounding);
    CHECK((force.damping_Ns_per_m - damping).norm() < kRounding);
    CHECK(force.at_position_W == frame.tool_pose_W.position);
    CHECK(force.at_velocity_W == frame.tool_twist_W.linear);
    CHECK(force.stamp_s == 2.0);
}
