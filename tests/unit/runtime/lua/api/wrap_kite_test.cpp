// Kites as lessons declare, build, fly and read them.
#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

constexpr double kDegree_rad = std::numbers::pi / 180.0;

const char* const kFlying =
    "local kite, world function L:start(w) world = w kite = world:kite { line = 15, knot = 0.7 } "
    "end\n";

KiteState make_state() {
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

TEST_CASE("kite api: what is declared is in the description, and the rest as a kite is made") {
    HostedLesson lesson;
    REQUIRE(lesson.start(
                "world:wind { speed = 7, gusts = 1, towards = { 0, 0, -0.3 }, over = 'water' }\n"
                "world:kite { shape = 'delta', cloth = 'silk', spar = 'birch', height = 1, "
                "tail = 3, fold = 10, line = 30, strength = 40, felt = 0.5, seen = 3, "
                "elevation = 30 }") == "");
    const LessonDescription& d = lesson.host->description();
    REQUIRE(d.kite);
    const KiteSettings& design = d.kite->flight.kite;
    CHECK(design.shape == KiteShape::delta);
    CHECK(design.cloth_kg_per_m2 == 0.0169);
    CHECK(design.spar_kg_per_m == 0.0241);
    CHECK(design.bridle_m == Approx(1.25));
    CHECK(design.knot_m == Approx(0.85));
    CHECK(design.tail_m == 3.0);
    CHECK(design.fold_rad == Approx(10 * kDegree_rad));
    CHECK(design.width_m == KiteSettings{}.width_m);
    CHECK(d.kite->flight.line.length_m == 30.0);
    CHECK(d.kite->flight.line.strength_N == 40.0);
    CHECK(d.kite->share == 0.5);
    CHECK(d.kite->seen_scale == 3.0);
    CHECK(d.kite->elevation_rad == Approx(30 * kDegree_rad));
    CHECK(d.kite->line == 3);
    CHECK(d.wind.speed_m_per_s == 7.0);
    CHECK(d.wind.gustiness == 1.0);
    CHECK(d.wind.roughness_m == 0.0002);
    CHECK((d.wind.downwind_W - Vector3(0, 0, -1)).norm() < 1e-12);
    CHECK(d.wind.line == 2);
}

TEST_CASE("kite api: building changes what is given and keeps the rest") {
    HostedLesson lesson;
    REQUIRE(lesson.load(std::string(kFlying) +
                        "local n = 0 function L:update() n = n + 1\n"
                        "if n == 1 then kite:build { tail = 5 } kite:build { cloth = 'paper' } "
                        "print(kite.tail, kite.knot, kite.cloth, kite.shape) kite:reel(25) "
                        "kite:fly(20) kite:cut() kite:show_forces(true) world:wind_speed(3) end "
                        "end") == "");
    REQUIRE(lesson.play() == "");
    CHECK(lesson.prints == "5.0\t0.7\tpaper\tdiamond;");
    const auto commands = lesson.commands<KiteCommand>();
    REQUIRE(commands.size() == 6);
    CHECK(commands[0].design->tail_m == 5.0);
    CHECK(commands[0].design->knot_m == 0.7);
    CHECK(commands[1].design->tail_m == 5.0);
    CHECK(commands[1].design->cloth_kg_per_m2 == 0.0564);
    CHECK(commands[2].line_m == 25.0);
    CHECK(commands[3].launch_elevation_rad.value_or(0) == Approx(20 * kDegree_rad));
    CHECK(commands[4].cut);
    CHECK(commands[5].shows_forces == true);
    REQUIRE(lesson.commands<WindCommand>().size() == 1);
    CHECK(lesson.commands<WindCommand>()[0].speed_m_per_s == 3.0);
}

TEST_CASE("kite api: it tells how it flies") {
    HostedLesson lesson;
    REQUIRE(lesson.load(std::string(kFlying) +
                        "function L:update() print(kite.altitude, kite.lift, kite.drag, "
                        "kite.weight, kite.tension > 4, kite.pull > 3, kite.wind, kite.speed, "
                        "kite.line, kite.snapped, kite.z) print(math.floor(kite.angle + 0.5), "
                        "kite.position.x) end") == "");
    LessonFrame frame = lesson.frame();
    frame.kite = make_state();
    REQUIRE(lesson.play(frame) == "");
    CHECK(lesson.prints == "12.0\t4.0\t1.5\t0.25\ttrue\ttrue\t6.0\t2.0\t14.5\tfalse\t1.0;20\t4.0;");
    // A gust from above presses it down.
    frame.kite->lift_W = {0.0, -0.8, 0.6};
    lesson.prints.clear();
    REQUIRE(lesson.play(frame) == "");
    CHECK(lesson.prints.find("\t-1.0\t") != std::string::npos);
}

}  // namespace
}  // namespace fulcrum::runtime
