

#include "haptics/dynamics/world.h"
#include "tests/unit/runtime/scene/plan_scene.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr double kGravity = 9.81;

BodyDescription fruit(const std::string& name, double mass_kg, double exaggeration,
                      SourceLine line = 1) {
    BodyDescription body = make_solid(name, line);
    body.mass_kg = mass_kg;
    body.exaggeration = exaggeration;
    body.movable = true;
    body.solid = false;
    return body;
}

// The thesis' weights: an apple felt at 6 N, an egg at 3 N.
LessonDescription gravity_like() {
    LessonDescription lesson;
    lesson.bodies = {fruit("watermelon", 3.0, 0.3, 10),
                     fruit("apple", 6.0 / kGravity / 3.0, 3.0, 11), fruit("banana", 0.12, 3.5, 12),
                     fruit("egg", 3.0 / kGravity / 5.0, 5.0, 13)};
    lesson.bucket.present = true;
    lesson.bucket.line = 14;
    QuestionDescription question;
    question.id = "heaviest";
    question.line = 20;
    lesson.questions = {question};
    return lesson;
}

Expected<std::shared_ptr<const CollisionMesh>> no_mesh(const BodyDescription& body) {
    return fail("no mesh for " + body.name);
}

// The plan never looks into a mesh.
Expected<std::shared_ptr<const CollisionMesh>> some_mesh(const BodyDescription& /*body*/) {
    static const int anything = 0;
    return std::shared_ptr<const CollisionMesh>(std::shared_ptr<const void>{},
                                                reinterpret_cast<const CollisionMesh*>(&anything));
}

std::string place_of_refusal(const LessonDescription& lesson) {
    const auto plan = compile_plan(lesson, {}, no_mesh);
    return plan ? "" : plan.error().where;
}

// Forces of one kind, in lines 10, 11 and so on; where the lesson is refused for them.
std::string refuses_forces(int n, const FieldPlan& field, double scale = 1.0) {
    LessonDescription lesson;
    lesson.hand.scale = scale;
    for (int i = 0; i < n; ++i) {
        ForceDescription force;
        force.name = "f" + std::to_string(i);
        force.field = field;
        force.line = 10 + i;
        lesson.forces.push_back(force);
    }
    return place_of_refusal(lesson);
}

}  // namespace

TEST_CASE("plan: with a limit of 10 N the thesis' apple weighs 6 N and its egg 3 N") {
    const FeltWeights felt = fit_felt_weights(gravity_like().bodies, kGravity, 1, 10.0);
    CHECK(felt.scale == 1.0);
    CHECK(felt.newtons[1] == Approx(6.0).epsilon(1e-12));
    CHECK(felt.newtons[3] == Approx(3.0).epsilon(1e-12));
    CHECK(felt.newtons[0] <= kWeightShareOfLimit * 10.0);
}

TEST_CASE("plan: felt weights shrink by one factor, so that ratios stay and nothing is clipped") {
    const auto bodies = gravity_like().bodies;
    const FeltWeights wide = fit_felt_weights(bodies, kGravity, 1, 10.0);
    for (const double limit_N : {0.5, 2.0, 5.0}) {
        const FeltWeights felt = fit_felt_weights(bodies, kGravity, 1, limit_N);
        CHECK(felt.newtons[0] == Approx(kWeightShareOfLimit * limit_N).epsilon(1e-12));
        for (std::size_t i = 1; i < bodies.size(); ++i) {
            CHECK(felt.newtons[i] / felt.newtons[0] ==
                  Approx(wide.newtons[i] / wide.newtons[0]).epsilon(1e-12));
        }
    }
}

TEST_CASE("plan: a bucket that holds two fits the two heaviest together under the limit") {
    const auto bodies = gravity_like().bodies;
    const FeltWeights felt = fit_felt_weights(bodies, kGravity, 2, 5.0);
    CHECK(felt.newtons[0] + felt.newtons[1] == Approx(kWeightShareOfLimit * 5.0).epsilon(1e-12));
}

TEST_CASE("plan: without gravity or bodies nothing is felt and nothing breaks") {
    CHECK(fit_felt_weights({}, kGravity, 1, 5.0).newtons.empty());
    const FeltWeights felt = fit_felt_weights(gravity_like().bodies, 0.0, 1, 5.0);
    CHECK(felt.newtons[0] == 0.0);
    CHECK(felt.scale == 1.0);
}

