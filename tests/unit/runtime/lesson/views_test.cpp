#include "haptics/geometry/shape.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/lesson/compose_view.h"
#include "runtime/lesson/still_hand.h"
#include "runtime/lesson/tool_extent.h"
#include "runtime/scene/shape_models.h"
#include "tests/unit/runtime/lesson/shown_view.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>

using namespace fulcrum::runtime::test;

namespace {

// A cylinder of 2 cm by 30 cm that lies along x in its principal axes' frame, and is held upright 10 cm below its middle.
ToolPlan make_plan(bool in_voxels) {
    const Quaternion handle_turn(
        AngleAxis(0.5 * std::numbers::pi, Vector3::UnitZ()));  // x of T is y of the handle
    ToolOrder order;
    order.settings.handle_turn = handle_turn;
    order.settings.grip_T = Vector3(-0.1, 0.0, 0.0);
    const Pointshell upright =
        make_surface_pointshell(make_cylinder(0.01, 0.3, 48).value(), 20000).value();
    order.shell = std::make_shared<const Pointshell>(
        make_moved(upright, {Vector3::Zero(), handle_turn.conjugate()}));
    return in_voxels ? make_voxel_tool_plan(order, {nullptr})
                     : make_field_tool_plan(order, {nullptr}).value();
}

// The same stick as contact levels.
ToolPlan make_plan_of_levels() {
    const TriangleMesh upright = make_cylinder(0.01, 0.3, 48).value();
    const Quaternion turn(AngleAxis(-0.5 * std::numbers::pi, Vector3::UnitZ()));
    std::vector<Vector3> vertices = upright.vertices_B();
    for (Vector3& vertex : vertices) {
        vertex = turn * vertex;
    }
    const auto levels =
        ContactLevels::create(TriangleMesh::build(vertices, upright.triangles()).value()).value();
    ToolPlan plan = make_plan(false);
    plan.objects = std::vector<LevelContactsPlan>{{levels, levels, {}}};
    return plan;
}

}  // namespace

TEST_CASE("view: hidden bodies are not shown, falling ones are, held ones are named") {
    Shown shown;
    CHECK(shown.view().bodies.empty());
    shown.world.bodies[0].where = BodyWhere::falling;
    REQUIRE(shown.view().bodies.size() == 1);
    CHECK(shown.view().bodies[0].model == "apple");
    CHECK(shown.view().bodies[0].label.empty());
    shown.world.bodies[0].where = BodyWhere::held;
    CHECK(shown.view().bodies[0].label == "apple");
}

TEST_CASE("view: a solid body is named where it has a noun of its own") {
    Shown shown;
    shown.lesson.bodies[0].movable = false;
    shown.world.bodies[0].where = BodyWhere::placed;
    shown.lesson.bodies[0].noun = "green apple";
    CHECK(shown.view().bodies.at(0).label.empty());
    shown.lesson.bodies[0].solid = true;
    CHECK(shown.view().bodies.at(0).label == "green apple");
    shown.lesson.bodies[0].noun = shown.lesson.bodies[0].name;
    CHECK(shown.view().bodies.at(0).label.empty());
}

TEST_CASE("view: a material gives its look, and under a cloth nothing is given away") {
    Shown shown;
    MaterialDescription felt;
    felt.felt.name = "felt";
    felt.look = "wood";
    shown.lesson.materials = {felt};
    shown.lesson.bodies[0].material = 0;
    shown.lesson.bodies[0].radius_m = 0.04;
    shown.world.bodies[0].where = BodyWhere::placed;
    CHECK(shown.view().bodies.at(0).look == "wood");
    CHECK(shown.view().bodies.at(0).label == "apple");
    shown.hud.covered = {true, false};
    const ViewBody covered = shown.view().bodies.at(0);
    CHECK(covered.model == "cloth");
    CHECK(covered.scale == Vector3::Constant(0.04));
    CHECK((covered.look.empty() && covered.label.empty()));
}

TEST_CASE("view: a held thing shows its felt and its true weight in newtons") {
    Shown shown;
    shown.world.bodies[0].where = BodyWhere::held;
    shown.scenery.hand.applied_W.force = {0.0, -1.962, 0.0};
    const runtime::View view = shown.view();
    CHECK(view.force.visible);
    CHECK(view.force.text == "felt 2.0 N, true 2.0 N");
    CHECK(view.force.force_W.y() == Approx(-1.962));
    shown.world.bodies[0].where = BodyWhere::hidden;
    CHECK(shown.view().force.text == "2.0 N");
}

