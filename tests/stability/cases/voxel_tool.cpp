// A tool of points on its coupling where voxel sampling is hardest: a wedge, a peg in a hole, flat on ten thousand points, a gear in
// a gear, light and heavy tools at the coupling's clamp, and a count of contacts that goes to and fro over the average's N.
#include "haptics/tool/voxel_tool.h"

#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/voxel/voxelise.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/gear.h"

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace fulcrum::stability {
namespace {

constexpr double kDt_s = 0.001;

struct Scene {
    TriangleMesh object;
    double voxel_m;
    TriangleMesh tool;
    int n_points;
    Inertia inertia;
    double stiffness_N_per_m = 1000.0;
    VoxelSamplingSettings sampling{};
};

VoxelTool make_tool(Scene scene) {
    scene.sampling.stiffness_N_per_m = scene.stiffness_N_per_m;
    const auto grid = std::make_shared<const VoxelGrid>(
        voxelise(scene.object, {.voxel_m = scene.voxel_m}).value());
    VoxelToolSettings settings;
    settings.coupling.turn.stiffness_Nm_per_rad = 0.1;
    settings.inertia = scene.inertia;
    settings.integrator.newton_iterations = 8;
    return VoxelTool::build(
               {grid, nullptr, make_surface_pointshell(scene.tool, scene.n_points).value(),
                scene.sampling},
               settings)
        .value();
}

// What a course led to: the worst of its last fifth, when the hand has been still for long.
struct Rest {
    double speed_m_per_s = 0.0;
    double ripple_N = 0.0;  // between the least and the greatest force felt
    double felt_N = 0.0;
    std::int64_t n_surface = 0;
    std::int64_t n_interior = 0;  // at any time
};

// The handle goes by `course` of 0 to 1 in the first half, and stays.
Rest run(VoxelTool& tool, int n_steps, const std::function<Pose(double)>& course) {
    Rest rest;
    tool.place(course(0.0));
    double least_N = HUGE_VAL;
    double most_N = 0.0;
    for (int i = 1; i <= n_steps; ++i) {
        const double share = std::min(1.0, 2.0 * i / n_steps);
        const VoxelToolResult result = tool.step({course(share), {}}, {}, i * kDt_s, kDt_s);
        rest.n_interior = std::max(rest.n_interior, result.contact.n_interior);
        if (i > n_steps * 4 / 5) {
            const double felt_N = result.felt_W.force.norm();
            rest.speed_m_per_s = worse(rest.speed_m_per_s, tool.state().velocity_W.linear.norm());
            least_N = std::min(least_N, felt_N);
            most_N = worse(most_N, felt_N);
            rest.felt_N = felt_N;
            rest.n_surface = result.contact.n_surface;
        }
    }
    rest.ripple_N = most_N - least_N;
    return rest;
}

std::string tell(const Rest& rest) {
    std::array<char, 128> text{};
    std::snprintf(text.data(), text.size(),
                  "%.2g N felt, ripple %.1g N, %d in the surface, %d inside", rest.felt_N,
                  rest.ripple_N, static_cast<int>(rest.n_surface),
                  static_cast<int>(rest.n_interior));
    return text.data();
}

std::function<Pose(double)> along(const Vector3& from, const Vector3& to) {
    return [from, to](double share) { return Pose::at(from + share * (to - from)); };
}

// Two plates that meet at 20 degrees; a block's edge is driven between them.
TriangleMesh make_wedge() {
    const double half = 0.1745;
    std::vector<Vector3> corners;
    std::vector<TriangleCorners> triangles;
    for (const double side : {-1.0, 1.0}) {
        const TriangleMesh plate = make_box({0.01, 0.12, 0.06}).value();
        const auto first = static_cast<std::int32_t>(corners.size());
        const Quaternion turn = compute_exp({0.0, 0.0, -side * half});
        for (const Vector3& corner : plate.vertices_B()) {
            corners.emplace_back(turn * corner + Vector3(side * 0.0165, 0.0, 0.0));
        }
        for (const auto& [a, b, c] : plate.triangles()) {
            triangles.push_back({a + first, b + first, c + first});
        }
    }
    return TriangleMesh::build(std::move(corners), std::move(triangles)).value();
}

Finding press_into_wedge() {
    VoxelTool tool = make_tool({make_wedge(), 0.002, make_box({0.012, 0.03, 0.03}).value(), 2000,
                                make_box_inertia(0.05, {0.012, 0.03, 0.03})});
    const Rest rest = run(tool, 3000, along({0.0, 0.09, 0.0}, {0.0, -0.04, 0.0}));
    return {rest.speed_m_per_s, 0.02, tell(rest)};
}

Finding put_peg_in_hole() {
    VoxelTool tool = make_tool({make_bush(0.02, 0.0115, 0.03, 35).value(), 0.0005,
                                make_peg(0.01, 0.06, 72).value(), 4000,
                                make_box_inertia(0.05, {0.02, 0.02, 0.06})});
    // In, and pressed against the wall, to which the brakes let it creep.
    const Rest rest = run(tool, 8000, [](double share) {
        const double in = std::min(1.0, 2.0 * share);
        return Pose::at({0.003 * std::max(0.0, 2.0 * share - 1.0), 0.0, 0.07 - 0.07 * in});
    });
    const bool missed = rest.n_interior > 0 || rest.n_surface == 0;
    return {worse(rest.speed_m_per_s, missed ? 1.0 : 0.0), 0.02, tell(rest)};
}

Finding rest_on_ten_thousand() {
    // 24 000 points on all sides, some 10 000 below.
    VoxelTool tool =
        make_tool({make_box({0.2, 0.02, 0.2}).value(), 0.002, make_box({0.1, 0.01, 0.1}).value(),
                   24000, make_box_inertia(0.1, {0.1, 0.01, 0.1})});
    const Rest rest = run(tool, 1000, along({0.0, 0.02, 0.0}, {0.0, 0.012, 0.0}));
    const bool few = rest.n_surface < 9000;
    return {few ? HUGE_VAL : rest.speed_m_per_s, 1.0e-3, tell(rest)};
}

Finding turn_gear_in_gear() {
    const TriangleMesh gear = make_gear({}).value();
    VoxelTool tool =
        make_tool({gear, 0.001, gear, 6000, make_box_inertia(0.1, {0.08, 0.08, 0.02})});
    const Rest rest = run(tool, 2000, [](double share) {
        return Pose{{0.0935, 0.0, 0.0}, compute_exp({0.0, 0.0, -0.026 + 0.2 * share})};
    });
    return {rest.speed_m_per_s, 0.02, tell(rest)};
}

Finding press_at_clamp() {
    double worst = 0.0;
    std::string note;
    for (const double mass_kg : {0.01, 0.03, 0.1, 0.5}) {
        VoxelTool tool = make_tool({make_box({0.2, 0.04, 0.2}).value(), 0.005,
                                    make_box({0.04, 0.02, 0.04}).value(), 1000,
                                    make_box_inertia(mass_kg, {0.04, 0.02, 0.04})});
        // Four voxels deeper than the clamp reaches; the brakes let a heavy tool down slowly.
        const Rest rest = run(tool, 5000, along({0.0, 0.06, 0.0}, {0.0, 0.01, 0.0}));
        const double clamp_N = 500.0 * 0.0025;
        worst = worse(worst, rest.speed_m_per_s);
        worst = worse(worst, rest.n_interior > 0 ? 1.0 : 0.0);
        worst = worse(worst, std::abs(rest.felt_N - clamp_N));
        note += std::to_string(static_cast<int>(1000.0 * mass_kg)) + " g: " + tell(rest) + "; ";
    }
    return {worst, 0.02, note};
}

// Two points of eleven lie at the upper face of the layer that pushes and go in and out of it as the hand moves up and down by a millimetre: they push
// nothing there, but they count. The force felt may change by a tenth of the springs' at most, for 10/11 of them is given.
Finding cross_the_average() {
    Pointshell shell;
    for (int i = 0; i < 9; ++i) {
        shell.add({0.02 * (i % 3 - 1), -0.01, 0.02 * (i / 3 - 1)}, Vector3::UnitY());
    }
    shell.add({0.0005, -0.00696, 0.03}, Vector3::UnitY());
    shell.add({-0.0005, -0.00696, -0.03}, Vector3::UnitY());
    const auto grid = std::make_shared<const VoxelGrid>(
        voxelise(make_box({0.2, 0.04, 0.2}).value(), {.voxel_m = 0.005}).value());
    double worst = 0.0;
    std::string note;
    for (const ContactAveraging averaging : {ContactAveraging::beyond, ContactAveraging::smooth}) {
        VoxelSamplingSettings sampling;
        sampling.averaging = averaging;
        sampling.stiffness_N_per_m = 100.0;
        VoxelToolSettings settings;
        settings.coupling.turn.stiffness_Nm_per_rad = 0.1;
        settings.inertia = make_box_inertia(0.05, {0.04, 0.02, 0.06});
        settings.integrator.newton_iterations = 8;
        VoxelTool tool = VoxelTool::build({grid, nullptr, shell, sampling}, settings).value();
        tool.place(Pose::at({0.0, 0.03, 0.0}));
        double last_N = 0.0;
        double jump_N = 0.0;
        double mean_N = 0.0;
        int n_few = 0;
        int n_many = 0;
        for (int i = 1; i <= 4000; ++i) {
            const Pose handle = Pose::at({0.0, 0.0285 + 0.001 * std::sin(0.02 * i), 0.0});
            const VoxelToolResult result = tool.step({handle, {}}, {}, i * kDt_s, kDt_s);
            const double felt_N = result.felt_W.force.norm();
            if (i > 1000) {
                jump_N = worse(jump_N, std::abs(felt_N - last_N));
                mean_N += felt_N / 3000.0;
                n_few += result.contact.n_surface < 10 ? 1 : 0;
                n_many += result.contact.n_surface > 10 ? 1 : 0;
            }
            last_N = felt_N;
        }
        // It must have gone to and fro, or nothing was tried.
        worst = worse(worst, n_few > 100 && n_many > 100 ? jump_N / mean_N : HUGE_VAL);
        note += std::to_string(n_few) + " frames below 10, " + std::to_string(n_many) + " above; ";
    }
    return {worst, 0.1, note};
}

const HardCase kWedge{{"voxel tool in a wedge", "a block driven between two plates at 20 degrees",
                       "speed when the hand is still", "m/s", press_into_wedge}};
const HardCase kPeg{{"voxel peg in a hole", "288 triangles in 280, pressed against the wall",
                     "speed when the hand is still; 1 where a point got inside or none touches",
                     "m/s", put_peg_in_hole}};
const HardCase kFlat{{"voxel tool flat on ten thousand points", "a plate at rest on a plate",
                      "speed when the hand is still", "m/s", rest_on_ten_thousand}};
const HardCase kGears{{"voxel gear in a gear", "teeth turned against teeth",
                       "speed when the hand is still", "m/s", turn_gear_in_gear}};
const HardCase kClamp{{"voxel tools of 10 to 500 g at the clamp",
                       "pressed four voxels deeper than the coupling pulls",
                       "speed, or how far the force is from the clamp's", "m/s or N",
                       press_at_clamp}};
const HardCase kAverage{{"voxel contacts between 9 and 11",
                         "two of eleven points go in and out of the layer that pushes",
                         "change of the felt force in a frame, of the force", "",
                         cross_the_average}};

}  // namespace
}  // namespace fulcrum::stability
