#include "runtime/effect/rigid/plan_rigid.h"

#include "tests/unit/runtime/scene/plan_scene.h"

using namespace fulcrum::runtime::test;

namespace {

BodyDescription make_block(const std::string& name, const Vector3& size_m, double mass_kg,
                           SourceLine line) {
    BodyDescription body = make_solid(name, line);
    body.model = "box";
    body.size_m = size_m;
    body.mass_kg = mass_kg;
    body.rigid.emplace();
    return body;
}

LessonDescription make_blocks() {
    LessonDescription lesson;
    lesson.bodies = {make_block("table", {1.0, 0.1, 1.0}, 1.0, 3),
                     make_block("block", {0.1, 0.2, 0.1}, 0.3, 4),
                     make_block("heavy", {0.1, 0.1, 0.1}, 2.0, 5)};
    lesson.bodies[0].rigid.reset();
    return lesson;
}

}  // namespace

TEST_CASE("plan: rigid bodies have a world with ground and table; the hand pushes and grips them") {
    const Plan plan = plan_of(make_blocks(), box_mesh);
    REQUIRE(plan.rigid);
    CHECK_FALSE(plan.world);
    CHECK(plan.world_rate_hz() == 1000.0);
    REQUIRE(plan.rigid->world.bodies.size() == 4);
    CHECK(plan.rigid->world.bodies[0].role == BodyRole::ground);
    CHECK(plan.rigid->world.bodies[1].role == BodyRole::stays);
    CHECK(plan.rigid->world.bodies[2].role == BodyRole::moves);
    CHECK(plan.rigid->world.bodies[2].mass_kg == 0.3);
    const auto* box = std::get_if<BoxShape>(&plan.rigid->world.bodies[2].shape);
    REQUIRE(box != nullptr);
    CHECK((box->half_size_m - Vector3(0.05, 0.1, 0.05)).norm() < 1e-12);
    CHECK(plan.rigid->solids == std::vector<std::int32_t>{kNoBody, 2, 3});
    CHECK(plan.rigid->scene_bodies == std::vector<std::int32_t>{kNoBody, kNoBody, 1, 2});
    REQUIRE(plan.haptic.rigid.size() == 2);
    CHECK(plan.haptic.rigid[0].solid == 1);
    CHECK(plan.haptic.rigid[0].grip_buttons != 0);
    // m (0.1^2 + 0.2^2) / 12.
    CHECK(plan.haptic.rigid[0].moment_kg_m2 == Approx(0.3 * 0.05 / 12.0));
    CHECK(plan.felt_weight_N[1] == Approx(0.3 * 9.81));
    CHECK(plan.has("world", "rigid bodies"));
    CHECK(plan.has("haptic", "pushing"));
}

TEST_CASE("plan: without rigid bodies there is no world of them, nor its stage") {
    LessonDescription lesson = make_blocks();
    lesson.bodies.resize(1);
    const Plan plan = plan_of(lesson, box_mesh);
    CHECK_FALSE(plan.rigid);
    CHECK(plan.haptic.rigid.empty());
    CHECK(plan.world_rate_hz() == 0.0);
    CHECK_FALSE(plan.has("world", "rigid bodies"));
    CHECK_FALSE(plan.has("haptic", "pushing"));
}

TEST_CASE("plan: a teacher is told what is too heavy to lift") {
    const Plan plan = plan_of(make_blocks(), box_mesh);
    REQUIRE(plan.notices.size() == 1);
    check_says(plan.notices[0],
               {"heavy weighs 19.62 N, and a hand that may feel 5.0 N lifts 4.50 N "
                "at most, so it can only be pushed"});
    // What it may weigh is told so that it is no more than that.
    check_says(plan.notices[0],
               {"its mass, which is 2 kg, must be 0.458 kg at most", "lesson.lua:5"});
}

TEST_CASE("plan: what is not seen at first is not there, and joints are between the right bodies") {
    LessonDescription lesson = make_blocks();
    lesson.bodies[1].visible = false;
    lesson.bodies[2].rigid->joint = JointDescription{
        .kind = JointKind::hinge, .to = "block", .at_W = {0.1, 0.0, 0.0}, .highest = 1.0};
    const Plan plan = plan_of(lesson, box_mesh);
    CHECK(plan.rigid->hidden == std::vector<std::int32_t>{2});
    REQUIRE(plan.rigid->world.joints.size() == 1);
    const JointPlan& joint = plan.rigid->world.joints[0];
    CHECK(joint.body_a == 2);
    CHECK(joint.body_b == 3);
    CHECK(joint.drive.upper == 1.0);
    CHECK(std::isinf(joint.drive.lower));
    CHECK(joint.anchor_W == Vector3(0.1, 0.0, 0.0));
}