TEST_CASE("plan: scenery without a mass stands beside what falls") {
    LessonDescription lesson = gravity_like();
    lesson.bodies[2].movable = false;
    lesson.bodies[2].mass_kg = 0.0;
    const auto plan = compile_plan(lesson, {}, no_mesh);
    REQUIRE(plan);
    CHECK(validate(plan->world.value()));
}

TEST_CASE("plan: gravity has no proxy when nothing solid can be touched") {
    const auto plan = plan_of(gravity_like(), no_mesh);
    CHECK_FALSE(plan.has("haptic", "proxy"));
    CHECK(plan.haptic.solids.empty());
    CHECK(plan.has("haptic", "forces: weight"));
    CHECK(plan.has("world", "falling bodies"));
    CHECK(plan.has("world", "bucket"));
    CHECK_FALSE(plan.has("haptic", "forces: lesson"));
}

TEST_CASE("plan: a solid body brings the proxy, and names the line that asked") {
    LessonDescription lesson;
    BodyDescription ball = fruit("ball", 1.0, 1.0, 7);
    ball.movable = false;
    ball.solid = true;
    lesson.bodies = {ball};
    const auto plan = value_of(compile_plan(lesson, {}, some_mesh));
    CHECK(plan.has("haptic", "proxy"));
    CHECK_FALSE(plan.world.has_value());
    CHECK_FALSE(plan.has("haptic", "forces: weight"));
    CHECK(stage_of(plan, "haptic", "proxy").line == 7);
}

TEST_CASE("plan: muted there is no sound, typed no recogniser, unseen no picture") {
    PlanOptions options;
    options.sound = false;
    options.picture = false;
    const auto plan = plan_of(gravity_like(), no_mesh, options);
    CHECK_FALSE(plan.sound);
    CHECK_FALSE(plan.has("sound", "mixer"));
    CHECK_FALSE(plan.recogniser);
    CHECK_FALSE(plan.has("speech", "recogniser"));
    CHECK_FALSE(plan.has("picture", "scene"));
    CHECK_FALSE(plan.has("record", "writer"));
    CHECK(plan.has("lesson", "dialogue"));
    CHECK(plan.speech == SpeechInput::text);
}

TEST_CASE("plan: a lesson in which the lighter thing feels heavier is refused with its line") {
    LessonDescription lesson = gravity_like();
    lesson.bodies[3].exaggeration = 50.0;
    const auto plan = error_of(compile_plan(lesson, {}, no_mesh));
    CHECK(plan.where == "lesson.lua:13");
    check_says(plan.message, {"egg"});
}

TEST_CASE("plan: two bodies of one name, too many bodies, solids or forces are refused") {
    LessonDescription twins = gravity_like();
    twins.bodies[1].name = "watermelon";
    CHECK(refusal(twins, no_mesh) != "");
    LessonDescription bodies;
    LessonDescription solids;
    for (int i = 0; i <= std::max(kMaxBodies, kMaxSolids); ++i) {
        if (i <= kMaxBodies) {
            bodies.bodies.push_back(fruit("f" + std::to_string(i), 1.0, 1.0, i));
        }
        if (i <= kMaxSolids) {
            solids.bodies.push_back(fruit("s" + std::to_string(i), 1.0, 1.0, i));
            solids.bodies.back().solid = true;
        }
    }
    CHECK(place_of_refusal(bodies) == "lesson.lua:64");
    CHECK(refusal(solids, some_mesh) != "");
    LessonDescription forces;
    forces.forces.resize(kMaxFields + 1);
    CHECK(refusal(forces, no_mesh) != "");
}

