// A kite between loop, lesson and picture: what the lesson is told, what it orders, how the reel turns, what is seen.
#include "runtime/effect/kite/show_kite.h"

#include "haptics/flight/kite_loop.h"
#include "runtime/scene/shape_models.h"
#include "runtime/text/amounts.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

LessonDescription with_kite() {
    LessonDescription lesson = two_things();
    lesson.kite = KiteDescription{};
    lesson.kite->flight.line.length_m = 12.0;
    lesson.kite->elevation_rad = 0.5;
    lesson.kite->seen_scale = 3.0;
    lesson.wind.speed_m_per_s = 7.0;
    lesson.camera = {{5, 4, 20}, {5, 6, 0}, 45};
    return lesson;
}

KiteFrame fly(double seconds) {
    const auto channels = std::make_unique<KiteChannels>();
    KiteLoop loop(KiteFlightSettings{}, 100.0, *channels);
    channels->hand_W.publish(Vector3(0, 1, 0));
    for (int i = 1; i <= static_cast<int>(100 * seconds); ++i) {
        loop.step(0.01 * i);
    }
    (void)channels->frame.take();
    return channels->frame.value();
}

const dialogue::Catalogue& kite_words() {
    static const dialogue::Catalogue catalogue =
        dialogue::Catalogue::parse(
            "hud.force = {newtons} N\nhud.lift = lift {newtons} N\nhud.drag = drag {newtons} N\n"
            "hud.gravity = weight {newtons} N\nhud.tension = tension {newtons} N\n"
            "hud.pull = at your hand {newtons} N\n"
            "hud.scaled_pull = at your hand {felt} N, on a real kite {true} N\n")
            .value();
    return catalogue;
}

runtime::View look(const LessonDescription& lesson, const SessionHud& hud, const KiteFrame* kite) {
    Scenery scenery;
    scenery.kite = kite;
    return compose_view(lesson, compile_plan(lesson, {}, nullptr).value(), hud, scenery,
                        kite_words());
}

long count(const runtime::View& view, std::string_view model) {
    return std::ranges::count(view.bodies, model, &ViewBody::model);
}

}  // namespace

TEST_CASE("kite: the lesson is told how it flies, and orders what it says") {
    Play play(with_kite());
    CHECK_FALSE(play.frame().kite);
    SessionOutput output = play.reply();
    CHECK(output.kite.line_m == 12.0);
    CHECK(output.kite.wind_m_per_s == 7.0);
    CHECK(output.kite.elevation_rad == 0.5);
    CHECK_FALSE(output.kite_design);
    const KiteFrame flown = fly(2.0);
    SessionInput input;
    input.kite = &flown;
    const LessonFrame& frame = play.frame(input);
    REQUIRE(frame.kite);
    CHECK(frame.kite->centre_W == flown.report.centre_W);
    CHECK(frame.kite->tension_W == flown.report.tension_W);
    CHECK(frame.kite->line_m == flown.report.line_m);
    KiteCommand command;
    command.design = KiteSettings{.tail_m = 5.0};
    command.launch_elevation_rad = 0.9;
    command.line_m = 30.0;
    command.cut = true;
    command.shows_forces = true;
    output = play.reply({command, WindCommand{9.0}});
    CHECK(output.kite.n_launches == 1);
    CHECK(output.kite.n_cuts == 1);
    CHECK(output.kite.elevation_rad == 0.9);
    CHECK(output.kite.line_m == 30.0);
    CHECK(output.kite.wind_m_per_s == 9.0);
    REQUIRE(output.kite_design);
    CHECK(output.kite_design->tail_m == 5.0);
    CHECK(play.session->hud().kite.shows_forces);
    play.frame();
    output = play.reply();
    CHECK_FALSE(output.kite_design);  // once
    CHECK(output.kite.line_m == 30.0);
}

TEST_CASE("kite: wheel and buttons turn the reel, within its ends") {
    Play play(with_kite());
    SessionInput input;
    input.wheel = 3.0;
    play.frame(input);
    CHECK(play.reply().kite.line_m == Approx(12.0 + 3 * kReelByNotch_m));
    input = {};
    input.hand.buttons = 1;
    for (int i = 0; i < 60; ++i) {
        play.frame(input);
        (void)play.reply();
    }
    play.frame();
    CHECK(play.reply().kite.line_m == Approx(13.5 + kReelByButton_m_per_s));
    input.hand.buttons = 2;
    for (int i = 0; i < 30; ++i) {
        play.frame(input);
        (void)play.reply();
    }
    play.frame();
    CHECK(play.reply().kite.line_m == Approx(13.5 + 0.5 * kReelByButton_m_per_s));
    input = {};
    input.wheel = -1000.0;
    play.frame(input);
    CHECK(play.reply().kite.line_m == kShortestReel_m);
}

TEST_CASE("kite: a lesson without one is refused its commands, and so is a kite that is none") {
    Play without;
    without.frame();
    CHECK(without.refuses(KiteCommand{}));
    CHECK(without.refuses(WindCommand{3.0}));
    Play play(with_kite());
    play.frame();
    KiteCommand bad;
    bad.design = KiteSettings{.bridle_m = 0.1};
    CHECK(play.refuses(bad));
}

