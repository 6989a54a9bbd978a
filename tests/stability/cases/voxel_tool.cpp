// A tool of points on its coupling where voxel sampling is hardest: a wedge, a peg in a hole, flat on ten thousand points, a gear in
// a gear, light and heavy tools at the coupling's clamp, and a count of contacts that goes to and fro over the average's N.
#include "haptics/tool/voxel_tool.h"

#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/voxel/voxelise.h"
#include "tests/stability/cases/tool_course.h"
#include "tests/support/gear.h"
#include "tests/support/join_meshes.h"

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace fulcrum::stability {
namespace {

// Two plates that meet at 20 degrees; a block's edge is driven between them.
TriangleMesh make_wedge() {
    const double half = 0.1745;
    std::vector<std::pair<TriangleMesh, Pose>> plates;
    for (const double side : {-1.0, 1.0}) {
        plates.emplace_back(
            make_box({0.01, 0.12, 0.06}).value(),
            Pose{Vector3(side * 0.0165, 0.0, 0.0), compute_exp({0.0, 0.0, -side * half})});
    }
    return join_meshes(plates).value();
}

Finding press_into_wedge() {
    VoxelTool tool = make_voxel_tool({make_wedge(), 0.002, make_box({0.012, 0.03, 0.03}).value(),
                                      2000, make_box_inertia(0.05, {0.012, 0.03, 0.03})});
    // At the 5 cm/s that clamp and damper allow, and slower out of the brakes, the way back takes 3 s.
    const ToolRest rest = run_course(tool, 4000, along({0.0, 0.09, 0.0}, {0.0, -0.04, 0.0}));
    return judge_rest(tool, rest);
}

Finding put_peg_in_hole() {
    VoxelTool tool = make_voxel_tool({make_bush(0.02, 0.0115, 0.03, 35).value(), 0.0005,
                                      make_peg(0.01, 0.06, 72).value(), 4000,
                                      make_box_inertia(0.05, {0.02, 0.02, 0.06})});
    // In, and pressed against the wall, to which the brakes let it creep.
    const ToolRest rest = run_course(tool, 8000, [](double share) {
        const double in = std::min(1.0, 2.0 * share);
        return Pose::at({0.003 * std::max(0.0, 2.0 * share - 1.0), 0.0, 0.07 - 0.07 * in});
    });
    return judge_rest(tool, rest);
}

Finding rest_on_ten_thousand() {
    // 24 000 points on all sides, some 10 000 below.
    VoxelTool tool = make_voxel_tool({make_box({0.2, 0.02, 0.2}).value(), 0.002,
                                      make_box({0.1, 0.01, 0.1}).value(), 24000,
                                      make_box_inertia(0.1, {0.1, 0.01, 0.1})});
    const ToolRest rest = run_course(tool, 1000, along({0.0, 0.02, 0.0}, {0.0, 0.012, 0.0}));
    Finding finding = judge_rest(tool, rest, {.speed_m_per_s = 1.0e-3});
    finding.worst = rest.n_surface < 9000 ? HUGE_VAL : finding.worst;
    return finding;
}

Finding turn_gear_in_gear() {
    const TriangleMesh gear = make_gear({}).value();
    VoxelTool tool =
        make_voxel_tool({gear, 0.001, gear, 6000, make_box_inertia(0.1, {0.08, 0.08, 0.02})});
    // In along its axis, and turned until the teeth meet, to which the brakes let it creep.
    const ToolRest rest = run_course(tool, 12000, [](double share) {
        const double turn = std::max(0.0, 2.0 * share - 1.0);
        return Pose{{0.0935, 0.0, 0.03 * std::max(0.0, 1.0 - 2.0 * share)},
                    compute_exp({0.0, 0.0, -0.026 + 0.4 * turn})};
    });
    return judge_rest(tool, rest, {.by_torque = true});
}

Finding press_at_clamp() {
    double worst = 0.0;
    std::string note;
    for (const double mass_kg : {0.01, 0.03, 0.1, 0.5}) {
        VoxelTool tool = make_voxel_tool({make_box({0.2, 0.04, 0.2}).value(), 0.005,
                                          make_box({0.04, 0.02, 0.04}).value(), 1000,
                                          make_box_inertia(mass_kg, {0.04, 0.02, 0.04})});
        // Four voxels deeper than the clamp reaches; the brakes let a heavy tool down slowly.
        const ToolRest rest = run_course(tool, 5000, along({0.0, 0.06, 0.0}, {0.0, 0.01, 0.0}));
        const double clamp_N = 500.0 * 0.0025;
        worst = worse(worst, rest.speed_m_per_s);
        worst = worse(worst, rest.n_interior > 0 ? 1.0 : 0.0);
        worst = worse(worst, std::abs(rest.felt_N - clamp_N));
        note += std::to_string(static_cast<int>(1000.0 * mass_kg)) + " g: " + tell(rest) + "; ";
    }
    return {worst, 0.02, note};
}

// Changes from one frame to the next while two of eleven points come and go, of the mean: of what pushes the tool, and of what is felt.
struct Jumps {
    double pushed = 0.0;
    double felt = 0.0;
};

Jumps find_jumps(VoxelTool& tool) {
    constexpr int kSteps = 20000;
    constexpr int kSettled = 2000;
    Jumps most_N;
    Jumps mean_N;
    Jumps last_N;
    int n_few = 0;
    int n_many = 0;
    tool.place(Pose::at({0.0, 0.03, 0.0}));
    for (int i = 1; i <= kSteps; ++i) {
        const Pose handle = Pose::at({0.0, 0.0285 + 0.001 * std::sin(0.004 * i), 0.0});
        const VoxelToolResult result = tool.step({handle, {}}, {}, i * kToolDt_s, kToolDt_s);
        const Jumps now_N{result.contact.wrench_W.force.norm(), result.felt_W.force.norm()};
        if (i > kSettled) {
            most_N.pushed = worse(most_N.pushed, std::abs(now_N.pushed - last_N.pushed));
            most_N.felt = worse(most_N.felt, std::abs(now_N.felt - last_N.felt));
            mean_N.pushed += now_N.pushed / (kSteps - kSettled);
            mean_N.felt += now_N.felt / (kSteps - kSettled);
            n_few += result.contact.n_surface < 10 ? 1 : 0;
            n_many += result.contact.n_surface > 10 ? 1 : 0;
        }
        last_N = now_N;
    }
    // It must have gone to and fro, or nothing was tried.
    return n_few > 1000 && n_many > 1000
               ? Jumps{most_N.pushed / mean_N.pushed, most_N.felt / mean_N.felt}
               : Jumps{HUGE_VAL, HUGE_VAL};
}

// Two points of eleven lie at the upper face of the layer that pushes and go in and out of it as the hand moves up and down by a
// millimetre: they push nothing there, but they count. By `beyond` what pushes changes by a tenth at most, for 10/11 of it is given;
// by `smooth` it may not jump at all. Through the tool's mass and the coupling the hand feels a hundredth of either.
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
        sampling.braking = PreContactBraking::off;  // it comes and goes as well
        sampling.stiffness_N_per_m = 100.0;
        VoxelToolSettings settings;
        settings.coupling.turn.stiffness_Nm_per_rad = 0.1;
        settings.inertia = make_box_inertia(0.05, {0.04, 0.02, 0.06});
        settings.integrator.newton_iterations = 8;
        VoxelTool tool = VoxelTool::build({grid, nullptr, shell, sampling}, settings).value();
        const Jumps jumps = find_jumps(tool);
        const bool is_smooth = averaging == ContactAveraging::smooth;
        worst = worse(worst, jumps.pushed / (is_smooth ? 0.02 : 0.11));
        worst = worse(worst, jumps.felt / (is_smooth ? 0.02 : 0.05));
        note += describe("%s: %.2g of the push, %.2g of what is felt; ",
                         is_smooth ? "smooth" : "beyond", jumps.pushed, jumps.felt);
    }
    return {worst, 1.0, note};
}

const HardCase kWedge{{"voxel tool in a wedge", "a block driven between two plates at 20 degrees",
                       kRestMeasured, "", press_into_wedge}};
const HardCase kPeg{{"voxel peg in a hole", "288 triangles in 280, pressed against the wall",
                     kRestMeasured, "", put_peg_in_hole}};
const HardCase kFlat{{"voxel tool flat on ten thousand points", "a plate at rest on a plate",
                      kRestMeasured, "", rest_on_ten_thousand}};
const HardCase kGears{
    {"voxel gear in a gear", "teeth turned against teeth", kRestMeasured, "", turn_gear_in_gear}};
const HardCase kClamp{{"voxel tools of 10 to 500 g at the clamp",
                       "pressed four voxels deeper than the coupling pulls",
                       "speed, or how far the force is from the clamp's", "m/s or N",
                       press_at_clamp}};
const HardCase kAverage{
    {"voxel contacts between 9 and 11",
     "two of eleven points go in and out of the layer that pushes",
     "worst of: change of what pushes in a frame, in 11 % (smooth: 2 %), and of "
     "what is felt, in 5 % (2 %)",
     "", cross_the_average}};

}  // namespace
}  // namespace fulcrum::stability
