#include "runtime/lesson/tool_extent.h"

#include "haptics/geometry/shape.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>

using namespace fulcrum::runtime::test;

namespace {

// A cylinder of 2 cm by 30 cm that lies along x in its principal axes' frame, and is held upright 10 cm below its middle.
ToolPlan make_plan(bool in_voxels) {
    const Quaternion handle_turn(
        AngleAxis(0.5 * std::numbers::pi, Vector3::UnitZ()));  // x of T is y of the handle
    ToolOrder order;
    order.settings.handle_turn = handle_turn;
    order.settings.grip_T = Vector3(-0.1, 0.0, 0.0);
    const Pointshell upright =
        make_surface_pointshell(make_cylinder(0.01, 0.3, 48).value(), 20000).value();
    order.shell = std::make_shared<const Pointshell>(
        make_moved(upright, {Vector3::Zero(), handle_turn.conjugate()}));
    return in_voxels ? make_voxel_tool_plan(order, {nullptr})
                     : make_field_tool_plan(order, {nullptr}).value();
}

// The same stick as contact levels.
ToolPlan make_plan_of_levels() {
    const TriangleMesh upright = make_cylinder(0.01, 0.3, 48).value();
    const Quaternion turn(AngleAxis(-0.5 * std::numbers::pi, Vector3::UnitZ()));
    std::vector<Vector3> vertices = upright.vertices_B();
    for (Vector3& vertex : vertices) {
        vertex = turn * vertex;
    }
    const auto levels =
        ContactLevels::create(TriangleMesh::build(vertices, upright.triangles()).value()).value();
    ToolPlan plan = make_plan(false);
    plan.objects = std::vector<LevelContactsPlan>{{levels, levels, {}}};
    return plan;
}

}  // namespace

TEST_CASE("tool extent: how far a stick reaches from the hand in each direction, turned or not") {
    constexpr double kBetweenPoints_m = 0.003;
    for (const ToolPlan& plan : {make_plan(true), make_plan(false), make_plan_of_levels()}) {
        const auto extent_m = [&](const Quaternion& turn_W, const Vector3& way) {
            return compute_tool_extent_m(plan, turn_W, way);
        };
        const Quaternion upright = Quaternion::Identity();
        CHECK(extent_m(upright, Vector3::UnitY()) == Approx(0.25).margin(kBetweenPoints_m));
        CHECK(extent_m(upright, -Vector3::UnitY()) == Approx(0.05).margin(kBetweenPoints_m));
        CHECK(extent_m(upright, Vector3::UnitX()) == Approx(0.01).margin(kBetweenPoints_m));
        CHECK(extent_m(upright, Vector3::UnitZ()) == Approx(0.01).margin(kBetweenPoints_m));
        const Quaternion leaned(AngleAxis(-0.5 * std::numbers::pi, Vector3::UnitZ()));
        CHECK(extent_m(leaned, Vector3::UnitX()) == Approx(0.25).margin(kBetweenPoints_m));
        CHECK(extent_m(leaned, Vector3::UnitY()) == Approx(0.01).margin(kBetweenPoints_m));
    }
}