TEST_CASE("view: without a force no arrow; a mouse squashes what it holds, and has a ghost") {
    Shown shown;
    CHECK_FALSE(shown.view().force.visible);
    shown.world.bodies[0].where = BodyWhere::held;
    shown.scenery.hand.applied_W.force = {0.0, -4.0, 0.0};
    CHECK(shown.view().bodies[0].scale.y() == 1.0);
    shown.scenery.renders_force = false;
    shown.scenery.ghost = true;
    const runtime::View view = shown.view();
    CHECK(view.bodies[0].scale.y() < 1.0);
    CHECK(view.bodies[0].scale.prod() == Approx(1.0));  // flatter and wider: the same volume
    CHECK(view.ghost_visible);
    shown.scenery.calm = true;
    CHECK(shown.view().bodies[0].scale.y() == 1.0);
}

TEST_CASE("view: the program's own hand glides, or stands where it last rested for who is calm") {
    StillHand still;
    const auto at = [](double x) { return std::optional<Vector3>({x, 0.3, 0.0}); };
    still.look(std::nullopt, 0.0);
    CHECK_FALSE(still.seen_W());
    still.look(at(0.0), 0.0);
    CHECK(still.seen_W() == at(0.0));
    // It goes 0.2 m in half a second: nothing is seen of that until it rests.
    for (int i = 1; i <= 30; ++i) {
        still.look(at(0.2 * i / 30.0), i / 60.0);
        CHECK(still.seen_W() == at(0.0));
    }
    still.look(at(0.2), 31.0 / 60.0);
    CHECK(still.seen_W() == at(0.2));
    // One that never rests is seen each second.
    int seen = 0;
    for (int i = 1; i <= 300; ++i) {
        const auto before = still.seen_W();
        still.look(at(0.2 + 0.01 * i), (31 + i) / 60.0);
        seen += before == still.seen_W() ? 0 : 1;
    }
    CHECK(seen >= 4);
    CHECK(seen <= 5);
    still.look(std::nullopt, 6.0);
    CHECK_FALSE(still.seen_W());

    Shown shown;
    shown.hud.shown_hand_W = {0.1, 0.2, 0.3};
    const Vector3 glides_W = shown.view().bodies.back().pose_W.position;
    shown.scenery.still_hand_W = {0.4, 0.2, 0.3};
    CHECK(shown.view().bodies.back().pose_W.position.isApprox(glides_W + Vector3(0.3, 0.0, 0.0)));
}

TEST_CASE("view: two hands have a colour each, a number each, and forces to one scale") {
    Shown shown;
    shown.lesson.bucket.present = false;
    shown.scenery.hand.applied_W.force = {-2.0, 0.0, 0.0};
    CHECK(shown.view().tool.label.empty());
    CHECK(shown.view().forces.empty());
    CHECK(shown.view().more_hands.empty());
    shown.lesson.more_hands.emplace_back();
    CHECK(shown.view().more_hands.empty());  // nobody moves it
    HandScenery second;
    second.hand.proxy_position_W = {0.1, 0.2, 0.3};
    second.hand.proxy_orientation_W = Quaternion(AngleAxis(0.4, Vector3::UnitX()));
    second.hand.applied_W.force = {1.5, 0.0, 0.0};
    second.ghost = true;
    second.ghost_pose_W.position = {0.15, 0.2, 0.3};
    shown.scenery.more_hands = {second};
    const runtime::View view = shown.view();
    CHECK(view.tool.label.empty());
    CHECK(view.force.text == "1: 2.0 N");
    REQUIRE(view.more_hands.size() == 1);
    CHECK(view.more_hands[0].tool.label.empty());
    CHECK(view.more_hands[0].tool.model == kSecondToolModel);
    CHECK(view.more_hands[0].tool.model != view.tool.model);
    CHECK(view.more_hands[0].tool.pose_W.position == Vector3(0.1, 0.2, 0.3));
    CHECK(view.more_hands[0].tool.pose_W.orientation.isApprox(second.hand.proxy_orientation_W));
    CHECK(view.more_hands[0].ghost_visible);
    CHECK(view.more_hands[0].ghost_pose_W.position.x() == 0.15);
    REQUIRE(view.forces.size() == 1);
    CHECK(view.forces[0].text == "2: 1.5 N");
    CHECK(view.forces[0].look != view.force.look);
    // Where nothing is felt the number stands beside the hand.
    shown.scenery.hand.applied_W.force.setZero();
    shown.scenery.more_hands[0].hand.applied_W.force.setZero();
    CHECK(shown.view().tool.label == "1");
    CHECK(shown.view().more_hands[0].tool.label == "2");
    CHECK(shown.view().forces.empty());
}

