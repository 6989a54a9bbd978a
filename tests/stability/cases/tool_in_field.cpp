// A tool of points on its coupling among distance fields: the hard cases of voxel_tool.cpp that a field has too, with the tool's mass
// and without. A field pushes from the surface on inwards, without a layer outside and without brakes.
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "tests/stability/cases/tool_course.h"
#include "tests/support/gear.h"

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
    const VoxelFrame frame = DistanceField::make_frame(scene.object, scene.n_along).value();
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

Finding rest_on_ten_thousand() {
    const Vector3 size(0.1, 0.01, 0.1);
    return judge({make_box({0.2, 0.02, 0.2}).value(), 128, make_box(size).value(), 24000,
                  make_box_inertia(0.1, size), 10.0},
                 400, along({0.0, 0.02, 0.0}, {0.0, 0.005, 0.0}));
}

Finding put_peg_in_hole() {
    // Where it touches, a clamp of 0.1 N lets a peg of 50 g follow by 11 mm/s: it takes seven seconds to go in.
    return judge(
        {make_bush(0.02, 0.0115, 0.03, 35).value(), 96, make_peg(0.01, 0.06, 72).value(), 4000,
         make_box_inertia(0.05, {0.02, 0.02, 0.06})},
        24000, [](double share) {
            const double in = std::min(1.0, 2.0 * share);
            return Pose::at({0.006 * std::max(0.0, 2.0 * share - 1.0), 0.0, 0.07 - 0.07 * in});
        });
}

Finding press_at_clamp() {
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
const HardCase kFlat{{"field tool flat on ten thousand points", "a plate at rest on a plate",
                      kMeasured, "", rest_on_ten_thousand}};
const HardCase kPeg{{"field peg in a hole", "288 triangles in 280, pressed against the wall",
                     kMeasured, "", put_peg_in_hole}};
const HardCase kClamp{{"field tools of 10 to 500 g at the clamp",
                       "pressed far deeper than the coupling pulls", kMeasured, "",
                       press_at_clamp}};

}  // namespace
}  // namespace fulcrum::stability
