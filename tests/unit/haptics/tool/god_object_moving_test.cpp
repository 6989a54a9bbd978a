// A god-object's tool among several objects, objects that move, and cases that are known to be hard.
#include "haptics/math/rotation.h"
#include "tests/support/god_scene.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

using test::kGodDt_s;

constexpr double kGap_m = 1.0e-6;
constexpr double kStiffness = 500.0;
constexpr double kHalf_m = 0.02;

const Inertia kCube = make_box_inertia(0.05, Vector3::Constant(2.0 * kHalf_m));

struct Scene {
    TriangleMesh tool;
    std::vector<TriangleMesh> objects;
    GodObjectTool god;
    std::vector<MovingFrame> frames;

    Scene(TriangleMesh tool_mesh, std::vector<TriangleMesh> object_meshes,
          const GodObjectSettings& settings = test::make_god_settings(kCube))
        : tool(std::move(tool_mesh)),
          objects(std::move(object_meshes)),
          god(test::make_god_tool(tool, objects, settings)),
          frames(objects.size()) {}
    ToolFelt step(const Pose& handle) { return god.move({handle, {}}, frames, 0.0, kGodDt_s); }
    // Where the objects were said to be, or where they wait.
    [[nodiscard]] bool is_inside() const {
        for (std::size_t i = 0; i < objects.size(); ++i) {
            if (test::do_cross(objects[i], god.object_W(i), tool, god.pose_W())) {
                return true;
            }
        }
        return false;
    }
};

TriangleMesh make_cube() {
    return make_box(Vector3::Constant(2.0 * kHalf_m)).value();
}

TEST_CASE(
    "god-object tool: an object that moves into a standing tool pushes it before itself, and the "
    "hand feels how far") {
    Scene scene(make_cube(), {make_box({0.1, 0.1, 0.1}).value()});
    const Pose handle = Pose::at({0.0, 0.05 + kHalf_m + 0.001, 0.0});
    scene.god.place(handle);
    for (int i = 0; i < 200; ++i) {
        const double up_m = 0.01 * (1.0 - std::cos(0.02 * i));
        scene.frames[0].pose_W = Pose::at({0.003 * std::sin(0.1 * i), up_m, 0.0});
        const ToolFelt felt = scene.step(handle);
        const double pushed_m = std::max(up_m + kGap_m - 0.001, 0.0);
        CAPTURE(i, scene.god.last_step().rounds);
        REQUIRE_FALSE(scene.god.last_step().wedged);
        REQUIRE_FALSE(scene.is_inside());
        CHECK((felt.felt_W.force - Vector3(0.0, kStiffness * pushed_m, 0.0)).norm() < 1.0e-6);
    }
}

TEST_CASE("god-object tool: objects that turn and fly about by chance never get into it") {
    Scene scene(make_cube(), {make_box({0.05, 0.02, 0.08}).value(),
                              make_bumpy_sphere(0.03, 3, 0.2, 90.0).value()});
    Random random(11);
    Pose handle{};
    scene.frames[0].pose_W = Pose::at({0.0, -0.09, 0.0});
    scene.frames[1].pose_W = Pose::at({0.0, 0.1, 0.0});
    scene.god.place(handle);
    int n_touching = 0;
    int n_wedged = 0;
    for (int i = 0; i < 1500; ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            Pose& pose = scene.frames[k].pose_W;
            // They circle round it, and lean on it.
            const Vector3 to = handle.position - pose.position;
            pose.position += 0.002 * random.in_cube() + (to.norm() > 0.07 ? 0.02 : -0.02) * to;
            pose.orientation =
                (compute_exp(0.05 * random.in_cube() + Vector3(0.01, 0.0, 0.02)) * pose.orientation)
                    .normalized();
        }
        handle.orientation =
            (compute_exp(0.03 * random.in_cube()) * handle.orientation).normalized();
        const ToolFelt felt = scene.step(handle);
        REQUIRE(felt.moved);
        n_touching += scene.god.touches()[0].touches || scene.god.touches()[1].touches ? 1 : 0;
        n_wedged += scene.god.last_step().wedged ? 1 : 0;
        CAPTURE(i, scene.god.last_step().rounds, scene.god.last_step().contacts);
        REQUIRE_FALSE(scene.is_inside());
    }
    CHECK(n_touching > 300);
    CHECK(n_wedged < 500);
    // Drawn away, both are where they are said to be.
    for (int i = 0; i < 100; ++i) {
        scene.frames[0].pose_W.position.y() -= 0.001;
        scene.frames[1].pose_W.position.y() += 0.001;
        (void)scene.step(handle);
        REQUIRE_FALSE(scene.is_inside());
    }
    CHECK_FALSE(scene.god.last_step().wedged);
}