TEST_CASE("plan: shapes follow the model, or what the lesson says") {
    LessonDescription lesson = make_blocks();
    const auto shape_as = [&](BodyShape shape) {
        lesson.bodies[1].collides_as = shape;
        return plan_of(lesson, box_mesh).rigid->world.bodies[2].shape;
    };
    CHECK(std::get<SphereShape>(shape_as(BodyShape::ball)).radius_m == Approx(0.1));
    const auto cylinder = std::get<CylinderShape>(shape_as(BodyShape::cylinder));
    CHECK(cylinder.radius_m == Approx(0.05));
    CHECK(cylinder.half_height_m == Approx(0.1));
    CHECK(std::get<CapsuleShape>(shape_as(BodyShape::capsule)).half_length_m == Approx(0.05));
    CHECK(std::holds_alternative<HullShape>(shape_as(BodyShape::hull)));
    CHECK(std::holds_alternative<BoxShape>(shape_as(BodyShape::box)));
    CHECK(std::holds_alternative<MeshShape>(shape_as(BodyShape::mesh)));
}

TEST_CASE("plan: a body is felt as one model and simulated as another, in one frame") {
    LessonDescription lesson = make_blocks();
    lesson.bodies[0].simulated_model = "top";
    lesson.bodies[1].felt_model = "rough";
    lesson.bodies[2].felt_model = "rough";
    lesson.bodies[2].simulated_model = "coarse";
    const auto load = [](const BodyDescription& body) {
        const double half_m = body.model == "rough"    ? 0.03
                              : body.model == "coarse" ? 0.02
                              : body.model == "top"    ? 0.4
                                                       : 0.05;
        return touchable(make_box(Vector3::Constant(2.0 * half_m)));
    };
    const auto plan = plan_of(lesson, load);
    const auto felt_m = [&](std::size_t solid) {
        return (*find_mesh(plan.haptic.solids[solid].shape))->vertices_B()[0].cwiseAbs().x();
    };
    const auto farthest_m = [&](std::size_t body) {
        const auto& hull = std::get<HullShape>(plan.rigid->world.bodies[body].shape);
        return hull.mesh->vertices_B()[0].cwiseAbs().x();
    };
    CHECK(felt_m(0) == Approx(0.05));
    CHECK(farthest_m(1) == Approx(0.4));
    CHECK(felt_m(1) == Approx(0.03));
    CHECK(farthest_m(2) == Approx(0.03));
    CHECK(felt_m(2) == Approx(0.03));
    CHECK(farthest_m(3) == Approx(0.02));
    CHECK(plan.haptic.solids[2].initial_pose_W.position ==
          plan.rigid->world.bodies[3].pose_W.position);
    // How hard it is to turn is that of what is simulated: m a^2 / 6.
    REQUIRE(plan.haptic.rigid.size() == 2);
    CHECK(plan.haptic.rigid[1].moment_kg_m2 == Approx(2.0 * 0.04 * 0.04 / 6.0));
}

TEST_CASE("plan: what is simulated is refused where no body is rigid, or it is not there") {
    LessonDescription lesson = make_blocks();
    lesson.bodies.resize(1);
    lesson.bodies[0].simulated_model = "coarse";
    const std::string alone = refusal(lesson, box_mesh);
    check_says(alone, {"no body of the lesson is rigid", "lesson.lua:3"});
    LessonDescription missing = make_blocks();
    missing.bodies[1].simulated_model = "coarse";
    CHECK(error_of(compile_plan(missing, {},
                                [](const BodyDescription& body)
                                    -> Expected<std::shared_ptr<const CollisionMesh>> {
                                    return body.model == "coarse" ? fail("it is not there", {}, {})
                                                                  : box_mesh(body);
                                }))
              .message == "it is not there");
}

TEST_CASE("plan: a mesh is made ready once, and an open one is refused with the body's line") {
    LessonDescription lesson = make_blocks();
    lesson.bodies[1].collides_as = BodyShape::mesh;
    const Plan plan = plan_of(lesson, box_mesh);
    REQUIRE(plan.rigid->world.bodies[2].sampled);
    CHECK(plan.rigid->world.bodies[2].sampled->is_mesh());
    CHECK_FALSE(plan.rigid->world.bodies[1].sampled);
    const auto open_mesh = [](const BodyDescription& body) {
        return make_box(box_size_m(body)).and_then([](const TriangleMesh& box) {
            auto triangles = box.triangles();
            triangles.pop_back();
            return TriangleMesh::build(box.vertices_B(), triangles)
                .and_then([](const TriangleMesh& mesh) { return CollisionMesh::create(mesh); });
        });
    };
    const std::string refused = refusal(lesson, open_mesh);
    check_says(refused, {"lesson.lua:4", "open"});
}