TEST_CASE("kite: it is seen larger about its knot, with line, bridle, tail and wind") {
    const LessonDescription lesson = with_kite();
    const KiteFrame flown = fly(10.0);
    SessionHud hud;
    hud.kite.design = KiteSettings{};
    const runtime::View view = look(lesson, hud, &flown);
    CHECK(view.kite_design == hud.kite.design);
    REQUIRE(count(view, kKiteModel) == 1);
    const auto kite = std::ranges::find(view.bodies, kKiteModel, &ViewBody::model);
    CHECK(kite->scale == Vector3::Constant(3.0));
    const Vector3 knot_W = flown.report.knot_W;
    CHECK((kite->pose_W.position - knot_W - 3.0 * (flown.report.pose_W.position - knot_W)).norm() <
          1e-12);
    CHECK(count(view, kLineModel) == 16 + 2);
    CHECK(count(view, kTailModel) == 20 + 4);  // pieces of 0.1 m, a bow at each fifth
    CHECK(count(view, kWispModel) > 10);
    CHECK(view.forces.empty());
    CHECK(std::ranges::all_of(view.bodies, [](const ViewBody& body) {
        return is_finite(body.pose_W) && body.scale.allFinite();
    }));
    // Its bars reach from node to node.
    const auto bar = std::ranges::find_if(view.bodies, [&](const ViewBody& body) {
        return body.model == kLineModel && body.pose_W.position == flown.line_W[0];
    });
    REQUIRE(bar != view.bodies.end());
    const Vector3 end_W =
        bar->pose_W.position + bar->pose_W.orientation * (bar->scale.y() * Vector3::UnitY());
    CHECK((end_W - flown.line_W[1]).norm() < 1e-9);
    hud.kite.design->tail_m = 0.0;
    CHECK(count(look(lesson, hud, &flown), kTailModel) == 0);
    CHECK(look(lesson, hud, nullptr).bodies.size() < 3);
}

TEST_CASE("kite: its four forces are shown with their newtons where they act, when wanted") {
    const LessonDescription lesson = with_kite();
    KiteFrame flown = fly(20.0);
    SessionHud hud;
    hud.kite.design = KiteSettings{};
    hud.kite.shows_forces = true;
    const runtime::View view = look(lesson, hud, &flown);
    REQUIRE(view.forces.size() == 4);
    CHECK(view.forces[0].text == "lift " + newtons_text(flown.report.lift_W.norm()) + " N");
    CHECK(view.forces[0].look == ForceLook::lift);
    CHECK(view.forces[1].force_W == flown.report.drag_W);
    CHECK(view.forces[2].text == "weight " + newtons_text(flown.report.weight_W.norm()) + " N");
    CHECK(view.forces[3].force_W == flown.report.tension_W);
    CHECK(view.forces[3].at_W == flown.report.knot_W);
}

TEST_CASE(
    "kite: the pull is told as it was sent to the hand, and the line's true one where it differs") {
    LessonDescription lesson = with_kite();
    KiteFrame flown = fly(20.0);
    flown.report.hand_force_W = {1.5, 2.0, 0.0};
    SessionHud hud;
    hud.kite.design = KiteSettings{};
    const auto told = [&](const PlanOptions& options, double felt_N) {
        Scenery scenery;
        scenery.kite = &flown;
        scenery.hand.applied_W.force = {0.0, felt_N, 0.0};
        const Plan plan = compile_plan(lesson, options, nullptr).value();
        return compose_view(lesson, plan, hud, scenery, kite_words()).force.text;
    };
    CHECK(told({}, 2.4) == "at your hand 2.4 N");
    lesson.kite->share = 0.5;
    CHECK(told({}, 1.2) == "at your hand 1.2 N, on a real kite 2.5 N");
    // Where the place allows less, the line is felt in proportion; what is above the gate's limit is not felt.
    lesson.kite->share = 1.0;
    PlanOptions weak;
    weak.device_force_limit_N = 2.5;
    CHECK(told(weak, 1.26) == "at your hand 1.3 N, on a real kite 2.5 N");
    flown.report.hand_force_W = {0.0, 21.0, 0.0};
    CHECK(told({}, 4.5) == "at your hand 4.5 N, on a real kite 21.0 N");
}

TEST_CASE("kite: the wind is seen by what it carries along, and calm air carries nothing") {
    const LessonDescription lesson = with_kite();
    KiteFrame flown = fly(5.0);
    SessionHud hud;
    hud.kite.design = KiteSettings{};
    const runtime::View before = look(lesson, hud, &flown);
    flown.report.air_way_m += 0.5;
    const runtime::View after = look(lesson, hud, &flown);
    const auto first = [](const runtime::View& view) {
        return std::ranges::find(view.bodies, kWispModel, &ViewBody::model)->pose_W.position.x();
    };
    CHECK(first(after) > first(before));
    flown.report.wind_W.setZero();
    CHECK(count(look(lesson, hud, &flown), kWispModel) == 0);
}
