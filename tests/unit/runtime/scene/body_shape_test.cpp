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

TEST_CASE("body shape: it is as large as the model reaches, and has a name where it is a formula") {
    const auto made = [](BodyShape kind) {
        return make_body_shape(kind, "shape", brick()).value();
    };
    CHECK(std::get<SphereShape>(made(BodyShape::ball)).radius_m == Approx(0.1));
    CHECK(std::get<BoxShape>(made(BodyShape::box)).half_size_m.z() == Approx(0.03));
    CHECK(std::get<CylinderShape>(made(BodyShape::cylinder)).radius_m == Approx(0.05));
    CHECK(std::get<CapsuleShape>(made(BodyShape::capsule)).half_length_m == Approx(0.05));
    CHECK(std::get<HullShape>(made(BodyShape::hull)).mesh->n_triangles() == 12);
    CHECK(std::get<MeshShape>(made(BodyShape::mesh)) == brick());
    CHECK(name_of_formula(made(BodyShape::ball)) == "ball");
    CHECK(name_of_formula(made(BodyShape::box)) == "box");
    CHECK(name_of_formula(made(BodyShape::cylinder)) == "cylinder");
    CHECK(name_of_formula(made(BodyShape::capsule)) == "capsule");
    CHECK(name_of_formula(made(BodyShape::hull)).empty());
    CHECK(name_of_formula(made(BodyShape::mesh)).empty());
}

TEST_CASE("body shape: what has no middle at its origin is no ball, cylinder or capsule") {
    for (const BodyShape kind : {BodyShape::ball, BodyShape::cylinder, BodyShape::capsule}) {
        const auto refused = make_body_shape(kind, "felt_shape", shifted());
        REQUIRE_FALSE(refused);
        CHECK(refused.error().what_to_do == "give it felt_shape = \"hull\" or \"box\"");
    }
    const auto box = make_body_shape(BodyShape::box, "felt_shape", shifted());
    REQUIRE(box);
    CHECK(std::get<HullShape>(*box).mesh->n_triangles() == 12);
}

TEST_CASE("body shape: tools get triangles of it") {
    for (const BodyShape kind : {BodyShape::ball, BodyShape::box, BodyShape::cylinder,
                                 BodyShape::capsule, BodyShape::hull, BodyShape::mesh}) {
        const auto shape = make_body_shape(kind, "shape", brick());
        REQUIRE(shape);
        const auto mesh = make_shape_mesh(*shape);
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
}

TEST_CASE(
    "plan: the hand feels what the lesson makes of a model, and explain says which by formula") {
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
               {"\nFelt by their formula, without facets: earth, a ball.\n"});
    const Plan capsule = plan_of_shape(BodyShape::capsule);
    CHECK(std::get<CapsuleShape>(capsule.haptic.solids[0].shape).radius_m == Approx(0.05));
    check_says(explain(lesson, capsule),
               {"\nFelt by their formula, without facets: thing, a capsule; earth, a ball.\n"});
    check_says(explain_json(lesson, capsule, nullptr), {R"("shape": "capsule")", R"("thing")"});
    lesson.hand.cursor = CylinderShape{0.01, 0.02};
    CHECK(std::holds_alternative<CapsuleShape>(
        plan_of_shape(BodyShape::capsule).haptic.solids[0].shape));
    lesson.hand.cursor = {};
    lesson.hand.tool = ToolDescription{};
    const Plan held = plan_of_shape(BodyShape::capsule);
    CHECK(find_mesh(held.haptic.solids[0].shape) != nullptr);
    CHECK(find_mesh(held.haptic.solids[1].shape) != nullptr);
    check_lacks(explain(lesson, held), {"by their formula"});
    lesson.hand.tool.reset();
    lesson.bodies[0].felt_as = BodyShape::ball;
    const auto refused = compile_plan(lesson, {}, [](const auto&) { return shifted(); });
    REQUIRE_FALSE(refused);
    CHECK(refused.error().where == "lesson.lua:3");
    CHECK(refused.error().what_to_do == "give it felt_shape = \"hull\" or \"box\"");
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
