#include "tests/unit/runtime/lua/hosted_lesson.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>

using namespace fulcrum::runtime::test;

namespace {

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

}  // namespace

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

TEST_CASE("materials: five lines make one out of another and a picture") {
    HostedLesson lesson;
    REQUIRE(lesson.start(R"(
  local felt = world:material {
    name = "felt", like = "wood", stiffness = 300, friction = 0.6,
    texture = { image = "Felt 2.JPG", size = 0.05, height = 0.0004, strength = 2, law = "lateral" },
  }
  world:body { name = "cushion", solid = true, material = felt }
  world:body { name = "table", solid = true, material = "wood" }
  world:body { name = "rug", solid = true, material = "felt" }
  print(felt, felt.name, felt.stiffness, felt.friction))") == "");
    CHECK(lesson.prints == "felt\tfelt\t300.0\t0.6;");
    const LessonDescription& d = lesson.host->description();
    REQUIRE(d.materials.size() == 2);
    const MaterialDescription& felt = d.materials[0];
    CHECK((felt.felt.name == "felt" && felt.look == "wood" && felt.image == "Felt 2.JPG"));
    CHECK(felt.line == 3);
    CHECK(felt.felt.coupling.stiffness_N_per_m == 300.0);
    CHECK(felt.felt.friction.static_coefficient == 0.6);
    CHECK(felt.felt.friction.dynamic_coefficient == Approx(0.48));
    const auto* image = std::get_if<ImageTexture>(&felt.felt.texture.source);
    REQUIRE(image != nullptr);
    CHECK((image->map == nullptr && image->tile_u_m == 0.05));
    CHECK((felt.felt.texture.height_m == 0.0004 && felt.felt.texture.gain == 2.0));
    CHECK(felt.felt.texture.law == TextureLaw::lateral);
    // What was not said is the wood's.
    const MaterialDescription& wood = d.materials[1];
    CHECK((wood.felt.name == "wood" && wood.line == 8));
    CHECK(felt.felt.transient.frequency_Hz == wood.felt.transient.frequency_Hz);
    CHECK(felt.felt.transient.kind == wood.felt.transient.kind);
    CHECK(d.bodies[0].material == 0);
    CHECK(d.bodies[1].material == 1);
    CHECK(d.bodies[2].material == 0);
}

TEST_CASE("materials: of numbers alone, with grooves or bumps and a tap") {
    HostedLesson lesson;
    REQUIRE(lesson.start(R"(
  world:material { name = "comb", stiffness = 500, friction = 0.5, sliding_friction = 0.3, texture = { grooves = 0.002, height = 0.0002 } }
  local m = world:material { name = "gravel", texture = { bumps = 0.004, height = 0.001 }, tap = { frequency = 200, time = 0.02, strength = 3 } }
  print(m.ring, world:material { name = "plain" }.ring))") == "");
    CHECK(lesson.prints == "200.0\t0.0;");
    const auto& materials = lesson.host->description().materials;
    CHECK(std::get<SineTexture>(materials[0].felt.texture.source).wavelength_m == 0.002);
    CHECK(materials[0].felt.friction.dynamic_coefficient == 0.3);
    CHECK(materials[0].look.empty());
    const auto& bumps = std::get<NoiseTexture>(materials[1].felt.texture.source);
    CHECK((bumps.longest_m == 0.004 && bumps.shortest_m == 0.001));
    CHECK(materials[1].felt.transient.kind == TransientKind::decaying_sinusoid);
    CHECK(materials[1].felt.transient.decay_per_s == Approx(50.0));
}

TEST_CASE("materials: a body knows what it is made of, and that it is covered") {
    HostedLesson lesson;
    REQUIRE(lesson.load(R"(local a, b
function L:start(world)
  a = world:body { name = "a", solid = true, material = "rock" }
  b = world:body { name = "b" }
  a:cover()
  print(a.material, a.material == world:find("a").material, b.material, a.covered, b.covered)
end
function L:update() a:uncover() print(a.covered) end)") == "");
    CHECK(lesson.prints == "rock\ttrue\tnil\ttrue\tfalse;");
    CHECK(lesson.play() == "");
    const auto covers = lesson.commands<CoverCommand>();
    REQUIRE(covers.size() == 2);
    CHECK((covers[0].body == 0 && covers[0].covered && !covers[1].covered));
}

TEST_CASE("materials: what they are like is known once the lesson runs, to the hand too") {
    HostedLesson lesson;
    REQUIRE(lesson.load(
                R"(local a
function L:start(world)
  a = world:body { name = "a", solid = true, material = "rock" }
end
function L:update() print(a.material.hardness, a.material.roughness, a.material.slipperiness) end)",
                "return function(hand, t, world) print(world:find('a').material.roughness) end") ==
            "");
    CHECK(lesson.play(lesson.frame({ReadyEvent{{0.0}, 1.0, {{0.75, 0.5, 0.25}}}})) == "");
    CHECK(lesson.prints == "0.75\t0.5\t0.25;0.5;");
}

TEST_CASE("hand: what touches is chosen by name") {
    HostedLesson lesson;
    REQUIRE(lesson.start(
                "world:hand { proxy = 'virtual_proxy', cursor = 'ball', cursor_size = 0.01 }") ==
            "");
    const HandDescription& hand = lesson.host->description().hand;
    CHECK(hand.proxy == ProxyKind::virtual_proxy);
    REQUIRE(std::holds_alternative<SphereShape>(hand.cursor));
    CHECK(std::get<SphereShape>(hand.cursor).radius_m == 0.01);
    CHECK(hand.line == 2);
    HostedLesson plain;
    REQUIRE(plain.start("world:hand {}") == "");
    CHECK_FALSE(plain.host->description().hand.proxy.has_value());
    CHECK(std::holds_alternative<std::monostate>(plain.host->description().hand.cursor));
    for (const char* shape : {"box", "capsule", "cylinder"}) {
        HostedLesson shaped;
        REQUIRE(shaped.start(std::string("world:hand { cursor = '") + shape + "' }") == "");
        CHECK_FALSE(std::holds_alternative<std::monostate>(shaped.host->description().hand.cursor));
    }
}

TEST_CASE("hand: it may hold a tool, of a shape or a model, by a method by name") {
    HostedLesson lesson;
    REQUIRE(
        lesson.start(
            "world:hand { tool = { shape = 'capsule', radius = 0.01, length = 0.08, mass = 0.05, "
            "stiffness = 300, turn_stiffness = 0.2, voxel = 0.004, points = 500, "
            "method = 'voxel_sampling', massless = false, integrator = 'verlet' } }") == "");
    REQUIRE(lesson.host->description().hand.tool);
    const ToolDescription& tool = *lesson.host->description().hand.tool;
    REQUIRE(std::holds_alternative<CapsuleShape>(tool.shape));
    CHECK(std::get<CapsuleShape>(tool.shape).half_length_m == Approx(0.03));
    CHECK(tool.mass_kg == 0.05);
    CHECK(tool.stiffness_N_per_m == 300);
    CHECK(tool.turn_stiffness_Nm_per_rad == 0.2);
    CHECK(tool.voxel_m == 0.004);
    CHECK(tool.points == 500);
    CHECK(tool.method == ToolMethod::voxel_sampling);
    CHECK_FALSE(tool.massless);
    CHECK(tool.integrator == Integrator::verlet);
    // Contact by levels, by a tolerance or by time.
    const auto levels_of = [](const std::string& fields) {
        HostedLesson by;
        REQUIRE(by.start("world:hand { tool = { method = 'implicit_penalty', " + fields + " } }") ==
                "");
        return *by.host->description().hand.tool;
    };
    CHECK(levels_of("mass = 0.02").contact == ContactFinding::fields);
    const ToolDescription usual = levels_of("contact = 'levels'");
    CHECK(usual.contact == ContactFinding::levels);
    CHECK(usual.detail == kUsualDetail);
    CHECK(usual.budget_us == 0.0);
    CHECK(levels_of("contact = 'levels', detail = 0.1").detail == 0.1);
    const ToolDescription timed = levels_of("contact = 'levels', budget = 150");
    CHECK(timed.budget_us == 150.0);
    CHECK(timed.detail == 0.0);
    CHECK(levels_of("contact = 'levels', budget = 150, detail = 0.05").detail == 0.05);
    // What is not said is the default; a model is in its own size.
    HostedLesson plain;
    REQUIRE(plain.start("world:hand { tool = { model = 'gear' } }") == "");
    const ToolDescription& gear = *plain.host->description().hand.tool;
    CHECK(gear.model == "gear");
    CHECK(std::holds_alternative<std::monostate>(gear.shape));
    CHECK(gear.method == ToolMethod::field_sampling);
    CHECK(gear.integrator == Integrator::backward_euler);
    CHECK_FALSE(gear.massless);
    HostedLesson massless;
    REQUIRE(massless.start("world:hand { tool = { massless = true } }") == "");
    CHECK(massless.host->description().hand.tool->massless);
    HostedLesson rounded;
    REQUIRE(rounded.start("world:body { name = 'a', solid = true, rounded = true } "
                          "world:hand { tool = { method = 'god_object', rounded = true } }") == "");
    CHECK(rounded.host->description().bodies[0].rounded);
    CHECK(rounded.host->description().hand.tool->rounded);
    // A ball or a box by name is as large as the radius says, to be felt and to be seen.
    for (const char* ball : {"sphere", "earth"}) {
        HostedLesson round;
        REQUIRE(round.start(std::string("world:hand { tool = { radius = 0.03, model = '") + ball +
                            "' } }") == "");
        const ToolDescription& held = *round.host->description().hand.tool;
        CHECK(held.model == ball);
        REQUIRE(std::holds_alternative<SphereShape>(held.shape));
        CHECK(std::get<SphereShape>(held.shape).radius_m == 0.03);
    }
    HostedLesson box;
    REQUIRE(box.start("world:hand { tool = { model = 'box' } }") == "");
    REQUIRE(std::holds_alternative<BoxShape>(box.host->description().hand.tool->shape));
    CHECK(std::get<BoxShape>(box.host->description().hand.tool->shape).half_size_m ==
          Vector3::Constant(0.02));
    HostedLesson upright;
    REQUIRE(upright.start("world:hand { tool = {} }") == "");
    const CursorShape& shape = upright.host->description().hand.tool->shape;
    REQUIRE(std::holds_alternative<CylinderShape>(shape));
    CHECK(std::get<CylinderShape>(shape).half_height_m == 0.05);
}
