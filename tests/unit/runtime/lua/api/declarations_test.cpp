#include "dialogue/conversation/conversation.h"
#include "haptics/math/rotation.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>

using namespace fulcrum::runtime::test;

TEST_CASE("actions: each becomes its command, in order") {
    HostedLesson lesson;
    REQUIRE(lesson.load("L:question 'q' { prompt = '?', answers = { 'a' }, right = print }\n"
                        "function L:update(world) world:caption 'c' world:ask 'q' world:score(-3) "
                        "world:level(2, 'Two') world:level(3) world:sound 'pop' "
                        "world:finish { stars = 2 } end") == "");
    REQUIRE(lesson.play() == "");
    REQUIRE(lesson.reply.commands.size() == 7);
    CHECK(std::get<CaptionCommand>(lesson.reply.commands[0]).text == "c");
    CHECK(std::get<AskCommand>(lesson.reply.commands[1]).question == "q");
    CHECK(std::get<ScoreCommand>(lesson.reply.commands[2]).score == -3);
    CHECK(std::get<LevelCommand>(lesson.reply.commands[3]).level == 2);
    CHECK(std::get<LevelCommand>(lesson.reply.commands[3]).title == "Two");
    CHECK(std::get<LevelCommand>(lesson.reply.commands[4]).title.empty());
    CHECK(std::get<SoundCommand>(lesson.reply.commands[5]).name == "pop");
    CHECK(std::get<FinishCommand>(lesson.reply.commands[6]).stars == 2);
}

TEST_CASE("actions: looking things up") {
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:start(world) world:body { name = 'apple' } world:body { name = "
                        "'egg' } end\n"
                        "function L:update(world) local t = world:tool() print(#world:bodies(), "
                        "world:bodies()[2], world:find 'egg', world.time, t.x, t.vy, t.position.z, "
                        "t.force, t.torque, t.turn.z) end") == "");
    LessonFrame frame = lesson.frame();
    frame.time_s = 1.5;
    frame.tool_pose_W.position = Vector3(1, 2, 3);
    frame.tool_pose_W.orientation = compute_exp(Vector3(0, 0, std::numbers::pi / 4));
    frame.tool_twist_W.linear = Vector3(0, -4, 0);
    frame.applied_W = {Vector3(3, 0, 4), Vector3(0, 0.3, 0.4)};
    REQUIRE(lesson.play(frame) == "");
    CHECK(lesson.prints == "2\tegg\tegg\t1.5\t1.0\t-4.0\t3.0\t5.0\t0.5\t45.0;");
}

TEST_CASE("past: a lesson that asks for it is told what was answered before, once it runs") {
    HostedLesson lesson;
    REQUIRE(lesson.load("function L:start(world) world:recall() end\n"
                        "function L:update(world)\n"
                        "  for i, p in ipairs(world.past) do\n"
                        "    print(i, p.lesson, p.question, p.asked, p.right, p.wrong_now, p.days, "
                        "p.points.article)\n"
                        "  end\nend") == "");
    CHECK(lesson.host->description().wants_past);
    ReadyEvent ready;
    ready.past = {{"lever", "near_far", 3, 2, 1, 0.5, {{"article", 4}}}};
    REQUIRE(lesson.play(lesson.frame({ready})) == "");
    CHECK(lesson.prints == "1\tlever\tnear_far\t3\t2\t1\t0.5\t4;");
}

