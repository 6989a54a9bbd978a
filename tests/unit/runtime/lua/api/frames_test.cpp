// What a lesson reads of a frame; what it declares and sends without one stands in described_table.txt.
#include "dialogue/conversation/conversation.h"
#include "haptics/math/rotation.h"
#include "runtime/effect/rigid/declare_rigid.h"
#include "runtime/lua/api/nouns.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/lua/told_messages.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>

using namespace fulcrum::runtime::test;

namespace {

constexpr double kDegree_rad = std::numbers::pi / 180.0;

/// A lesson with this beginning that prints such things in each frame.
struct Printing {
    HostedLesson lesson;
    explicit Printing(const std::string& start, const std::string& printed) {
        REQUIRE(lesson.load("local world, a, b\nfunction L:start(w) world = w " + start +
                            " end\nfunction L:update() print(" + printed + ") end") == "");
    }
    std::string of(const LessonFrame& frame) {
        lesson.prints.clear();
        const std::string error = lesson.play(frame);
        return error.empty() ? lesson.prints : error;
    }
};

KiteState make_kite_state() {
    KiteState state;
    state.centre_W = {4, 12, 1};
    state.velocity_W = {0, 0, 2};
    state.weight_W = {0, -0.25, 0};
    state.lift_W = {0, 4, 0};
    state.drag_W = {1.5, 0, 0};
    state.tension_W = {-1.5, -3.75, 0};
    state.hand_force_W = {1, 3, 0};
    state.wind_W = {6, 0, 0};
    state.angle_of_attack_rad = 20 * kDegree_rad;
    state.line_m = 14.5;
    return state;
}

}  // namespace

TEST_CASE("hinge place: the reference says how far one may be") {
    std::ostringstream limit;
    limit << "at most " << kFarthestOnAxle_m << " m from ";
    std::size_t n_told = 0;
    const auto count = [&](const Parameter& parameter) {
        n_told += std::string(parameter.text).find(limit.str()) != std::string::npos ? 1 : 0;
    };
    for (const Binding& binding : api_table().functions) {
        for (const Parameter& parameter : binding.parameters) {
            count(parameter);
            std::for_each_n(parameter.fields, parameter.n_fields, count);
        }
    }
    CHECK(n_told == 3);
}

TEST_CASE("rigid bodies: what is not said of a shape is as what stands before it") {
    BodyDescription body;
    body.model = "vase";
    body.radius_m = 0.1;
    CHECK(as_simulated(body).model == "vase");
    CHECK(box_size_m(body) == Vector3::Constant(0.2));
    body.felt_model = "sphere";
    CHECK(as_felt(body).model == "sphere");
    CHECK(as_simulated(body).model == "sphere");
    body.simulated_model = "box";
    CHECK(as_felt(body).model == "sphere");
    CHECK(as_simulated(body).model == "box");
    body.size_m = {1, 0.1, 1};
    CHECK(box_size_m(body) == Vector3(1, 0.1, 1));
}

TEST_CASE("bodies: moves carry body, place and velocity; where it is now is the default") {
    HostedLesson lesson;
    REQUIRE(lesson.load(
                "local a, b function L:start(world) a = world:body { name = 'a' } b = world:body { "
                "name = 'b', movable = true, at = { 0, 1, 0 } } end\n"
                "function L:update(world) b:drop() b:drop { at = { 1, 2, 3 }, velocity = { 4, 5, 6 "
                "} } a:place { at = { 7, 8, 9 } } b:hold() a:hide() world:release() end") == "");
    LessonFrame frame = lesson.frame();
    frame.bodies[1].pose_W.position = Vector3(0, 0.5, 0);
    REQUIRE(lesson.play(frame) == "");
    CHECK(told_reply(lesson.reply) ==
          "commands {a command MoveCommand, a move 0, a moved body 1, a position 0 0.5 0, a "
          "velocity 0 0 0} {a command MoveCommand, a move 0, a moved body 1, a position 1 2 3, a "
          "velocity 4 5 6} {a command MoveCommand, a move 1, a moved body 0, a position 7 8 9, a "
          "velocity 0 0 0} {a command MoveCommand, a move 3, a moved body 1, a position 0 0.5 0, a "
          "velocity 0 0 0} {a command MoveCommand, a move 2, a moved body 0, a position 0 0 0, a "
          "velocity 0 0 0} {a command MoveCommand, a move 4, a moved body -1, a position 0 0 0, a "
          "velocity 0 0 0}");
    // Farther away than a lesson may say it is put as far as that.
    frame.bodies[1].pose_W.position = Vector3(3.0, 2.0e4, -1.1e4);
    REQUIRE(lesson.play(frame) == "");
    CHECK(lesson.commands<MoveCommand>().at(0).move.position_W == Vector3(3.0, 1.0e4, -1.0e4));
}