TEST_CASE("view: without a world the visible bodies stand where the lesson put them") {
    Shown shown;
    shown.scenery.world = nullptr;
    shown.lesson.bodies[1].visible = true;
    shown.lesson.bodies[1].position_W = {1.0, 2.0, 3.0};
    REQUIRE(shown.view().bodies.size() == 1);
    CHECK(shown.view().bodies[0].pose_W.position == Vector3(1.0, 2.0, 3.0));
}

TEST_CASE("view: a burst is as old as it is since, ends, and who is calm sees none") {
    Shown shown;
    shown.hud.bursts = {{Vector3(0.1, 0.2, 0.3), 2.0}};
    shown.scenery.time_s = 2.0 + 0.25 * kBurstLasts_s;
    REQUIRE(shown.view().bursts.size() == 1);
    CHECK(shown.view().bursts[0].at_W == Vector3(0.1, 0.2, 0.3));
    CHECK(shown.view().bursts[0].age_s == Approx(0.25 * kBurstLasts_s));
    shown.scenery.calm = true;
    CHECK(shown.view().bursts.empty());
    shown.scenery.calm = false;
    shown.scenery.time_s = 2.0 + 1.01 * kBurstLasts_s;
    CHECK(shown.view().bursts.empty());
}

TEST_CASE("view: score, level, caption and stars come from the session") {
    Shown shown;
    shown.hud = {"Catch!", "Yes!", true, 1.0, 7, 2, "Three things", 3};
    const runtime::View view = shown.view();
    CHECK(view.caption == "Catch!");
    CHECK(view.feedback == "Yes!");
    CHECK(view.input_visible);
    CHECK(view.score == 7);
    CHECK(view.level == 2);
    CHECK(view.level_title == "Three things");
    CHECK(view.stars == 3);
}

TEST_CASE("view: what was said stands above how it is better said, which stands there once") {
    Shown shown;
    shown.hud.feedback = "Yes. A melon is *the heaviest*. A short word gets -est.";
    CHECK(shown.view().feedback == shown.hud.feedback);
    shown.hud.said = "melon is *most* heavy";
    CHECK(shown.view().feedback == "You said: melon is most heavy\n" + shown.hud.feedback);
    shown.hud.better = "*A* melon is *the heaviest*.";
    shown.hud.told = "A melon is *the heaviest*.";
    CHECK(shown.view().feedback ==
          "Yes. You said: melon is most heavy\nBetter: *A* melon is *the heaviest*.\n"
          "A short word gets -est.");
    // Another partner's words stand as they are.
    shown.hud.feedback = "Well, well.";
    CHECK(shown.view().feedback ==
          "You said: melon is most heavy\nBetter: *A* melon is *the heaviest*.\nWell, well.");
    shown.hud.feedback = shown.hud.told;
    CHECK(shown.view().feedback ==
          "You said: melon is most heavy\nBetter: *A* melon is *the heaviest*.");
    shown.hud.better.clear();
    shown.hud.feedback = "Say it again.";
    shown.hud.said = std::string(59, 'a') + "é" + std::string(40, 'b');
    CHECK(shown.view().feedback == "You said: " + std::string(59, 'a') + "…\nSay it again.");
    shown.hud.feedback.clear();
    CHECK(shown.view().feedback.empty());
}

TEST_CASE("view: what was felt of a thing that stands there ends beside it, with its name") {
    Shown shown;
    shown.hud.marked_N = {0.0, 2.5};
    shown.world.bodies[0].where = shown.world.bodies[1].where = BodyWhere::placed;
    const runtime::View view = shown.view();
    REQUIRE(view.marks.size() == 1);
    const runtime::ViewForce& mark = view.marks[0];
    const BodyDescription& body = shown.lesson.bodies[1];
    const Vector3 away = mark.at_W - view.bodies[1].pose_W.position;
    CHECK(mark.force_W == Vector3(0.0, -2.5, 0.0));
    CHECK(away.y() == Approx(-body.radius_m));
    CHECK(away.dot(shown.lesson.camera.target_W - shown.lesson.camera.eye_W) ==
          Approx(-body.radius_m * (shown.lesson.camera.target_W - shown.lesson.camera.eye_W).y()));
    CHECK(away.x() > body.radius_m);
    CHECK(mark.text == body.noun + ": 2.5 N");
    CHECK(view.bodies[0].label == shown.lesson.bodies[0].noun);
    CHECK(view.bodies[1].label.empty());
    // What is elsewhere has none there.
    shown.world.bodies[1].where = BodyWhere::held;
    CHECK(shown.view().marks.empty());
}

