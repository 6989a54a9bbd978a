#include "runtime/lesson/compose_view.h"
#include "runtime/lesson/hand_fit.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// Something to push against, and a force of the lesson's own.
LessonDescription with_forces() {
    LessonDescription lesson = two_things();
    ForceDescription magnet;
    magnet.field.anchor_W = {0.1, 0.2, 0.3};
    lesson.forces.push_back(magnet);
    lesson.hand.lesson_force = true;
    return lesson;
}

const char* const kArmName = "udp:arm:4701";

HandSetting kept_as(const LearnerId& learner, const std::string& device, const std::string& name,
                    const std::string& value) {
    return {random_record_id(), learner, device, name, value, 1};
}

HandFit fit_of(const std::vector<std::pair<std::string, std::string>>& words) {
    HandFit fit;
    for (const auto& [name, value] : words) {
        REQUIRE(set_fit(fit, name, value));
    }
    return fit;
}

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

TEST_CASE("commands: a drop pops, a held thing sounds like itself, and the world gets both") {
    Play play;
    play.frame();
    MoveCommand drop;
    drop.move.kind = WorldCommand::Kind::drop;
    drop.move.body = 0;
    MoveCommand hold;
    hold.move.kind = WorldCommand::Kind::hold;
    hold.move.body = 1;
    const SessionOutput output = play.reply({drop, hold});
    CHECK(output.sounds == std::vector<std::string>{"pop", "catch_egg"});
    REQUIRE(output.world.size() == 2);
    CHECK(output.world[0].kind == WorldCommand::Kind::drop);
    CHECK(output.world[1].body == 1);
}

TEST_CASE("commands: a declared force is on where it was declared until the lesson changes it") {
    Play play(with_forces());
    play.frame();
    CHECK(play.reply().force.fields[0].anchor_W == Vector3(0.1, 0.2, 0.3));
    FieldChangeCommand change;
    change.field.anchor_W = {1.0, 0.0, 0.0};
    CHECK(play.reply({change}).force.fields[0].anchor_W == Vector3(1.0, 0.0, 0.0));
    change.force = 1;
    CHECK(play.refuses(change));
}

TEST_CASE("commands: a cloth lies on one body until it is taken away") {
    Play play;
    play.frame();
    (void)play.reply({CoverCommand{1, true}});
    CHECK(play.session->hud().covered == std::vector<bool>{false, true});
    (void)play.reply({CoverCommand{1, false}});
    (void)play.reply({ShowHandCommand{Vector3(0.1, 0.2, 0.3)}});
    CHECK(play.session->hud().shown_hand_W == Vector3(0.1, 0.2, 0.3));
    (void)play.reply({ShowHandCommand{}});
    CHECK_FALSE(play.session->hud().shown_hand_W);
    CHECK(play.session->hud().covered == std::vector<bool>{false, false});
    CHECK(play.refuses(CoverCommand{2, true}));
    CHECK(play.refuses(CoverCommand{-1, true}));
}

TEST_CASE("commands: what was felt of a body is shown until it is taken away") {
    Play play;
    play.frame();
    (void)play.reply({MarkCommand{1, 2.5}});
    CHECK(play.session->hud().marked_N == std::vector<double>{0.0, 2.5});
    (void)play.reply({MarkCommand{1, 0.0}});
    CHECK(play.session->hud().marked_N == std::vector<double>{0.0, 0.0});
    CHECK(play.refuses(MarkCommand{2, 1.0}));
    CHECK(play.refuses(MarkCommand{-1, 1.0}));
}

TEST_CASE("commands: a body is lit until it is lit otherwise, and its sign with it") {
    Play play;
    play.frame();
    const LessonDescription lesson = two_things();
    const Plan plan = compile_plan(lesson, {}, nullptr).value();
    const auto shown = [&] {
        return compose_view(lesson, plan, play.session->hud(), Scenery{}, torque_words());
    };
    CHECK(shown().lights.empty());
    (void)play.reply({LightCommand{0, BodyLight::offered}, LightCommand{1, BodyLight::lit}});
    CHECK(shown().lights == std::vector<bool>{false, true});
    (void)play.reply({LightCommand{0, BodyLight::lit}, LightCommand{1, BodyLight::off}});
    CHECK(shown().lights == std::vector<bool>{true});
    CHECK(play.refuses(LightCommand{2, BodyLight::lit}));
    CHECK(play.refuses(LightCommand{-1, BodyLight::lit}));
}

TEST_CASE("commands: a force of the lesson's own carries the time of its frame") {
    Play play(with_forces());
    play.time_s = 4.0;
    play.frame();
    LessonForceCommand force;
    force.force.force_W = {0.0, 1.0, 0.0};
    const SessionOutput output = play.reply({force});
    CHECK(output.force.linearised.stamp_s == 4.0);
    CHECK(output.force.linearised.force_W.y() == 1.0);
}

TEST_CASE("commands: an instruction replaces the last; a reply stands until it is read") {
    Play play;
    play.frame();
    play.say_rightly("apple is most heavy");
    CHECK_FALSE(play.session->hud().feedback.empty());
    play.reply({CaptionCommand{"Catch the egg!"}});
    CHECK(play.session->hud().caption == "Catch the egg!");
    CHECK_FALSE(play.session->hud().feedback.empty());
    (void)play.wait(10.0);
    CHECK(play.session->hud().caption == "Catch the egg!");
    CHECK(play.session->hud().feedback.empty());
}

TEST_CASE("commands: a higher level is heard, the first is not") {
    Play play;
    play.frame();
    CHECK(play.reply({LevelCommand{1, "one"}}).sounds.empty());
    CHECK(play.reply({LevelCommand{2, "two"}}).sounds == std::vector<std::string>{"level_up"});
    CHECK(play.reply({LevelCommand{2, "two"}}).sounds.empty());
    CHECK(play.session->hud().level_title == "two");
    CHECK(play.session->result().level == 2);
}