TEST_CASE("plan: forces too stiff together are refused with the line that was too much") {
    const auto springs = [](int n, double stiffness_N_per_m, double scale = 1.0) {
        FieldPlan spring;
        spring.stiffness_N_per_m = stiffness_N_per_m;
        return refuses_forces(n, spring, scale);
    };
    CHECK(springs(1, 2000.0) == "");
    CHECK(springs(4, 500.0) == "");
    CHECK(springs(2, 1500.0) == "lesson.lua:11");
    CHECK(springs(1, 500.0, 10.0) == "lesson.lua:10");
    const auto magnets = [](int n, double peak_N, double range_m) {
        FieldPlan magnet;
        magnet.kind = FieldKind::magnet;
        magnet.peak_force_N = peak_N;
        magnet.range_m = range_m;
        return refuses_forces(n, magnet);
    };
    // sqrt(e) peak / range: 3 N over 5 mm are 989 N/m, twice that is under 2000, thrice is not.
    CHECK(magnets(2, 3.0, 0.005) == "");
    CHECK(magnets(3, 3.0, 0.005) == "lesson.lua:12");
    // 3 N over 2.4 mm are 1250 N/m by peak / range and 2061 N/m in truth.
    CHECK(magnets(1, 3.0, 0.0024) == "lesson.lua:10");
    CHECK(magnets(1, 3.0, 0.0025) == "");
    CHECK(magnets(1, 0.0, 0.0) != "");
}

TEST_CASE("plan: a wall is as stiff in the hand at every scale") {
    LessonDescription lesson;
    lesson.hand.scale = 10.0;
    const auto plan = plan_of(lesson, no_mesh);
    CHECK(plan.haptic.coupling.stiffness_N_per_m * 10.0 ==
          Approx(CouplingSettings{}.stiffness_N_per_m));
}

TEST_CASE("plan: a gentler site lets less torque through as well, a stronger one no more") {
    LessonDescription lesson;
    for (const auto& [limit_N, torque_Nm] : {std::pair(0.5, 0.03), {5.0, 0.3}, {10.0, 0.3}}) {
        PlanOptions options;
        options.site = make_site_limits(limit_N);
        const auto plan = plan_of(lesson, no_mesh, options);
        CHECK(plan.haptic.safety.max_force_N == limit_N);
        CHECK(plan.haptic.safety.max_torque_Nm == Approx(torque_Nm));
    }
}

TEST_CASE("plan: weights fit under the limit of a device that is weaker than the site's") {
    PlanOptions options;
    options.site = make_site_limits(10.0);
    options.device_force_limit_N = 2.0;
    const auto plan = plan_of(gravity_like(), no_mesh, options);
    CHECK(plan.felt_weight_N[0] == Approx(kWeightShareOfLimit * 2.0));
    options.device_force_limit_N = 50.0;
    const auto strong = plan_of(gravity_like(), no_mesh, options);
    CHECK(strong.felt_weight_N[0] == Approx(kWeightShareOfLimit * 10.0).epsilon(0.1));
    CHECK(strong.felt_weight_N[0] <= kWeightShareOfLimit * 10.0);
}

namespace {

/// A solid ball of a material.
LessonDescription ball_of(const Material& felt) {
    LessonDescription lesson;
    MaterialDescription material;
    material.felt = felt;
    material.felt.name = "felt";
    material.line = 5;
    lesson.materials = {material};
    lesson.bodies = {make_solid("ball", 7)};
    lesson.bodies[0].material = 0;
    return lesson;
}

Expected<Plan> plan_solid(const LessonDescription& lesson, const PictureLoader& load_picture = {}) {
    return compile_plan(lesson, {}, some_mesh, load_picture);
}

}  // namespace

TEST_CASE("plan: a material is put onto its body, as stiff in the hand at every scale") {
    Material felt;
    felt.coupling.stiffness_N_per_m = 300.0;
    felt.coupling.damping_Ns_per_m = 6.0;
    felt.transient.kind = TransientKind::decaying_sinusoid;
    LessonDescription lesson = ball_of(felt);
    lesson.hand.scale = 2.0;
    const auto plan = plan_of(lesson, some_mesh);
    const SolidPlan& solid = plan.haptic.solids.at(0);
    CHECK(solid.coupling->stiffness_N_per_m == 150.0);
    CHECK(solid.coupling->damping_Ns_per_m == 3.0);
    CHECK(solid.surface.transient.kind == TransientKind::decaying_sinusoid);
    CHECK(solid.surface.audible);
    CHECK(plan.touch_sound);
    CHECK(plan.has("sound", "touch"));
    // Without sound nothing of it is built; without a material neither.
    PlanOptions mute;
    mute.sound = false;
    const auto muted = plan_of(lesson, some_mesh, mute);
    CHECK_FALSE(muted.haptic.solids[0].surface.audible);
    CHECK_FALSE(muted.touch_sound);
    lesson.bodies[0].material = kNoMaterial;
    const auto plain = plan_of(lesson, some_mesh);
    CHECK_FALSE(plain.haptic.solids[0].surface.audible);
    CHECK_FALSE(plain.haptic.solids[0].coupling.has_value());
    CHECK_FALSE(plain.has("sound", "touch"));
}

