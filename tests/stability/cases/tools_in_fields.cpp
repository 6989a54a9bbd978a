#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/voxel_tool.h"
#include "haptics/voxel/voxelise.h"
#include "tests/stability/cases/tool_course.h"
#include "tests/support/gear.h"
#include "tests/support/join_meshes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace fulcrum::stability {
namespace {

constexpr double kCoupling_N_per_m = 500.0;

struct Scene {
    TriangleMesh object;
    int n_along;
    TriangleMesh tool;
    int n_points;
    Inertia inertia;
    double stiffness_N_per_m = 100.0;  // of a point
};

FieldTool make_tool(const Scene& scene, ToolMass mass) {
    const VoxelFrame frame = make_field_frame(scene.object, scene.n_along).value();
    FieldSamplingPlan plan;
    plan.field =
        std::make_shared<const DistanceField>(DistanceField::build(scene.object, frame).value());
    plan.shell = std::make_shared<const ShellTree>(
        ShellTree::build(make_surface_pointshell(scene.tool, scene.n_points).value()).value());
    plan.settings.stiffness_N_per_m = scene.stiffness_N_per_m;
    plan.settings.along = ForceAlong::slopes;
    VoxelToolSettings settings;
    settings.coupling.shift.stiffness_N_per_m = kCoupling_N_per_m;
    settings.coupling.turn.stiffness_Nm_per_rad = 0.1;
    settings.inertia = scene.inertia;
    settings.integrator.newton_iterations = 8;
    settings.mass = mass;
    return FieldTool::build(std::move(plan), settings).value();
}

// What a course led to: the worst of its last fifth, when the hand has been still for long.
struct Rest {
    double speed_m_per_s = 0.0;
    double felt_N = 0.0;
    double clamp_N = 0.0;
    std::int64_t n_touching = 0;
    bool went_through = false;  // at any time a point was as deep as the field knows
};

// The handle goes by `course` of 0 to 1 in the first half, and stays.
Rest press(const Scene& scene, ToolMass mass, int n_steps, const ToolCourse& course) {
    FieldTool tool = make_tool(scene, mass);
    Rest rest;
    rest.clamp_N = kCoupling_N_per_m * tool.coupling().clamp_m;
    tool.place(course(0.0));
    Vector3 last = tool.state().pose_W.position;
    for (int i = 1; i <= n_steps; ++i) {
        const double share = std::min(1.0, 2.0 * i / n_steps);
        const VoxelToolResult result = tool.step({course(share), {}}, {}, i * kToolDt_s, kToolDt_s);
        rest.went_through |= result.contact.n_interior > 0;
        const Vector3 now = tool.state().pose_W.position;
        if (i > n_steps * 4 / 5) {
            // By its places, for a tool without mass has no velocity.
            rest.speed_m_per_s = worse(rest.speed_m_per_s, (now - last).norm() / kToolDt_s);
            rest.felt_N = result.felt_W.force.norm();
            rest.n_touching = result.contact.n_surface;
        }
        last = now;
    }
    return rest;
}

// Both kinds of tool. Speed in 20 mm/s, and the force off the clamp's, for the hand is far deeper than the coupling pulls.
Finding judge(const Scene& scene, int n_steps, const ToolCourse& course) {
    double worst = 0.0;
    std::string note;
    for (const ToolMass mass : {ToolMass::massive, ToolMass::massless}) {
        const Rest rest = press(scene, mass, n_steps, course);
        worst = worse(worst, rest.speed_m_per_s / 0.02);
        worst = worse(worst, std::abs(rest.felt_N - rest.clamp_N) / (0.05 * rest.clamp_N));
        worst = worse(worst, rest.went_through || rest.n_touching == 0 ? 100.0 : 0.0);
        note += describe("%s%.2g N of %.2g, %.1g mm/s, %d points",
                         note.empty() ? "" : "; without mass ", rest.felt_N, rest.clamp_N,
                         1.0e3 * rest.speed_m_per_s, static_cast<int>(rest.n_touching));
    }
    return {worst, 1.0, note};
}

Finding rest_field_on_ten_thousand() {
    const Vector3 size(0.1, 0.01, 0.1);
    return judge({make_box({0.2, 0.02, 0.2}).value(), 128, make_box(size).value(), 24000,
                  make_box_inertia(0.1, size), 10.0},
                 400, along({0.0, 0.02, 0.0}, {0.0, 0.005, 0.0}));
}

Finding put_field_peg_in_hole() {
    // Where it touches, a clamp of 0.1 N lets a peg of 50 g follow by 11 mm/s: it takes seven seconds to go in.
    return judge(
        {make_bush(0.02, 0.0115, 0.03, 35).value(), 96, make_peg(0.01, 0.06, 72).value(), 4000,
         make_box_inertia(0.05, {0.02, 0.02, 0.06})},
        24000, [](double share) {
            const double in = std::min(1.0, 2.0 * share);
            return Pose::at({0.006 * std::max(0.0, 2.0 * share - 1.0), 0.0, 0.07 - 0.07 * in});
        });
}

Finding press_field_at_clamp() {
    Finding all{0.0, 1.0, {}};
    for (const double mass_kg : {0.01, 0.03, 0.1, 0.5}) {
        const Vector3 size(0.04, 0.02, 0.04);
        const Finding one = judge({make_box({0.2, 0.04, 0.2}).value(), 64, make_box(size).value(),
                                   1000, make_box_inertia(mass_kg, size)},
                                  2000, along({0.0, 0.06, 0.0}, {0.0, 0.01, 0.0}));
        all.worst = worse(all.worst, one.worst);
        all.note += std::to_string(static_cast<int>(1000.0 * mass_kg)) + " g: " + one.note + ". ";
    }
    return all;
}

constexpr const char* kMeasured =
    "worst of: speed in 20 mm/s, force off the clamp's in 5 %; 100: a point went through or none "
    "touches";
const HardCase kFieldFlat{{"field tool flat on ten thousand points", "a plate at rest on a plate",
                           kMeasured, "", rest_field_on_ten_thousand}};
const HardCase kFieldPeg{{"field peg in a hole", "288 triangles in 280, pressed against the wall",
                          kMeasured, "", put_field_peg_in_hole}};
const HardCase kFieldClamp{{"field tools of 10 to 500 g at the clamp",
                            "pressed far deeper than the coupling pulls", kMeasured, "",
                            press_field_at_clamp}};

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
