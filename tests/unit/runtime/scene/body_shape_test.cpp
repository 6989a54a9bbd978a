#include "runtime/scene/body_shape.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "haptics/surface/materials.h"
#include "runtime/scene/explain.h"
#include "tests/support/sent_force.h"
#include "tests/support/touchable.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

const MeshShape& brick() {
    static const MeshShape mesh = touchable(make_box({0.1, 0.2, 0.06}));
    return mesh;
}

MeshShape shifted() {
    const PlacedBox box{Vector3(0.02, 0.0, 0.0), Vector3(0.1, 0.1, 0.1)};
    return touchable(make_boxes(std::span(&box, 1)));
}

double farthest_m(const CollisionMesh& mesh) {
    double farthest = 0.0;
    for (const Vector3& vertex_B : mesh.vertices_B()) {
        farthest = std::max(farthest, vertex_B.norm());
    }
    return farthest;
}

}  // namespace

TEST_CASE("body shape: it is as large as the model reaches, and lies where its middle is") {
    const Vector3 middle(0.02, -0.3, 0.1);
    for (const Vector3& at : {Vector3(Vector3::Zero()), middle}) {
        const PlacedBox box{at, Vector3(0.1, 0.2, 0.06)};
        const MeshShape model = touchable(make_boxes(std::span(&box, 1)));
        const auto made = [&](BodyShape kind) { return make_felt_shape(kind, model).value(); };
        CHECK(std::get<SphereShape>(made(BodyShape::ball).shape).radius_m == Approx(0.1));
        CHECK(std::get<BoxShape>(made(BodyShape::box).shape).half_size_m.z() == Approx(0.03));
        CHECK(std::get<CylinderShape>(made(BodyShape::cylinder).shape).radius_m == Approx(0.05));
        CHECK(std::get<CapsuleShape>(made(BodyShape::capsule).shape).half_length_m == Approx(0.05));
        for (const BodyShape kind :
             {BodyShape::ball, BodyShape::box, BodyShape::cylinder, BodyShape::capsule}) {
            CHECK((made(kind).shape_B.position - at).norm() < 1.0e-12);
            CHECK(made(kind).shape_B.orientation.isApprox(Quaternion::Identity()));
        }
        CHECK(std::get<HullShape>(made(BodyShape::hull).shape).mesh->n_triangles() == 12);
        CHECK(std::get<MeshShape>(made(BodyShape::mesh).shape) == model);
        CHECK(is_same(made(BodyShape::hull).shape_B, Pose{}));
    }
}

TEST_CASE("body shape: what is round about another axis lies along that, and a log as it lies") {
    struct Lying {
        Vector3 size_m;
        Vector3 axis;
    };
    const std::vector<Lying> cases{{{0.3, 0.05, 0.05}, Vector3::UnitX()},
                                   {{0.05, 0.052, 0.3}, Vector3::UnitZ()},
                                   {{0.02, 0.2, 0.2}, Vector3::UnitX()},   // a coin on its edge
                                   {{0.2, 0.02, 0.2}, Vector3::UnitY()},   // and one that lies
                                   {{0.1, 0.1, 0.103}, Vector3::UnitY()},  // in doubt upright
                                   {{0.1, 0.2, 0.06}, Vector3::UnitY()}};
    for (const Lying& lying : cases) {
        const MeshShape model = touchable(make_box(lying.size_m));
        const PlacedShape rod = make_felt_shape(BodyShape::cylinder, model).value();
        CHECK((rod.shape_B.orientation * Vector3::UnitY() - lying.axis).norm() < 1.0e-12);
        const double along_m = 0.5 * lying.size_m.dot(lying.axis);
        CHECK(std::get<CylinderShape>(rod.shape).half_height_m == Approx(along_m));
        CHECK(std::get<CylinderShape>(rod.shape).radius_m ==
              Approx(0.5 * (lying.size_m - 2.0 * along_m * lying.axis).maxCoeff()));
        const PlacedShape pill = make_felt_shape(BodyShape::capsule, model).value();
        CHECK(pill.shape_B.orientation.isApprox(rod.shape_B.orientation));
    }
}

TEST_CASE("body shape: a rigid body with no middle at its origin is no ball, cylinder or capsule") {
    CHECK(std::get<SphereShape>(make_body_shape(BodyShape::ball, brick()).value()).radius_m ==
          Approx(0.1));
    for (const BodyShape kind : {BodyShape::ball, BodyShape::cylinder, BodyShape::capsule}) {
        const auto refused = make_body_shape(kind, shifted());
        REQUIRE_FALSE(refused);
        check_says(refused.error().what_to_do,
                   {"give it shape = \"hull\" or \"box\"", "full", "bucket", "\"mesh\""});
    }
    const auto box = make_body_shape(BodyShape::box, shifted());
    REQUIRE(box);
    CHECK(std::get<HullShape>(*box).mesh->n_triangles() == 12);
    // A log is simulated upright.
    const auto log = make_body_shape(BodyShape::cylinder, touchable(make_box({0.3, 0.05, 0.05})));
    CHECK(std::get<CylinderShape>(log.value()).half_height_m == Approx(0.025));
}