TEST_CASE("plan: the proxy is the least that shows the scene, or what the lesson chose") {
    LessonDescription lesson = ball_of({});
    const auto kind = [&] { return plan_solid(lesson).value().haptic.proxy.kind; };
    CHECK(kind() == ProxyKind::god_object);
    lesson.materials[0].felt.friction = {0.5, 0.4, 0.0};
    CHECK(kind() == ProxyKind::friction_cone);
    lesson.hand.proxy = ProxyKind::god_object;
    CHECK(kind() == ProxyKind::god_object);
}

TEST_CASE("plan: a material's picture is read once, and its heights keep the picture's shape") {
    Material felt;
    felt.texture.source = ImageTexture{nullptr, 0.04, 0.04};
    LessonDescription lesson = ball_of(felt);
    lesson.materials[0].image = "felt.png";
    BodyDescription other = lesson.bodies[0];
    other.name = "other";
    lesson.bodies.push_back(other);
    int n_read = 0;
    // Made smaller: its own numbers only come near to the file's shape.
    const auto read = [&n_read](const MaterialDescription& material,
                                double width_m) -> Expected<FeltPicture> {
        CHECK(material.image == "felt.png");
        CHECK(width_m == 0.04);
        ++n_read;
        return FeltPicture{std::make_shared<HeightMap>(HeightMap{2, 1, {0.0F, 1.0F}}), 0.75};
    };
    const auto plan = value_of(plan_solid(lesson, read));
    CHECK(n_read == 1);
    // A picture is a relief like any other.
    CHECK(plan.material_facts.at(0).rms_height_m > 1e-5);
    CHECK(plan.material_facts[0].roughness > 0.0);
    for (const SolidPlan& solid : plan.haptic.solids) {
        const auto& image = std::get<ImageTexture>(solid.surface.texture.source);
        CHECK(image.map->heights.size() == 2);
        CHECK(image.tile_u_m == 0.04);
        CHECK(image.tile_v_m == 0.03);
    }
    CHECK(refusal_of(plan_solid(lesson, [](const MaterialDescription&, double) {
              return fail("the picture is damaged", "lesson.lua:5", "save it again");
          })) == "lesson.lua:5: the picture is damaged; save it again.");
}

TEST_CASE("plan: a material out of its range is refused with its line") {
    Material felt;
    felt.friction = {0.2, 0.4, 0.0};
    const auto plan = error_of(plan_solid(ball_of(felt)));
    CHECK(plan.where == "lesson.lua:5");
    CHECK(plan.message.find("felt") == 0);
}

TEST_CASE("plan: a material too much for the hand's scale or rate is told by name and line") {
    Material rock;
    rock.coupling.damping_Ns_per_m = 20.0;
    LessonDescription lesson = ball_of(rock);
    lesson.hand.line = 3;
    lesson.hand.scale = 0.01;
    const auto fine = error_of(plan_solid(lesson));
    CHECK(fine.where == "lesson.lua:3");
    CHECK(fine.message.find("felt cannot be felt by a hand at scale 0.01: ") == 0);
    CHECK(fine.what_to_do == "give world:hand a scale nearer to 1");
    lesson.hand.scale = 0.05;
    CHECK(plan_solid(lesson));

    lesson.hand.scale = 1.0;
    lesson.materials[0].felt.transient.kind = TransientKind::decaying_sinusoid;
    lesson.materials[0].felt.transient.frequency_Hz = 500.0;
    const auto slow = error_of(plan_solid(lesson));
    CHECK(slow.where == "lesson.lua:5");
    CHECK(slow.message.find("felt: at a loop of 1000 Hz the tap's frequency") == 0);
    // What it says to do is enough.
    CHECK(slow.what_to_do == "let it ring lower, or give world:hand a rate of 1250");
    lesson.hand.rate_hz = 1250.0;
    CHECK(plan_solid(lesson));
}