TEST_CASE(
    "god-object tool: between two objects that close upon it it is wedged, which is told; when "
    "they open they are where they are said to be") {
    const TriangleMesh jaw = make_box({0.1, 0.1, 0.1}).value();
    Scene scene(make_cube(), {jaw, jaw});
    const double apart_m = kHalf_m + 0.05;
    bool was_wedged = false;
    scene.frames[0].pose_W = Pose::at({-apart_m - 0.002, 0.0, 0.0});
    scene.frames[1].pose_W = Pose::at({apart_m + 0.002, 0.0, 0.0});
    scene.god.place(Pose{});
    for (int i = 0; i < 200; ++i) {
        const double side_m = apart_m + 0.002 * std::cos(0.0315 * i);
        scene.frames[0].pose_W.position.x() = -side_m;
        scene.frames[1].pose_W.position.x() = side_m;
        (void)scene.step(Pose{});
        const bool wedged = scene.god.last_step().wedged;
        was_wedged = was_wedged || wedged;
        CAPTURE(i, side_m - apart_m);
        REQUIRE_FALSE(scene.is_inside());
        CHECK(wedged == (side_m < apart_m + 0.6 * kGap_m));
    }
    CHECK(was_wedged);
    CHECK_FALSE(scene.god.last_step().wedged);
    CHECK(scene.god.object_W(0).position == scene.frames[0].pose_W.position);
}

TEST_CASE("god-object tool: spun at 20 rad/s in a cage it stays inside") {
    // A cube in a box without a lid of bars: five sheets a little wider than its diagonal, and narrower ones above.
    const TriangleMesh cage = make_inverted(make_box(Vector3::Constant(0.056)).value()).value();
    Scene scene(make_cube(), {cage});
    scene.god.place(Pose{});
    Pose handle{};
    double largest_N = 0.0;
    for (int i = 0; i < 1500; ++i) {
        const Vector3 axis = Vector3(std::sin(0.002 * i), std::cos(0.003 * i), 0.4).normalized();
        handle.orientation =
            (compute_exp(20.0 * kGodDt_s * axis) * handle.orientation).normalized();
        handle.position = 0.01 * Vector3(std::sin(0.05 * i), std::sin(0.031 * i), 0.0);
        const ToolFelt felt = scene.step(handle);
        REQUIRE(felt.moved);
        largest_N = std::max(largest_N, felt.felt_W.force.norm());
        REQUIRE_FALSE(scene.is_inside());
        REQUIRE(scene.god.centre_W().cwiseAbs().maxCoeff() < 0.028);
    }
    CHECK(largest_N > 0.1);
    CHECK(largest_N < kStiffness * 0.05);
}

TEST_CASE("god-object tool: a thin sheet goes in between two sheets") {
    const TriangleMesh sheet = make_plate(0.1, 0.1, 6).value();
    Scene scene(make_plate(0.04, 0.04, 5).value(), {sheet, sheet});
    constexpr double kRoom_m = 2.0e-5;
    scene.frames[0].pose_W = Pose::at({0.0, -0.5 * kRoom_m, 0.0});
    scene.frames[1].pose_W = Pose::at({0.0, 0.5 * kRoom_m, 0.0});
    scene.god.place(Pose::at({0.1, 0.0, 0.0}));
    for (int i = 0; i < 800; ++i) {
        const double in = std::min(0.003 * i, 1.0);
        const Pose handle{Vector3(0.1 * (1.0 - in), 0.002 * std::sin(0.05 * i), 0.0),
                          compute_exp(Vector3(0.1 * in * std::sin(0.03 * i), 0.3 * in, 0.0))};
        const Pose outside = Pose::at({0.1 * (1.0 - in), 0.0, 0.0});
        const ToolFelt felt = scene.step(i < 300 ? outside : handle);
        REQUIRE(felt.moved);
        REQUIRE_FALSE(scene.is_inside());
        CHECK(std::abs(scene.god.centre_W().y()) < 0.5 * kRoom_m);
    }
    CHECK(std::abs(scene.god.centre_W().x()) < 1.0e-4);
    CHECK(std::abs(find_way(Pose{}, scene.god.pose_W())[3]) < 1.1e-3);
}