TEST_CASE("bodies: fields tell how things stand") {
    Printing printing(
        "world:gravity(2) a = world:body { name = 'a', noun = 'pear', mass = 3, visible = true, at "
        "= { 1, 2, 3 } }",
        "a.name, a.noun, a.mass, a.weight, a.felt_weight, a.where, a.x, a.y, a.z, a.position[1] == "
        "a.position.x, "
        "a.position.y, a.position[3]");
    LessonFrame frame = printing.lesson.frame({ReadyEvent{{5.5}, 1.0}});
    for (const auto& [where, name] : {std::pair{BodyWhere::hidden, "hidden"},
                                      {BodyWhere::placed, "placed"},
                                      {BodyWhere::falling, "falling"},
                                      {BodyWhere::held, "held"},
                                      {BodyWhere::landed, "landed"}}) {
        frame.bodies[0].where = where;
        CHECK(printing.of(frame) ==
              std::string("a\tpear\t3.0\t6.0\t5.5\t") + name + "\t1.0\t2.0\t3.0\ttrue\t2.0\t3.0;");
    }
}

TEST_CASE("hinges: fields tell how each one stands, in degrees") {
    Printing printing(
        "a = world:body { name = 'a', solid = true, hinge = { axis = { 0, 1, 0 }, inertia = 0.25 } "
        "} "
        "world:body { name = 'c' } b = world:body { name = 'b', solid = true, hinge = { axis = { "
        "0, 0, "
        "1 }, inertia = 1 } } print(a.angle, a.arm)",
        "a.angle, a.spin, a.inertia, b.torque, b.arm, b.load_torque");
    CHECK(printing.lesson.prints == "0.0\t0.0;");
    LessonFrame frame = printing.lesson.frame();
    frame.hinges = {{45 * kDegree_rad, -10 * kDegree_rad, 0, 0, 0}, {0, 0, -0.5, 0.25, 0.75}};
    CHECK(printing.of(frame) == "45.0\t-10.0\t0.25\t-0.5\t0.25\t0.75;");
    // On another pivot it is harder to turn.
    frame.hinges[0].inertia_kg_m2 = 0.75;
    CHECK(printing.of(frame) == "45.0\t-10.0\t0.75\t-0.5\t0.25\t0.75;");
}

TEST_CASE("kite api: it tells how it flies") {
    Printing printing(
        "a = world:kite { line = 15, knot = 0.7 }",
        "a.altitude, a.lift, a.drag, a.weight, a.tension > 4, a.pull > 3, a.wind, a.speed, "
        "a.line, a.snapped, a.z, math.floor(a.angle + 0.5), a.position.x");
    LessonFrame frame = printing.lesson.frame();
    frame.kite = make_kite_state();
    CHECK(printing.of(frame) ==
          "12.0\t4.0\t1.5\t0.25\ttrue\ttrue\t6.0\t2.0\t14.5\tfalse\t1.0\t20\t4.0;");
    // A gust from above presses it down.
    frame.kite->lift_W = {0.0, -0.8, 0.6};
    CHECK(printing.of(frame).find("\t-1.0\t") != std::string::npos);
}

TEST_CASE("materials: what they are like is known once the lesson runs, to the hand too") {
    HostedLesson lesson;
    REQUIRE(
        lesson.load(
            "local a function L:start(world) a = world:body { name = 'a', solid = true, material = "
            "'rock' } print(a.material.stiffness) end\nfunction L:update() "
            "print(a.material.hardness, a.material.roughness, a.material.slipperiness, "
            "a.material.stiffness) end",
            "return function(hand, t, world) print(world:find('a').material.roughness) end") == "");
    CHECK(lesson.play(lesson.frame({ReadyEvent{{0.0}, 1.0, {{0.75, 0.5, 0.25, 160.0}}}})) == "");
    // Softer than it was declared, where the device needs that.
    CHECK(lesson.prints == "1000.0;0.75\t0.5\t0.25\t160.0;0.5;");
}

TEST_CASE(
    "world: time, the tool, what there is, the day and the past are known once the lesson runs") {
    Printing printing(
        "world:recall() world:body { name = 'apple' } world:body { name = 'egg' }",
        "#world:bodies(), world:bodies()[2], world:find 'egg', world.time, world.day, "
        "world:tool().x, world:tool().vy, world:tool().position.z, world:tool().force, "
        "world:tool().torque, world:tool().turn.z");
    CHECK(printing.lesson.host->description().wants_past);
    ReadyEvent ready;
    ready.day = 9669.5;
    LessonFrame frame = printing.lesson.frame({ready});
    frame.time_s = 1.5;
    frame.tool_pose_W.position = Vector3(1, 2, 3);
    frame.tool_pose_W.orientation = compute_exp(Vector3(0, 0, std::numbers::pi / 4));
    frame.tool_twist_W.linear = Vector3(0, -4, 0);
    frame.applied_W = {Vector3(3, 0, 4), Vector3(0, 0.3, 0.4)};
    CHECK(printing.of(frame) == "2\tegg\tegg\t1.5\t9669.5\t1.0\t-4.0\t3.0\t5.0\t0.5\t45.0;");
    Printing recalling("world:recall()",
                       "#world.past, world.past[1].lesson, world.past[1].question, "
                       "world.past[1].asked, world.past[1].right, world.past[1].wrong_now, "
                       "world.past[1].days, world.past[1].points.article");
    ready.past = {{"lever", "near_far", 3, 2, 1, 0.5, {{"article", 4}}}};
    CHECK(recalling.of(recalling.lesson.frame({ready})) == "1\tlever\tnear_far\t3\t2\t1\t0.5\t4;");
}

