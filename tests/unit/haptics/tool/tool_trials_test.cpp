#include "haptics/dynamics/rigid_state.h"
#include "haptics/geometry/mesh_report.h"
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/tool_plan.h"
#include "haptics/voxel/voxelise.h"
#include "tests/support/gear.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace fulcrum;

namespace {

constexpr double kPi = 3.141592653589793;

constexpr double kDt_s = 1.0e-3;
constexpr double kStiffness_N_per_m = 500.0;
constexpr double kTop_m = 0.01;

struct Stick {
    double radius_m, length_m;
    double voxel_m;
};

VoxelTool make_stick(const Stick& stick, ToolMass mass) {
    const TriangleMesh floor = make_box({0.08, 2.0 * kTop_m, 0.08}).value();
    const TriangleMesh mesh = make_cylinder(stick.radius_m, stick.length_m, 48).value();
    ToolOrder order;
    order.shell =
        std::make_shared<const Pointshell>(make_voxel_pointshell(mesh, stick.voxel_m).value());
    const double r2 = stick.radius_m * stick.radius_m;
    order.settings.inertia.mass_kg = 0.02;
    const double across = 0.02 * (3.0 * r2 + stick.length_m * stick.length_m) / 12.0;
    order.settings.inertia.moments_kg_m2 = {across, 0.01 * r2, across};
    order.settings.mass = mass;
    const double reach_m = compute_reach_m(*order.shell);
    order.settings.coupling.shift.stiffness_N_per_m = kStiffness_N_per_m;
    order.settings.coupling.turn.stiffness_Nm_per_rad = kStiffness_N_per_m * reach_m * reach_m;
    const auto grid = std::make_shared<const VoxelGrid>(
        voxelise(floor, {.voxel_m = stick.voxel_m,
                         .offset_layers = 1,
                         .proximity_layers = static_cast<int>(std::ceil(0.004 / stick.voxel_m))})
            .value());
    const ToolPlan plan = make_voxel_tool_plan(order, {grid});
    return VoxelTool::build(std::get<std::vector<VoxelSamplingPlan>>(plan.objects), plan.settings)
        .value();
}

}  // namespace

// A tool with flat ends among voxels, as a plan makes it (tool_plan.h): it lies flat where it is pressed, and glides without drag.

TEST_CASE("flat tool: pressed a degree askew it lies flat and is pushed straight up") {
    // A point a voxel; points anywhere on the surface, as near to each other, make such a tool fall over.
    for (const Stick& stick : {Stick{0.01, 0.04, 0.001}, Stick{0.02, 0.1, 0.002},
                               Stick{0.02, 0.1, 0.004}, Stick{0.015, 0.07, 0.0015}}) {
        for (const ToolMass mass : {ToolMass::massive, ToolMass::massless}) {
            VoxelTool tool = make_stick(stick, mass);
            const Quaternion askew = compute_exp({0.02, 0.0, 0.014});
            const double touching_m = kTop_m + 0.5 * stick.length_m;
            tool.place({{0.0003, touching_m + 0.008, 0.0001}, askew});
            VoxelToolResult result;
            for (int i = 1; i <= 900; ++i) {
                const double y = touching_m + 0.008 - 0.010 * std::min(1.0, i / 400.0);
                result = tool.step({{{0.0003, y, 0.0001}, askew},
                                    {{0.0, i <= 400 ? -0.025 : 0.0, 0.0}, Vector3::Zero()}},
                                   {}, i * kDt_s, kDt_s);
                REQUIRE(result.moved);
            }
            const Vector3& felt_N = result.felt_W.force;
            const double turned =
                compute_log(tool.state().pose_W.orientation * askew.conjugate()).norm();
            INFO(stick.radius_m << " x " << stick.length_m << ", voxels " << stick.voxel_m << ", "
                                << static_cast<int>(mass));
            // Two millimetres of the spring, and the layer that pushes: one voxel.
            CHECK(felt_N.y() > 0.9);
            CHECK(felt_N.y() < kStiffness_N_per_m * (0.002 + 1.4 * stick.voxel_m));
            CHECK(std::hypot(felt_N.x(), felt_N.z()) < 0.3 * felt_N.y());
            CHECK(turned < 0.03);
        }
    }
}

TEST_CASE("flat tool: gliding over a floor that it does not touch it feels nothing") {
    for (const double speed_m_per_s : {0.05, 0.2}) {
        VoxelTool tool = make_stick({0.02, 0.1, 0.001}, ToolMass::massive);
        const double y = kTop_m + 0.05 + 0.0025;
        const double start_m = -0.01;
        tool.place(Pose::at({start_m, y, 0.0}));
        double most_N = 0.0;
        for (int i = 1; i <= 100; ++i) {
            const Vector3 at(start_m + i * kDt_s * speed_m_per_s, y, 0.0);
            const VoxelToolResult result = tool.step(
                {Pose::at(at), {{speed_m_per_s, 0.0, 0.0}, Vector3::Zero()}}, {}, i * kDt_s, kDt_s);
            CHECK(result.contact.n_surface == 0);
            // What the tool's own start takes is over soon.
            most_N = i > 50 ? std::max(most_N, result.felt_W.force.norm()) : most_N;
        }
        INFO(speed_m_per_s);
        CHECK(most_N < 0.01);
    }
}

// The bodies that tools are tried on are closed and of the size they say.

TEST_CASE("gear, peg and bush: closed, their triangles and volumes as told, and the peg fits") {
    const GearSettings settings;
    const auto gear = make_gear(settings).value();
    const MeshReport report = compute_mesh_report(gear);
    CHECK(report.is_sound());
    CHECK(report.n_triangles == 32 * settings.n_teeth);
    CHECK(report.size_m.z() == Approx(settings.width_m));
    // Between the rings of root and tip, less the bore.
    const auto ring_m3 = [&](double radius_m) {
        return kPi * settings.width_m * (radius_m * radius_m - settings.bore_m * settings.bore_m);
    };
    CHECK(report.volume_m3 > 0.9 * ring_m3(settings.root_m));
    CHECK(report.volume_m3 < ring_m3(settings.tip_m));
    const MeshReport peg = compute_mesh_report(make_peg(0.01, 0.06, 72).value());
    const MeshReport bush = compute_mesh_report(make_bush(0.02, 0.0105, 0.03, 35).value());
    CHECK(peg.is_sound());
    CHECK(bush.is_sound());
    CHECK(peg.n_triangles == 288);
    CHECK(bush.n_triangles == 280);
    CHECK(peg.volume_m3 == Approx(kPi * 0.0001 * 0.06).epsilon(0.002));
    CHECK(bush.volume_m3 == Approx(kPi * (0.0004 - 0.0105 * 0.0105) * 0.03).epsilon(0.01));
}