TEST_CASE("commands: sounds, prints and the score go where they belong") {
    Play play;
    play.frame();
    const SessionOutput output =
        play.reply({SoundCommand{"bell"}, PrintCommand{"for the teacher"}, ScoreCommand{7}});
    CHECK(output.sounds == std::vector<std::string>{"bell"});
    CHECK(output.printed == std::vector<std::string>{"for the teacher"});
    CHECK(play.session->hud().score == 7);
    CHECK(play.session->result().score == 7);
}

TEST_CASE("hand fit: what is said in words is what is set, and says itself again") {
    const std::vector<std::pair<std::string, std::string>> words = {
        {"scale", "1.5"}, {"axes", "-x,z,y"}, {"middle", "0.02,-0.1,0"},
        {"clutch", "2"},  {"handed", "left"}, {"checked", "good"}};
    const HandFit fit = fit_of(words);
    CHECK(fit.scale == 1.5);
    CHECK(fit.middle_A == Vector3(0.02, -0.1, 0.0));
    CHECK(fit.clutch_button == 2);
    CHECK(fit.left_handed == true);
    CHECK(words_of(fit) == words);
    const DeviceFit device = device_fit(fit);
    CHECK(validate(device));
    CHECK(device.axes.text() == "-x,z,y");
    CHECK(device_fit({}).axes.is_plain());
    CHECK_FALSE(device_fit({}).left_handed);
    CHECK(device_fit(fit_of({{"clutch", "none"}, {"handed", "right"}})).clutch_button == 0);
}

TEST_CASE("hand fit: what cannot be is refused in a sentence, and nothing is set") {
    const std::pair<const char*, std::vector<const char*>> bad[] = {
        {"scale", {"0", "-1", "4.01", "nan", "inf", "", "1x", "1e300"}},
        {"axes", {"x,y", "x,x,z"}},
        {"middle", {"0,0", "0,0,0,0", "0,nan,0", "0,0.6,0", "a,b,c"}},
        {"clutch", {"0", "9", "12", ""}},
        {"handed", {"both"}},
        {"checked", {""}},
        {"force", {"10"}},
        {"", {"1"}}};
    for (const auto& [name, values] : bad) {
        for (const char* value : values) {
            CAPTURE(name, value);
            HandFit fit;
            CHECK(refusal_of(set_fit(fit, name, value)).ends_with('.'));
            CHECK(words_of(fit).empty());
        }
    }
}

TEST_CASE("hand fit: what is said now goes before what was kept") {
    const HandFit kept = fit_of({{"scale", "2"}, {"handed", "left"}});
    const HandFit all = join(fit_of({{"scale", "3"}}), kept);
    CHECK(all.scale == 3.0);
    CHECK(all.left_handed == true);
    CHECK(words_of(join({}, kept)) == words_of(kept));
}

TEST_CASE("hand fit: of a learner and a device the newest counts; the hand is the same with all") {
    const LearnerId mina = random_record_id();
    const LearnerId tom = random_record_id();
    ProgressData data;
    data.hands = {
        kept_as(mina, kArmName, "scale", "2"), kept_as(mina, kArmName, "scale", "1.5"),
        kept_as(mina, "mouse", "clutch", "4"), kept_as(mina, kAnyDevice, "handed", "left"),
        kept_as(tom, kArmName, "scale", "3"),  kept_as(tom, kArmName, "checked", "good")};
    const KeptFit kept = find_fit(data, mina, kArmName);
    CHECK(kept.notices.empty());
    CHECK(words_of(kept.fit) == words_of(fit_of({{"scale", "1.5"}, {"handed", "left"}})));
    CHECK(find_fit(data, mina, "hid:046d:c626").fit.left_handed == true);
    CHECK(words_of(find_fit(data, random_record_id(), kArmName).fit).empty());
}

TEST_CASE("hand fit: kept words that cannot be are passed over, told, and leave what was good") {
    const LearnerId mina = random_record_id();
    ProgressData data;
    data.hands = {kept_as(mina, kArmName, "scale", "2"), kept_as(mina, kArmName, "scale", "1e9"),
                  kept_as(mina, kArmName, "max_force", "99"),
                  kept_as(mina, kArmName, "axes", "x;y;z")};
    const KeptFit kept = find_fit(data, mina, kArmName);
    CHECK(kept.fit.scale == 2.0);
    CHECK_FALSE(kept.fit.axes);
    REQUIRE(kept.notices.size() == 3);
    check_says(kept.notices[0], {"scale is \"1e9\""});
}

TEST_CASE("hand fit: is kept once for a learner and a device, and read again") {
    MemoryStore store;
    const Learner mina{random_record_id(), "Mina", 1};
    const HandFit fit = fit_of({{"scale", "2"}, {"handed", "left"}, {"checked", "good"}});
    for (int i = 0; i < 3; ++i) {
        REQUIRE(keep_fit(store, mina, kArmName, fit));
    }
    CHECK(store.data.hands.size() == 3);
    CHECK(words_of(read_fit(store, mina, kArmName).fit) == words_of(fit));
    // With another device the hand is the same, and nothing else.
    CHECK(words_of(read_fit(store, mina, "mouse").fit) == words_of(fit_of({{"handed", "left"}})));
    REQUIRE(keep_fit(store, mina, kArmName, fit_of({{"scale", "3"}})));
    CHECK(store.data.hands.size() == 4);
    CHECK(read_fit(store, mina, kArmName).fit.scale == 3.0);
}

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
