// Bodies on hinges: what the lesson is told of them, what it orders, and what is seen.
#include "runtime/lesson/compose_view.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// A lever whose hinge lies 0.2 m to the right of it; before it a thing without one.
LessonDescription with_lever() {
    LessonDescription lesson = two_things();
    BodyDescription lever = thing("lever", 1.0);
    lever.movable = false;
    lever.visible = true;
    lever.position_W = {0, 0.3, 0};
    lever.hinge = AxleSettings{};
    lever.hinge->pivot_B = {0.2, 0, 0};
    lever.hinge->load_N = 3.0;
    lesson.bodies.push_back(lever);
    return lesson;
}

AxleFrame pressed() {
    AxleFrame frame;
    frame.n_axles = 1;
    AxleReport& report = frame.axles[0];
    report.pose_W = Pose::at(Vector3(0.01, 0.3, 0));
    report.pivot_W = {0.2, 0.3, 0};
    report.angle_rad = 0.1;
    report.spin_rad_per_s = 0.2;
    report.touched = true;
    report.at_W = {0.7, 0.35, 0.1};
    report.force_W = {0, -2, 0};
    report.torque_Nm = -1.0;
    report.load_torque_Nm = 0.6;
    report.inertia_kg_m2 = 0.35;
    report.load_N = 3.0;
    report.load_W = {0, 0.3, 0};
    return frame;
}

const dialogue::Catalogue& torque_words() {
    static const dialogue::Catalogue catalogue =
        dialogue::Catalogue::parse(
            "hud.force = {newtons} N\nhud.torque = {newtons} N × {metres} m = {torque} N m\n")
            .value();
    return catalogue;
}

}  // namespace

TEST_CASE("hinges: the lesson is told angle, spin, torque and lever arm, and the turned pose") {
    Play play(with_lever());
    const AxleFrame axles = pressed();
    SessionInput input;
    input.axles = &axles;
    const LessonFrame& frame = play.frame(input);
    REQUIRE(frame.hinges.size() == 1);
    CHECK(frame.hinges[0].angle_rad == 0.1);
    CHECK(frame.hinges[0].spin_rad_per_s == 0.2);
    CHECK(frame.hinges[0].torque_Nm == -1.0);
    CHECK(frame.hinges[0].arm_m == Approx(0.5));
    CHECK(frame.hinges[0].load_torque_Nm == 0.6);
    CHECK(frame.hinges[0].inertia_kg_m2 == 0.35);
    CHECK(frame.bodies[2].pose_W.position.x() == 0.01);
    CHECK(frame.bodies[0].pose_W.position.x() == 0.0);
    AxleFrame untouched = axles;
    untouched.axles[0].force_W.setZero();
    untouched.axles[0].torque_Nm = 0.0;
    input.axles = &untouched;
    CHECK(play.frame(input).hinges[0].arm_m == 0.0);
}

TEST_CASE("hinges: orders are kept, and counted where they are for once") {
    Play play(with_lever());
    play.frame();
    CHECK_FALSE(play.reply().axles.axles[0].is_set);
    play.frame();
    AxleOrder order = play.reply({TurnCommand{2, 0.5, {}, {}, {}}}).axles.axles[0];
    CHECK(order.n_angles == 1);
    CHECK(order.angle_rad == 0.5);
    CHECK(order.n_spins == 0);
    CHECK(order.is_set);
    CHECK(order.pivot_B == Vector3(0.2, 0, 0));
    CHECK(order.load_N == 3.0);
    play.frame();
    order = play.reply({TurnCommand{2, {}, -1.0, Vector3(0.3, 0.3, 0), 5.0}}).axles.axles[0];
    CHECK(order.n_angles == 1);
    CHECK(order.n_spins == 1);
    CHECK(order.spin_rad_per_s == -1.0);
    CHECK((order.pivot_B - Vector3(0.3, 0, 0)).norm() < 1e-15);
    CHECK(order.load_N == 5.0);
    play.frame();
    CHECK(play.refuses(TurnCommand{0, 0.5, {}, {}, {}}));
    CHECK(play.refuses(TurnCommand{3, 0.5, {}, {}, {}}));
    CHECK(play.refuses(TurnCommand{kNoBody, 0.5, {}, {}, {}}));
}

TEST_CASE("hinges: the picture shows both torques as force times lever arm, from the axis") {
    const LessonDescription lesson = with_lever();
    const Plan plan = compile_plan(lesson, {}, nullptr).value();
    const AxleFrame axles = pressed();
    Scenery scenery;
    scenery.hand.applied_W.force = {0, 2, 0};
    runtime::View view = compose_view(lesson, plan, {}, scenery, torque_words());
    CHECK(view.torques.empty());
    CHECK(view.force.visible);
    scenery.axles = &axles;
    view = compose_view(lesson, plan, {}, scenery, torque_words());
    REQUIRE(view.torques.size() == 2);
    CHECK(view.torques[0].force.text == "2.0 N × 0.50 m = 1.00 N m");
    CHECK(view.torques[0].force.force_W == Vector3(0, -2, 0));
    CHECK(view.torques[0].axis_W == Vector3(0.2, 0.3, 0.1));  // beside the hand, on the axis
    CHECK(view.torques[1].force.text == "3.0 N × 0.20 m = 0.60 N m");
    CHECK(view.torques[1].force.at_W == Vector3(0, 0.3, 0));
    CHECK_FALSE(view.force.visible);  // the push back would only be the same once more
    REQUIRE(view.bodies.size() == 1);
    CHECK(view.bodies[0].pose_W.position.x() == 0.01);
    AxleFrame near = axles;
    near.axles[0].load_torque_Nm = 0.003;
    scenery.axles = &near;
    CHECK(compose_view(lesson, plan, {}, scenery, torque_words()).torques[1].force.text ==
          "3.0 N × 0.001 m = 0.00 N m");
    // Where the hand is away there is nothing to show.
    AxleFrame untouched = axles;
    untouched.axles[0].touched = false;
    scenery.axles = &untouched;
    CHECK(compose_view(lesson, plan, {}, scenery, torque_words()).torques.empty());
}

TEST_CASE("hinges: numbers have the decimals that are asked for") {
    CHECK(number_text(1.005, 1) == "1.0");
    CHECK(number_text(-0.256, 2) == "-0.26");
}