TEST_CASE("declarations: everything that is said arrives, with its line") {
    HostedLesson lesson;
    REQUIRE(lesson.start(R"(
  world:gravity(1.62) world:ground(-0.5)
  world:camera { eye = { 1, 2, 3 }, target = { 4, 5, 6 }, angle = 50 }
  world:hand { centre = { 7, 8, 9 }, scale = 2, rate = 2000 }
  world:body { name = "a", noun = "apple", model = "fruit", radius = .1, mass = 2, exaggeration = 3, drag_area = .4, solid = true, movable = true, visible = true, at = { 1, 1, 1 } }
  world:bucket { model = "pail", radius = .2, depth = .3, holds = 4 }
  world:spring { name = "s", at = { 1, 0, 0 }, stiffness = 100, damping = 1 }
  world:viscosity { damping = 2 }
  world:magnet { at = { 0, 1, 0 }, force = 3, range = .2 })") == "");
    const LessonDescription& d = lesson.host->description();
    CHECK(d.gravity_W == Vector3(0, -1.62, 0));
    CHECK(d.ground_height_m == -0.5);
    CHECK(d.camera.eye_W == Vector3(1, 2, 3));
    CHECK(d.camera.target_W == Vector3(4, 5, 6));
    CHECK(d.camera.vertical_angle_deg == 50.0);
    CHECK(d.hand.centre_W == Vector3(7, 8, 9));
    CHECK(d.hand.scale == 2.0);
    CHECK(d.hand.rate_hz == 2000.0);
    const BodyDescription& a = d.bodies.at(0);
    CHECK((a.noun == "apple" && a.model == "fruit" && a.radius_m == 0.1 && a.mass_kg == 2 &&
           a.exaggeration == 3));
    CHECK((a.drag_area_m2 == 0.4 && a.solid && a.movable && a.visible && a.line == 6));
    CHECK((d.bucket.model == "pail" && d.bucket.opening_radius_m == 0.2 &&
           d.bucket.depth_m == 0.3 && d.bucket.holds == 4 && d.bucket.line == 7));
    REQUIRE(d.forces.size() == 3);
    CHECK((d.forces[0].field.kind == FieldKind::spring &&
           d.forces[0].field.stiffness_N_per_m == 100 && d.forces[0].field.damping_Ns_per_m == 1));
    CHECK((d.forces[0].field.anchor_W == Vector3(1, 0, 0) && d.forces[0].line == 8));
    CHECK((d.forces[1].name == "viscosity1" && d.forces[1].field.kind == FieldKind::viscosity &&
           d.forces[1].field.damping_Ns_per_m == 2));
    CHECK((d.forces[2].name == "magnet1" && d.forces[2].field.kind == FieldKind::magnet &&
           d.forces[2].field.peak_force_N == 3));
    CHECK((d.forces[2].field.range_m == 0.2 && d.forces[2].field.anchor_W == Vector3(0, 1, 0)));
}

TEST_CASE("declarations: a second hand has a place of its own, where the lesson says so") {
    HostedLesson lesson;
    lesson.says = ", hands = 2";
    REQUIRE(lesson.start("world:hand { centre = { 0.1, 0.2, 0 }, rate = 2000 }\n"
                         "local left = world:hand { centre = { -0.1, 0.2, 0 }, scale = 2, cursor = "
                         "'ball', cursor_size = 0.01, needed = true }\n"
                         "print(left)") == "");
    const LessonDescription& d = lesson.host->description();
    CHECK(d.hand.centre_W == Vector3(0.1, 0.2, 0));
    CHECK_FALSE(d.hand.needed);
    REQUIRE(d.more_hands.size() == 1);
    CHECK(d.more_hands[0].centre_W == Vector3(-0.1, 0.2, 0));
    CHECK(d.more_hands[0].scale == 2.0);
    CHECK(d.more_hands[0].line == 3);
    CHECK(d.more_hands[0].needed);
    CHECK(std::get<SphereShape>(d.more_hands[0].cursor).radius_m == 0.01);
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
    CHECK(lesson.prints == "1\ttrue\tfalse\t0.5\tnone\tnone;");
    lesson.prints.clear();
    frame.more_hands = {{Pose::at(Vector3(-0.25, 0, 0)), {}, {Vector3(0, 3, 4), Vector3::Zero()}}};
    CHECK(lesson.play(frame) == "");
    CHECK(lesson.prints == "2\ttrue\ttrue\t0.5\t-0.25\t5.0;");
}

TEST_CASE("declarations: the hand is declared once, and is a thing of its own") {
    HostedLesson lesson;
    REQUIRE(lesson.start("local h = world:hand { scale = 2 } print(h, h == h, h ~= world)\n"
                         "h:force(function() return 0, 0, 0 end)") == "");
    CHECK(lesson.prints == "hand\ttrue\ttrue;");
    CHECK(lesson.host->description().hand.scale == 2.0);
    CHECK(lesson.host->description().hand.lesson_force);
    CHECK(lesson.host->description().hand.force_line == 3);
    // Not even the same again: a second {} would take back what the first said.
    // One that was refused was not declared.
    HostedLesson again;
    CHECK(again.start("print(pcall(world.hand, world, { scale = 0 })) world:hand { scale = 3 }") ==
          "");
    CHECK(again.host->description().hand.scale == 3.0);
    CHECK_FALSE(again.host->description().hand.lesson_force);
    HostedLesson late;
    REQUIRE(late.load("local h function L:start(world) h = world:hand {} end function L:update() "
                      "h:force(print) end") == "");
    CHECK(late.play() ==
          "lesson.lua:2: hand:force declares something; that is only possible in L:start.");
}

TEST_CASE("declarations: forces without a name are counted by kind, past names that are taken") {
    HostedLesson lesson;
    REQUIRE(lesson.start("local at = { 0, 0, 0 } local function spring(n) return world:spring { "
                         "name = n, at = at, stiffness = 1 } end\n"
                         "print(spring().name, world:viscosity { damping = 1 }.name, "
                         "spring('spring3').name, spring().name, spring().name)") == "");
    CHECK(lesson.prints == "spring1\tviscosity1\tspring3\tspring2\tspring4;");
}

TEST_CASE("forces: each change is sent whole, with what was changed before") {
    HostedLesson lesson;
    REQUIRE(lesson.load("local s, m function L:start(world) s = world:spring { name = 's', at = { "
                        "1, 2, 3 }, stiffness = 5 } "
                        "m = world:magnet { at = { 0, 0, 0 }, force = 2 } end\n"
                        "function L:update() s:off() s:strength(0.25) s:move { at = { 4, 5, 6 } } "
                        "s:on() m:strength(0) print(s.name, m.name) end") == "");
    REQUIRE(lesson.play() == "");
    const auto changes = lesson.commands<FieldChangeCommand>();
    REQUIRE(changes.size() == 5);
    CHECK(changes[0].force == 0);
    CHECK_FALSE(changes[0].field.on);
    CHECK(changes[0].field.anchor_W == Vector3(1, 2, 3));
    CHECK(changes[0].field.strength == 1.0);
    CHECK(changes[1].field.strength == 0.25);
    CHECK_FALSE(changes[1].field.on);
    CHECK(changes[2].field.anchor_W == Vector3(4, 5, 6));
    CHECK(changes[3].field.on);
    CHECK(changes[3].field.anchor_W == Vector3(4, 5, 6));
    CHECK(changes[4].force == 1);
    CHECK(changes[4].field.strength == 0.0);
    CHECK(lesson.prints == "s\tmagnet1;");
}

TEST_CASE("lesson: head, questions and tests arrive, with their lines") {
    HostedLesson lesson;
    REQUIRE(
        lesson.load("\nL:question \"heaviest\" {\n prompt = 'Which?', answers = { 'the "
                    "{thing}' }, right = print }\n"
                    "L:question('lightest', { prompt = 'Which?', answers = { 'a' }, again = 'Lift "
                    "both.', right = print })\nL:test { hand = 'sweep.lua', say = { 'a' }, expect "
                    "= {} }") == "");
    const LessonDescription& d = lesson.host->description();
    CHECK((d.id == "t" && d.title == "T"));
    REQUIRE(d.questions.size() == 2);
    CHECK((d.questions[0].id == "heaviest" && d.questions[0].prompt == "Which?"));
    CHECK(d.questions[0].line == 3);
    CHECK((d.questions[1].id == "lightest" && d.questions[1].line == 5));
    CHECK((d.questions[0].again.empty() && d.questions[1].again == "Lift both."));
    CHECK((d.tests.at(0).hand == "sweep.lua" && d.tests[0].say == std::vector<std::string>{"a"} &&
           d.tests[0].line == 6));
}

TEST_CASE("lesson: tries and sureness arrive") {
    HostedLesson usual;
    REQUIRE(usual.load("") == "");
    CHECK(usual.host->description().tries == dialogue::ConversationSettings{}.tries);
    CHECK(usual.host->description().sureness == dialogue::ConversationSettings{}.least_confidence);
    HostedLesson own;
    own.says = ", tries = 2, sureness = 0.75";
    REQUIRE(own.load("") == "");
    CHECK(own.host->description().tries == 2);
    CHECK(own.host->description().sureness == 0.75);
}

TEST_CASE("lesson: examples of a question and a test's learner arrive") {
    HostedLesson lesson;
    REQUIRE(lesson.load("L:question 'q' { prompt = '', answers = { 'a' }, right = print,\n"
                        "  examples = { right = { 'a', 'b' }, form = { 'c' } } }\n"
                        "L:test { learner = { wrong = 0.25, form = 0.5 } }") == "");
    const LessonDescription& d = lesson.host->description();
    CHECK(d.questions.at(0).examples.right == std::vector<std::string>{"a", "b"});
    CHECK(d.questions[0].examples.wrong.empty());
    CHECK(d.questions[0].examples.form == std::vector<std::string>{"c"});
    REQUIRE(d.tests.at(0).learner);
    CHECK((d.tests[0].learner->wrong == 0.25 && d.tests[0].learner->form == 0.5 &&
           d.tests[0].learner->unclear == 0.0));
}