TEST_CASE("god-object tool: a thousand redundant contacts give the force of three") {
    // The corners of a plate of loose squares over a floor.
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    constexpr int kN = 18;
    for (int i = 0; i < kN * kN; ++i) {
        const Vector3 at(0.002 * (i % kN) - 0.018, 0.0,
                         0.002 * static_cast<double>(i / kN) - 0.018);
        const auto first = static_cast<std::int32_t>(vertices.size());
        vertices.insert(vertices.end(),
                        {at, at + Vector3(0.001, 0.0, 0.0), at + Vector3(0.0, 0.0, 0.001)});
        triangles.push_back({first, first + 2, first + 1});
    }
    const TriangleMesh brush = TriangleMesh::build(vertices, triangles).value();
    Scene scene(brush, {make_plate(0.3, 0.3, 3).value()});
    scene.god.place(Pose::at({0.0, 0.001, 0.0}));
    for (int i = 0; i < 60; ++i) {
        const ToolFelt felt = scene.step(Pose::at({0.0001 * i, -0.002, 0.0}));
        REQUIRE_FALSE(scene.is_inside());
        if (i > 30) {
            CHECK(scene.god.last_step().contacts >= 3 * kN * kN);
            CHECK((felt.felt_W.force - Vector3(0.0, kStiffness * (0.002 + kGap_m), 0.0)).norm() <
                  1.0e-6);
            CHECK(felt.felt_W.torque.norm() < 1.0e-6);
        }
    }
}

TEST_CASE(
    "god-object tool: nothing gets through a mesh with cracks, flipped and doubled triangles") {
    const TriangleMesh whole = make_bumpy_sphere(0.04, 5, 0.15, 80.0).value();
    const TriangleMesh broken = GENERATE_COPY(0, 1) == 0
                                    ? make_messy(whole, 0.0).value()
                                    : make_cracked(whole, 1.0e-4, 3, 0.0).value();
    Scene scene(make_cube(), {broken});
    scene.god.place(Pose::at({0.0, 0.08, 0.0}));
    Random random(2);
    Vector3 about(0.0, 0.05, 0.0);
    int n_touching = 0;
    for (int i = 0; i < 400; ++i) {
        about = 0.03 * (about + 0.004 * random.in_cube()).normalized();
        const Pose handle{i < 30 ? Vector3(0.0, 0.08 - 0.0015 * i, 0.0) : about,
                          compute_exp(Vector3(0.002 * i, 0.001 * i, 0.0))};
        const ToolFelt felt = scene.step(handle);
        REQUIRE(felt.moved);
        n_touching += scene.god.touches()[0].touches ? 1 : 0;
        REQUIRE_FALSE(scene.is_inside());
        REQUIRE(scene.god.centre_W().norm() > 0.04);
    }
    CHECK(n_touching > 300);
}

TEST_CASE("god-object tool: a peg that a torque wedges in a slot holds, lets go, and slides out") {
    const TriangleMesh slot = test::make_block_with_hole(8, 0.0205, 0.06, 0.04);
    const TriangleMesh peg = make_box({0.028, 0.028, 0.1}).value();
    Scene scene(peg, {slot}, test::make_god_settings(make_box_inertia(0.1, {0.028, 0.028, 0.1})));
    scene.god.place(Pose{});
    ToolFelt felt;
    for (int i = 0; i < 300; ++i) {
        felt = scene.step(
            {Vector3(0.0, 0.0, 0.004 * std::sin(0.1 * i)), compute_exp(Vector3(0.6, 0.2, 0.0))});
        REQUIRE(felt.moved);
        REQUIRE_FALSE(scene.is_inside());
    }
    CHECK(felt.felt_W.torque.norm() > 0.02);
    // Held as it stands, the same again and again.
    const Pose wedged = scene.god.pose_W();
    const Pose held{Vector3(0.0, 0.0, 0.004 * std::sin(0.1 * 299)),
                    compute_exp(Vector3(0.6, 0.2, 0.0))};
    for (int i = 0; i < 100; ++i) {
        felt = scene.step(held);
    }
    CHECK(find_way(wedged, scene.god.pose_W()).norm() < 2.0e-3);
    for (int i = 0; i < 100; ++i) {
        felt = scene.step(Pose::at({0.0, 0.0, 0.002 * i}));
        REQUIRE_FALSE(scene.is_inside());
    }
    CHECK(scene.god.centre_W().z() > 0.19);
    CHECK(felt.felt_W.force.norm() < 1.0e-9);
}

}  // namespace
}  // namespace fulcrum
