#include "runtime/render/scene/scene_content.h"

#include "haptics/math/length.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

/// A model of 0.1 m radius without any triangles: no card is needed to place it.
const gl::Mesh& box() {
    static const gl::Mesh mesh = [] {
        gl::Mesh made;
        made.lowest.setConstant(-0.1F);
        made.highest.setConstant(0.1F);
        return made;
    }();
    return mesh;
}

SceneContent read(const runtime::View& view) {
    const Camera camera(view.camera, 1280, 720);
    return content_of(view, camera, [](const std::string&) -> const gl::Mesh& { return box(); });
}

ViewBody body_at(double x, double y, double z) {
    ViewBody body;
    body.pose_W.position = Vector3(x, y, z);
    return body;
}

runtime::View without_tool() {
    runtime::View view;
    view.tool_visible = false;
    return view;
}

}  // namespace

TEST_CASE("content: what is drawn of bodies, and marks and labels where they are") {
    runtime::View view = without_tool();
    SECTION("a body that cannot be drawn is left out, the others stay") {
        view.bodies = {body_at(0.0, 0.5, 0.0), body_at(kNan, 0.5, 0.0), body_at(0.2, 0.5, 0.0)};
        view.bodies[1].label = "lost";
        const SceneContent content = read(view);
        REQUIRE(content.items.size() == 2);
        CHECK(content.marks.size() == 2);
        CHECK(content.labels.empty());
    }
    SECTION("the mark lies straight below, with the height above the floor") {
        view.ground_height_m = 0.2;
        view.bodies = {body_at(0.3, 0.8, -0.1)};
        const SceneContent content = read(view);
        REQUIRE(content.marks.size() == 1);
        CHECK(content.marks[0].centre_W.x() == Approx(0.3));
        CHECK(content.marks[0].centre_W.z() == Approx(-0.1));
        CHECK(content.marks[0].height_m == Approx(0.5));
        CHECK_FALSE(content.marks[0].dashed);
        view.bodies = {body_at(0.0, -1.0, 0.0)};
        CHECK(read(view).marks.empty());
    }
    SECTION("far things have no mark, and how deep one is sunk is known") {
        view.ground_height_m = 0.5;
        view.bodies = {body_at(0.0, 0.58, 0.0), body_at(0.0, 0.58, -30.0), body_at(0.0, 0.7, 0.0)};
        const SceneContent content = read(view);
        REQUIRE(content.items.size() == 3);
        CHECK(content.marks.size() == 2);
        CHECK(content.items[0].sunk_m == Approx(0.02));
        CHECK(content.items[1].sunk_m == Approx(0.02));
        CHECK(content.items[2].sunk_m == 0.0);
    }
    SECTION("labels stand where their things are seen") {
        view.bodies = {body_at(0.2, 0.5, 0.0)};
        view.bodies[0].label = "apple";
        view.force = {true, Vector3(0.0, 0.4, 0.0), Vector3(0.0, -3.0, 0.0), "3 N"};
        const SceneContent content = read(view);
        REQUIRE(content.labels.size() == 2);
        const Camera camera(view.camera, 1280, 720);
        const auto seen = camera.project(Vector3(0.2, 0.5, 0.0));
        CHECK(content.labels[0].middle_px[0] == Approx(seen->position_px.x()).margin(0.01));
        CHECK(content.labels[0].middle_px[1] == Approx(seen->position_px.y()).margin(0.01));
        CHECK(content.labels[0].radius_px ==
              Approx(0.1 * camera.px_per_m(seen->depth_m)).epsilon(0.05));
        CHECK(content.labels[1].is_force);
        CHECK(content.labels[1].direction[1] == Approx(1.0).margin(0.01));
        view.force.text.clear();
        CHECK(read(view).labels.size() == 1);
        CHECK(read(view).arrow);
    }
    SECTION("detail falls with distance, far things have no part in shadows") {
        view.bodies = {body_at(0.0, 0.4, 0.9), body_at(0.0, 0.4, 0.0), body_at(0.0, 0.4, -6.0)};
        const SceneContent content = read(view);
        REQUIRE(content.items.size() == 3);
        CHECK(content.items[0].level < content.items[1].level);
        CHECK(content.items[1].level < content.items[2].level);
        CHECK(content.items[1].near);
        CHECK_FALSE(content.items[2].near);
    }
    SECTION("a crowd is cut off at the limit") {
        view.bodies.assign(kMostBodies + 10, body_at(0.0, 0.4, 0.0));
        CHECK(read(view).items.size() == kMostBodies);
    }
    SECTION("in space nothing has a mark, and an orbit is a circle instead of a model") {
        view.bodies = {body_at(0, 0.5, 0), body_at(0.1, 0.4, 0)};
        view.bodies[1].model = "orbit";
        view.bodies[1].scale.setConstant(0.7);
        const SceneContent on_earth = read(view);
        CHECK(on_earth.items.size() == 1);
        CHECK(on_earth.marks.size() == 1);
        REQUIRE(on_earth.orbits.size() == 1);
        CHECK(on_earth.orbits[0].centre_W == Vector3(0.1, 0.4, 0));
        CHECK(on_earth.orbits[0].x_W.norm() == Approx(0.7));
        CHECK(on_earth.orbits[0].x_W.dot(on_earth.orbits[0].z_W) == Approx(0.0).margin(1e-12));
        view.in_space = true;
        view.bodies[1].pose_W.position.x() = kNan;
        const SceneContent in_space = read(view);
        CHECK(in_space.marks.empty());
        CHECK(in_space.orbits.empty());
    }
    SECTION("a label's arrow covers what it hides, and a load's label has the load's colour") {
        ViewTorque torque;
        torque.axis_W = Vector3(-0.2, 0.4, 0);
        torque.force = {true, Vector3(0.2, 0.5, 0), Vector3(0, -4, 0), "4 N", ForceLook::load};
        view.torques = {torque};
        const SceneContent content = read(view);
        REQUIRE(content.labels.size() == 1);
        const SceneLabel& label = content.labels[0];
        CHECK(label.look == ForceLook::load);
        const Camera camera(view.camera, 1280, 720);
        for (const Vector3& point_W : {content.arrows[0].tail_W, content.arrows[0].tip_W}) {
            const auto seen = camera.project(point_W)->position_px.cast<float>().eval();
            CHECK(seen.x() > label.covers.x);
            CHECK(seen.x() < label.covers.right());
            CHECK(seen.y() > label.covers.y);
            CHECK(seen.y() < label.covers.bottom());
        }
    }
}