TEST_CASE("view: a ball and a box are drawn as large as they are felt, other models as they are") {
    Shown shown;
    shown.world.bodies[0].where = BodyWhere::placed;
    shown.lesson.bodies[0].radius_m = 0.07;
    CHECK(shown.view().bodies[0].scale == Vector3::Ones());
    for (const char* model : {"sphere", "box"}) {
        shown.lesson.bodies[0].model = model;
        CHECK(shown.view().bodies[0].scale == Vector3::Constant(0.07));
    }
}

TEST_CASE("view: a tool that is a model of size 1 is drawn as large as it is felt") {
    Shown shown;
    const auto scale_of = [&](const char* model, const CursorShape& shape) {
        shown.lesson.hand.tool = ToolDescription{};
        shown.lesson.hand.tool->model = model;
        shown.lesson.hand.tool->shape = shape;
        CHECK(shown.view().tool.model == model);
        return shown.view().tool.scale;
    };
    CHECK(scale_of("sphere", SphereShape{0.03}) == Vector3::Constant(0.03));
    CHECK(scale_of("earth", SphereShape{0.05}) == Vector3::Constant(0.05));
    CHECK(scale_of("box", BoxShape{Vector3::Constant(0.02)}) == Vector3::Constant(0.02));
    CHECK(scale_of("kettle", std::monostate{}) == Vector3::Ones());
}

TEST_CASE("view: the arrow of a force stands beside the tool or at its end, and hides nothing") {
    Shown shown;
    ToolOrder order;
    order.shell = std::make_shared<const Pointshell>(
        make_surface_pointshell(make_cylinder(0.004, 0.2, 24).value(), 2000).value());
    const Vector3 hand_W(0.1, 0.4, 0.0);
    shown.lesson.camera.target_W = hand_W;
    shown.lesson.camera.eye_W = hand_W + Vector3(0.0, 0.0, 1.0);
    shown.scenery.hand.proxy_position_W = hand_W;
    const auto tail = [&](const Vector3& force_W) {
        shown.scenery.hand.applied_W.force = force_W;
        return Vector3(shown.view().force.at_W - hand_W);
    };
    const Vector3 up(0.0, 3.0, 0.0);
    CHECK(std::abs(tail(up).x()) < 1e-9);
    shown.plan.haptic.tool =
        std::make_shared<const ToolPlan>(make_voxel_tool_plan(order, {nullptr}));
    // Along the stick: beside it, half an arrow's head and the stick's half width away.
    CHECK(std::abs(tail(up).x()) == Approx(0.034).margin(1e-3));
    CHECK(std::abs(tail(up).y()) < 1e-9);
    // Across it: from its side on.
    CHECK(tail({-2.0, 0.0, 0.0}).x() == Approx(-0.004).margin(1e-3));
    // Towards the eye: from its side on as well, for such an arrow has no side.
    CHECK(tail({0.0, 0.0, 2.0}).z() == Approx(0.004).margin(1e-3));
    // Along it, for an eye above: from its end on.
    shown.lesson.camera.eye_W = hand_W + Vector3(0.0, 1.0, 0.05);
    CHECK(tail(up).y() == Approx(0.1).margin(1e-3));
}

TEST_CASE("tool extent: how far a stick reaches from the hand in each direction, turned or not") {
    constexpr double kBetweenPoints_m = 0.003;
    for (const ToolPlan& plan : {make_plan(true), make_plan(false), make_plan_of_levels()}) {
        const auto extent_m = [&](const Quaternion& turn_W, const Vector3& way) {
            return compute_tool_extent_m(plan, turn_W, way);
        };
        const Quaternion upright = Quaternion::Identity();
        CHECK(extent_m(upright, Vector3::UnitY()) == Approx(0.25).margin(kBetweenPoints_m));
        CHECK(extent_m(upright, -Vector3::UnitY()) == Approx(0.05).margin(kBetweenPoints_m));
        CHECK(extent_m(upright, Vector3::UnitX()) == Approx(0.01).margin(kBetweenPoints_m));
        CHECK(extent_m(upright, Vector3::UnitZ()) == Approx(0.01).margin(kBetweenPoints_m));
        const Quaternion leaned(AngleAxis(-0.5 * std::numbers::pi, Vector3::UnitZ()));
        CHECK(extent_m(leaned, Vector3::UnitX()) == Approx(0.25).margin(kBetweenPoints_m));
        CHECK(extent_m(leaned, Vector3::UnitY()) == Approx(0.01).margin(kBetweenPoints_m));
    }
}