TEST_CASE(
    "room: it knows which lessons are there and how well they went, and can be left for one") {
    HostedLesson lesson;
    REQUIRE(
        lesson.load("function L:start(world) world:room() end\n"
                    "function L:update(world)\n"
                    "  local tool, known = world:tool(), world.lessons\n"
                    "  if tool.pressed then return world:enter(known[2].name) end\n"
                    "  print(#known, known[1].name, known[1].title, known[1].level, known[1].icon, "
                    "known[1].stars, known[2].stars)\n"
                    "end") == "");
    CHECK(lesson.host->description().is_room);
    ReadyEvent ready;
    ready.lessons = {{"gravity", "Which?", "A1", "apple", 2}, {"own", "Mine", "", "", -1}};
    CHECK(lesson.play(lesson.frame({ready})) == "");
    CHECK(lesson.prints == "2\tgravity\tWhich?\tA1\tapple\t2\t-1;");
    HostedLesson wrong;
    REQUIRE(wrong.load("function L:start(world) world:room() end\n"
                       "function L:update(world) world:enter 'gravitty' end") == "");
    CHECK(wrong.play(wrong.frame({ready})) ==
          "lesson.lua:3: there is no lesson \"gravitty\" to enter; world.lessons has those that "
          "are here.");
    LessonFrame pressed = lesson.frame();
    pressed.buttons = 2;  // the second one
    CHECK(lesson.play(pressed) == "");
    CHECK(lesson.reply.commands.size() == 1);  // its print
    pressed.buttons = 3;
    CHECK(lesson.play(pressed) == "");
    REQUIRE(lesson.reply.commands.size() == 1);
    CHECK(std::get<EnterCommand>(lesson.reply.commands[0]).lesson == "own");
}

TEST_CASE("declarations: a lesson is told how many hands are there, and where each is") {
    HostedLesson lesson;
    lesson.says = ", hands = 2";
    REQUIRE(lesson.load("local right, left\n"
                        "function L:start(world) right, left = world:hand {}, world:hand {} end\n"
                        "function L:update(world)\n"
                        "  local tool = left.tool\n"
                        "  print(world.hands, right.there, left.there, right.tool.x, tool and "
                        "tool.x or 'none', tool and tool.force or 'none')\n"
                        "end") == "");
    LessonFrame frame = lesson.frame();
    frame.tool_pose_W.position.x() = 0.5;
    CHECK(lesson.play(frame) == "");
    frame.more_hands = {{Pose::at(Vector3(-0.25, 0, 0)), {}, {Vector3(0, 3, 4), Vector3::Zero()}}};
    CHECK(lesson.play(frame) == "");
    CHECK(lesson.prints == "1\ttrue\tfalse\t0.5\tnone\tnone;2\ttrue\ttrue\t0.5\t-0.25\t5.0;");
}

TEST_CASE("lesson: tries and sureness are a conversation's own where none are said") {
    CHECK(LessonDescription{}.tries == dialogue::ConversationSettings{}.tries);
    CHECK(LessonDescription{}.sureness == dialogue::ConversationSettings{}.least_confidence);
}

TEST_CASE("nouns: a noun means a body only when one has it") {
    LessonDescription lesson;
    for (const char* noun : {"apple", "tennis ball", "the Moon", "apple"}) {
        lesson.bodies.emplace_back();
        lesson.bodies.back().noun = noun;
    }
    CHECK(body_with_noun(lesson, "tennis ball") == 1);
    CHECK(body_with_noun(lesson, "Moon") == 2);
    CHECK(body_with_noun(lesson, "apple") == kNoBody);
    CHECK(count_noun(lesson, "apple") == 2);
    CHECK(body_with_noun(lesson, "egg") == kNoBody);
}

TEST_CASE("nouns: an answer knows the bodies that its slots speak of") {
    HostedLesson lesson;
    REQUIRE(lesson.load(R"(
local ball
function L:start(world)
  ball = world:body { name = "b1", noun = "tennis ball" }
  for _, name in ipairs { "s1", "s2" } do world:body { name = name, noun = "stone" } end
end
L:question "q" { prompt = "?", answers = { "a" }, right = function(a) return a.bodies.thing == ball end }
function L:answered(a) print(a.thing, a.bodies.thing == ball, a.bodies.other, a.bodies.size) end)") ==
            "");
    const std::vector<std::pair<std::string, std::string>> slots{
        {"thing", "tennis ball"}, {"other", "stone"}, {"size", "big"}};
    REQUIRE(lesson.play(lesson.frame({JudgeEvent{"q", {{"thing", "tennis ball"}}},
                                      AnsweredEvent{"q", "", slots}})) == "");
    REQUIRE(lesson.commands<VerdictCommand>().size() == 1);
    CHECK(lesson.commands<VerdictCommand>()[0].right);
    CHECK(lesson.prints == "tennis ball\ttrue\tnil\tnil;");
}