TEST_CASE("body shape: tools get triangles of it") {
    for (const BodyShape kind : {BodyShape::ball, BodyShape::box, BodyShape::cylinder,
                                 BodyShape::capsule, BodyShape::hull, BodyShape::mesh}) {
        const auto shape = make_felt_shape(kind, brick());
        REQUIRE(shape);
        const auto mesh = make_shape_mesh(shape->shape, shape->shape_B);
        REQUIRE(mesh);
        const double reach_m = farthest_m(**mesh);
        const bool is_round = kind == BodyShape::ball || kind == BodyShape::capsule;
        CHECK(reach_m == Approx(is_round                      ? 0.1
                                : kind == BodyShape::cylinder ? std::hypot(0.05, 0.1)
                                                              : brick()->radius_m()));
    }
    const auto ball = make_shape_mesh(CapsuleShape{0.1, 0.0});
    REQUIRE(ball);
    CHECK(farthest_m(**ball) == Approx(0.1));
    const auto moved = make_shape_mesh(SphereShape{0.1}, Pose::at(Vector3(0.0, 0.3, 0.0)));
    REQUIRE(moved);
    CHECK(farthest_m(**moved) == Approx(0.4));
}

TEST_CASE("plan: the hand feels what the lesson makes of a model, and explain says what of each") {
    LessonDescription lesson =
        fulcrum::test::make_touch_lesson(*find_material("wood"), false, "brick");
    lesson.bodies[0].material = kNoMaterial;
    lesson.bodies.resize(2, lesson.bodies[0]);
    lesson.bodies[1].name = "earth";
    lesson.bodies[1].model = "earth";
    const auto plan_of_shape = [&](BodyShape kind) {
        lesson.bodies[0].felt_as = kind;
        return compile_plan(lesson, {}, [](const auto&) { return brick(); }).value();
    };
    const Plan as_it_is = plan_of_shape(BodyShape::model);
    CHECK(std::get<MeshShape>(as_it_is.haptic.solids[0].shape) == brick());
    CHECK(std::get<SphereShape>(as_it_is.haptic.solids[1].shape).radius_m == 0.1);
    check_says(explain(lesson, as_it_is),
               {"\nFelt by their formula, without facets: earth, a ball.\n",
                "\nFelt as their triangles: thing, a mesh of 12.\n"});
    check_says(explain(lesson, plan_of_shape(BodyShape::hull)),
               {"\nFelt as their triangles: thing, a hull of 12.\n"});
    check_says(explain(lesson, plan_of_shape(BodyShape::box)),
               {"\nFelt by their formula, without facets: thing, a box; earth, a ball.\n"});
    // The program's own post is one, felt and simulated, for a tool as its model is.
    lesson.bodies[0].model = "cylinder";
    lesson.bodies[0].rigid.emplace();
    const Plan post = plan_of_shape(BodyShape::model);
    CHECK(std::get<CylinderShape>(post.haptic.solids[0].shape).radius_m == Approx(0.05));
    REQUIRE(post.rigid);
    CHECK(std::holds_alternative<CylinderShape>(post.rigid->world.bodies[1].shape));
    lesson.bodies[0].rigid.reset();
    lesson.bodies[0].model = "brick";
    const Plan capsule = plan_of_shape(BodyShape::capsule);
    CHECK(std::get<CapsuleShape>(capsule.haptic.solids[0].shape).radius_m == Approx(0.05));
    check_says(explain(lesson, capsule),
               {"\nFelt by their formula, without facets: thing, a capsule; earth, a ball.\n"});
    check_says(explain_json(lesson, capsule, nullptr), {R"("shape": "capsule")", R"("thing")"});
    check_says(explain_json(lesson, as_it_is, nullptr),
               {R"("felt_as_triangles")", R"("triangles": 12)"});
    lesson.bodies[0].model = "box";
    check_says(explain(lesson, plan_of_shape(BodyShape::model)),
               {"\nFelt as their triangles: thing, a box of 12.\n"});
    lesson.bodies[0].model = "brick";
    lesson.hand.cursor = CylinderShape{0.01, 0.02};
    CHECK(std::holds_alternative<CapsuleShape>(
        plan_of_shape(BodyShape::capsule).haptic.solids[0].shape));
    lesson.hand.cursor = {};
    lesson.hand.tool = ToolDescription{};
    const Plan held = plan_of_shape(BodyShape::capsule);
    CHECK(find_mesh(held.haptic.solids[0].shape) != nullptr);
    CHECK(find_mesh(held.haptic.solids[1].shape) != nullptr);
    check_lacks(explain(lesson, held), {"by their formula"});
    // What is off its origin lies where it is, for a tool as well.
    lesson.bodies[0].felt_as = BodyShape::ball;
    const auto off = compile_plan(lesson, {}, [](const auto&) { return shifted(); });
    REQUIRE(off);
    const CollisionMesh& triangles = **find_mesh(off->haptic.solids[0].shape);
    CHECK((triangles.centre_B() - Vector3(0.02, 0.0, 0.0)).norm() < 1.0e-9);
    CHECK(is_same(off->haptic.solids[0].shape_B, Pose{}));
    lesson.hand.tool.reset();
    const auto by_hand = compile_plan(lesson, {}, [](const auto&) { return shifted(); });
    REQUIRE(by_hand);
    CHECK(by_hand->haptic.solids[0].shape_B.position.isApprox(Vector3(0.02, 0.0, 0.0)));
}

TEST_CASE("plan: a model without thickness is no shape, and the lesson's line is told") {
    LessonDescription lesson =
        fulcrum::test::make_touch_lesson(*find_material("wood"), false, "leaf");
    const auto leaf = touchable(make_plate(0.1, 0.2, 2));
    for (const BodyShape kind : {BodyShape::box, BodyShape::cylinder, BodyShape::hull}) {
        lesson.bodies[0].felt_as = kind;
        const auto refused = compile_plan(lesson, {}, [&](const auto&) { return leaf; });
        REQUIRE_FALSE(refused);
        CHECK(refused.error().where == "lesson.lua:3");
        CHECK(refused.error().message.find("the thing: ") == 0);
    }
}