TEST_CASE("content: what is wide beside the picture has no mark: a ring says where a thing lands") {
    for (const double size : {0.9, 1.1, 2.0}) {
        runtime::View view = without_tool();
        view.bodies = {body_at(0.0, 0.5, 0.0)};
        const double half_m = read(view).marks.at(0).radius_m;
        const double distance_m = compute_length(Vector3(view.camera.eye_W - view.camera.target_W));
        view.bodies[0].scale = Vector3::Constant(size * 0.15 * distance_m / half_m);
        CHECK(read(view).marks.size() == (size < 1.0 ? 1 : 0));
    }
}

TEST_CASE("content: the hand has a mark of its own kind") {
    runtime::View view;
    view.tool = body_at(0.0, 0.6, 0.0);
    const SceneContent content = read(view);
    REQUIRE(content.marks.size() == 1);
    CHECK(content.marks[0].dashed);
    CHECK(content.items.size() == 1);
}

TEST_CASE("content: what lies in the hand has no mark of its own, what falls towards it has") {
    runtime::View view;
    view.tool = body_at(0.0, 0.3, 0.0);
    const auto marks_with = [&](double x, double y) {
        view.bodies = {body_at(x, y, 0.0)};
        return read(view).marks.size();
    };
    // Things and hand are boxes of 0.1 m half side: what lies in the hand starts between 0.2 and 0.4.
    CHECK(marks_with(0.0, 0.35) == 1);
    CHECK(marks_with(0.05, 0.48) == 1);
    CHECK(marks_with(0.0, 0.52) == 2);
    CHECK(marks_with(0.0, 0.28) == 2);
    CHECK(marks_with(0.15, 0.35) == 2);
    view.tool_visible = false;
    CHECK(marks_with(0.0, 0.35) == 1);
}

