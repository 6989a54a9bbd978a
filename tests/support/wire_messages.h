// Messages with something in every field, for tests of the wire and as what its fuzzer begins with.
#pragma once

#include "runtime/lua/wire/wire.h"

namespace fulcrum::test {

using namespace runtime;

inline LessonDescription full_description() {
    LessonDescription d;
    d.id = "gravity";
    d.title = "Which fruit is the heaviest? \xE2\x98\x85";
    d.level = "A1";
    d.minutes = 15;
    d.force_limit_N = 2.5;
    d.free_english = true;
    d.feedback = {dialogue::FeedbackStep::prompt};
    d.tries = 3;
    d.sureness = 0.25;
    d.gravity_W = Vector3(0, -1.62, 0);
    d.ground_height_m = 0.25;
    MaterialDescription felt;
    felt.felt.name = "felt";
    felt.felt.coupling.stiffness_N_per_m = 300.0;
    felt.felt.friction = {0.6, 0.5, 2.0};
    felt.felt.texture = {ImageTexture{nullptr, 0.02, 0.03}, TextureLaw::lateral, 4e-4, 2.0};
    felt.felt.transient.kind = TransientKind::decaying_sinusoid;
    felt.look = "wood";
    felt.image = "Felt.JPG";
    felt.line = 11;
    MaterialDescription gravel;
    gravel.felt.name = "gravel";
    gravel.felt.texture.source = NoiseTexture{0.001, 0.004, 7};
    d.materials = {felt, gravel};
    d.bodies = {
        {"apple", "apple", "apple", 0.04, 0.204, 3, 0.01, true, true, true, Vector3(0, 1, 0), 12},
        {"egg", "egg", "egg", 0.03, 0.06, 1, 0, false, true, false, Vector3(1, 2, 3), 13}};
    d.forces = {{"s", {FieldKind::spring, Vector3(0, 0.3, 0), 100, 1, 0, 0.1}, 14},
                {"m", {FieldKind::magnet, Vector3(1, 0, 0), 0, 0, 4, 0.2}, 15}};
    d.bucket = {true, "bucket", 0.2, 0.3, 3, 16};
    d.in_space = true;
    d.camera = {Vector3(0, 0.5, 1.5), Vector3(0, 0.3, 0), 50};
    d.hand = {Vector3(0, 0.4, 0), 2.0, 2000.0, true, 17, ProxyKind::virtual_proxy,
              SphereShape{0.01},  20};
    d.hand.tool = ToolDescription{CapsuleShape{0.02, 0.05},
                                  "",
                                  0.03,
                                  400.0,
                                  0.25,
                                  0.004,
                                  3000,
                                  ToolMethod::voxel_sampling,
                                  true,
                                  Integrator::verlet,
                                  {true, 20.0},
                                  ContactFinding::levels,
                                  0.05,
                                  150.0,
                                  PenaltyModel::linearised};
    d.more_hands = {{Vector3(-0.2, 0.4, 0), 1.5, 2000.0, false, 0, ProxyKind::friction_cone,
                     SphereShape{0.008}, 24}};
    d.more_hands[0].needed = true;
    d.bodies[1].material = 1;
    d.bodies[1].shading = {true, 55.0};
    d.more_hands[0].velocity = VelocityMethod::kalman;
    d.more_hands[0].structure = SegmentStructureKind::h_collide;
    d.contacts = {ContactMethod::iterative, FrictionShape::pyramid, 25};
    BodyDescription block;
    block.name = block.noun = block.model = "block";
    block.solid = true;
    block.size_m = Vector3(0.1, 0.2, 0.3);
    block.felt_model = "rough_block";
    block.simulated_model = "plain_block";
    block.felt_as = BodyShape::capsule;
    block.collides_as = BodyShape::cylinder;
    block.rigid = RigidDescription{.joint = JointDescription{.kind = JointKind::distance,
                                                             .to = "post",
                                                             .at_W = Vector3(1, 2, 3),
                                                             .other_at_W = Vector3(4, 5, 6),
                                                             .axis_W = Vector3(0, 1, 0),
                                                             .lowest = -1.5,
                                                             .highest = 2.5,
                                                             .speed = -0.5,
                                                             .force = 3.0,
                                                             .friction = 0.25}};
    d.bodies.push_back(block);
    d.bodies[0].hinge = AxleSettings{.axis_W = Vector3(0, 1, 0),
                                     .pivot_B = Vector3(0.1, 0.2, 0),
                                     .inertia_kg_m2 = 0.5,
                                     .mass_kg = 0.3,
                                     .centre_B = Vector3(0.1, 0.21, 0),
                                     .friction_Nm = 0.25,
                                     .lowest_rad = -1.0,
                                     .highest_rad = 2.0,
                                     .load_N = 3.0,
                                     .load_B = Vector3(-0.4, 0, 0)};
    d.kite = KiteDescription{};
    d.kite->flight.kite.shape = KiteShape::sled;
    d.kite->flight.kite.tail_m = 3.5;
    d.kite->flight.line.strength_N = 40.0;
    d.kite->cloth = "silk";
    d.kite->spar = "birch";
    d.kite->share = 0.5;
    d.kite->seen_scale = 3.0;
    d.kite->line = 21;
    d.wind = {7.5, 1.5, 0.25, Vector3(0, 0, -1), 22};
    d.questions = {{"heaviest",
                    "Which?",
                    {"the {thing}", "{thing}"},
                    {"is {thing}"},
                    {{"thing", {"apple", "egg"}}},
                    "Lift it.",
                    18,
                    {{"the egg"}, {"the apple"}, {"a egg", "egg"}},
                    {dialogue::FeedbackStep::rule, dialogue::FeedbackStep::replay},
                    {{"place", "on the table"}}}};
    d.knowledge = {{"weight",
                    {"how heavy is the {thing}"},
                    {{"thing", {"apple"}}},
                    23,
                    {"how heavy {thing}"},
                    {{"how heavy is the apple"}, {"how heavy is apple"}, {"how big is it"}},
                    {{"which", "the first one"}}}};
    d.wants_past = d.is_room = true;
    d.bodies[1].seen_scale = 0.25;
    d.tests = {{"sweep.lua",
                {"an apple"},
                LearnerRates{0.25, 0.5, 0.125},
                {{"score", "7"}},
                19,
                "left.lua"}};
    BodyDescription hedges;
    hedges.name = hedges.noun = "hedges";
    hedges.model = "box";
    hedges.about = "These are hedges.";
    hedges.boxes = {{Vector3(1, 2, 3), Vector3(0.1, 0.2, 0.3)},
                    {Vector3(-4, 0, 0), Vector3(1, 1, 1)}};
    d.bodies.push_back(hedges);
    return d;
}

/// To `full_description`.
inline LessonReply full_reply() {
    LessonReply r;
    WorldCommand drop{WorldCommand::Kind::drop, 1, Vector3(0, 1, 0), Vector3(0, -1, 0)};
    WorldCommand release;
    release.kind = WorldCommand::Kind::release;
    LinearisedWrench force;
    force.stamp_s = 1.5;
    force.force_W = Vector3(1, -2, 3);
    force.stiffness_N_per_m(0, 1) = -200;
    force.damping_Ns_per_m(2, 0) = 5;
    force.torque_W = Vector3(0.5, -0.25, 9.0);
    force.torque_stiffness_Nm_per_m(1, 2) = -450;
    r.commands = {MoveCommand{drop},
                  MoveCommand{release},
                  FieldChangeCommand{1, {false, Vector3(1, 2, 3), 0.5}},
                  LessonForceCommand{force},
                  CaptionCommand{"Catch!"},
                  AskCommand{"heaviest"},
                  VerdictCommand{"heaviest", true},
                  ScoreCommand{-7},
                  LevelCommand{2, "Two"},
                  SoundCommand{"pop"},
                  FinishCommand{3},
                  PrintCommand{"hi\tthere"},
                  CoverCommand{1, true},
                  MarkCommand{1, 2.5},
                  LightCommand{1, BodyLight::lit},
                  TurnCommand{0, 0.5, std::nullopt, Vector3(0.1, 0, 0), 4.0},
                  KiteCommand{KiteSettings{.tail_m = 4.0}, 0.5, 25.0, true, true},
                  WindCommand{8.5},
                  TellCommand{"weight", "2 newtons."},
                  ShowHandCommand{Vector3(0.1, 0.2, 0.3)},
                  EnterCommand{"gravity"}};
    r.has_hand_target = true;
    r.hand_target_W.position = Vector3(0.1, 0.2, 0.3);
    r.hand_buttons = 5;
    r.hand_key = "left";
    r.more_aims = {{true, Pose::at(Vector3(-0.1, 0.25, 0.0)), 2}};
    return r;
}

inline LessonFrame full_frame() {
    LessonFrame f;
    f.time_s = 2.5;
    f.dt_s = 1.0 / 60.0;
    f.tool_pose_W.position = Vector3(1, 2, 3);
    f.tool_twist_W.linear = Vector3(4, 5, 6);
    f.applied_W = {Vector3(0, -2, 0), Vector3(0.1, 0, -0.3)};
    f.more_hands = {{Pose::at(Vector3(-1, 2, 3)),
                     {Vector3(0.5, 0, 0), Vector3(0, 1, 0)},
                     {Vector3(0, 3, 0), Vector3(0.2, 0, 0)}}};
    f.bodies = {{Pose{}, Vector3(0, -3, 0), BodyWhere::falling},
                {Pose{}, Vector3::Zero(), BodyWhere::held}};
    f.hinges = {{0.5, -2.0, 0.25, 0.125, -0.75, 1.5}};
    f.kite = KiteState{};
    f.kite->centre_W = Vector3(10, 18, -1);
    f.kite->tension_W = Vector3(-2, -4, 0.5);
    f.kite->angle_of_attack_rad = 0.25;
    f.kite->line_m = 20.5;
    f.kite->is_snapped = true;
    f.events = {BodyEvent{BodyEvent::Kind::landed, 1, 3.5}, KeyEvent{"space"},
                JudgeEvent{"heaviest", {{"thing", "egg"}}},
                AnsweredEvent{"heaviest",
                              "an egg",
                              {{"thing", "egg"}},
                              true,
                              false,
                              true,
                              false,
                              3,
                              true,
                              true,
                              false},
                ReadyEvent{{6.0, 3.0},
                           0.5,
                           {{0.75, 0.5, 0.25}},
                           9669.0,
                           {{"lever", "near_far", 3, 2, 1, 0.5, {{"article", 4}}}},
                           {{"lever", "Lift it!", "A2", "lever", -1}}}};
    f.buttons = 5;
    f.events.push_back(AskedEvent{"weight", {{"thing", "apple"}}});
    f.only_asks = true;
    return f;
}

inline LoadMessage full_load() {
    return {
        {"lesson.lua", std::string("a\0b", 3)}, {"h.lua", "x"}, 7, 1U << 20U, 5, 6, {"l.lua", "y"}};
}

inline ModuleAnswer full_module_answer() {
    return {true, {"lib/story.lua", "return 1"}, "no"};
}

inline ScriptError full_error() {
    return {"wrong", "lesson.lua", 12};
}

}  // namespace fulcrum::test