TEST_CASE("content: the ghost appears as the arm leaves the tool") {
    runtime::View view;
    view.tool = body_at(0.0, 0.4, 0.0);
    CHECK_FALSE(read(view).ghost);
    view.ghost_visible = true;
    view.ghost_pose_W = view.tool.pose_W;
    CHECK(read(view).ghost_strength == 0.0F);
    view.ghost_pose_W.position.x() += 0.01;
    const float a_little = read(view).ghost_strength;
    CHECK(a_little > 0.0F);
    CHECK(a_little < 1.0F);
    view.ghost_pose_W.position.x() += 0.2;
    const SceneContent apart = read(view);
    CHECK(apart.ghost_strength == 1.0F);
    REQUIRE(apart.ghost);
    CHECK(apart.ghost->bounds.centre_W.x() == Approx(0.21).margin(1e-6));
    view.ghost_pose_W.position.y() = kNan;
    CHECK_FALSE(read(view).ghost);
}

TEST_CASE("content: each hand is there with its mark, its number and its own ghost") {
    runtime::View view;
    view.tool = body_at(0.0, 0.4, 0.0);
    const std::size_t n_items = read(view).items.size();
    const std::size_t n_marks = read(view).marks.size();
    view.more_hands.resize(1);
    view.more_hands[0].tool = body_at(0.2, 0.4, 0.0);
    view.more_hands[0].tool.label = "2";
    view.more_hands[0].ghost_visible = true;
    view.more_hands[0].ghost_pose_W.position = {0.4, 0.4, 0.0};
    const SceneContent content = read(view);
    CHECK(content.items.size() == n_items + 1);
    CHECK(content.marks.size() == n_marks + 1);
    REQUIRE(content.labels.size() == 1);
    CHECK(content.labels[0].text == "2");
    CHECK_FALSE(content.ghost);
    REQUIRE(content.more_ghosts.size() == 1);
    CHECK(content.more_ghosts[0].strength == 1.0F);
    CHECK(content.more_ghosts[0].item.bounds.centre_W.x() == Approx(0.4).margin(1e-6));
    view.more_hands[0].tool.pose_W.position.x() = kNan;
    view.more_hands[0].ghost_pose_W.position.x() = kNan;
    CHECK(read(view).items.size() == n_items);
    CHECK(read(view).more_ghosts.empty());
}

TEST_CASE("content: the hand is seen where it is projected, as large as it is there") {
    const auto seen = [](const runtime::View& view) {
        const Camera camera(view.camera, 1280, 720);
        return hand_seen(view, camera, [](const std::string&) -> const gl::Mesh& { return box(); });
    };
    runtime::View view;
    view.tool = body_at(0.1, 0.4, 0.0);
    const Camera camera(view.camera, 1280, 720);
    const auto middle = camera.project(Vector3(0.1, 0.4, 0.0));
    REQUIRE(middle);
    CHECK(seen(view).middle_x() == Approx(middle->position_px.x()));
    CHECK(seen(view).middle_y() == Approx(middle->position_px.y()));
    CHECK(seen(view).width == Approx(2.0 * 0.1 * camera.px_per_m(middle->depth_m)));
    view.tool.pose_W.position.x() = kNan;
    CHECK(seen(view).width == 0.0F);
    CHECK(seen(without_tool()).width == 0.0F);
}
