// What the accuracy of touch with a tool costs: voxels, points, precision, the tree's depth and budgets of time against the error of
// force and torque, where these are known (accuracy_scenes.h).
#include "haptics/tool/field_sampling/field_sampler.h"
#include "haptics/tool/voxel_sampling/voxel_sampling.h"
#include "haptics/voxel/voxelise.h"
#include "tests/bench/curves/accuracy_scenes.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

constexpr double kUsualCells = 128.0;
constexpr double kUsualPoints = 20000.0;
constexpr const char* kSingle = "distance field, single precision";
constexpr const char* kDouble = "distance field, double precision, one by one";

FieldSampler::Field make_field(const AccuracyScene& scene, double n_along) {
    return make_distance_field(scene.object, static_cast<int>(n_along));
}

FieldSampler::Shell make_shell(const Pointshell& points) {
    return std::make_shared<const ShellTree>(ShellTree::build(points).value());
}

// Root mean squares over all poses, %: of the force, and of the torque over force and reach; what a pose takes.
template <class Step>
CostPoint judge(const std::string& series, double knob, const AccuracyScene& scene, double reach_m,
                std::size_t bytes, Step step) {
    double force_squares = 0.0;
    double torque_squares = 0.0;
    std::vector<double> us;
    for (int round = 0; round < 2; ++round) {  // the first warms up
        us.clear();
        force_squares = 0.0;
        torque_squares = 0.0;
        for (std::size_t i = 0; i < scene.X_OT.size(); ++i) {
            Wrench wrench;
            time_batches([&] { wrench = step(scene.X_OT[i]); },
                         {.samples = 1, .batch = 1, .warm_up = 0}, us);
            const Wrench& known = scene.wrenches_O[i];
            const double force = known.force.norm();
            force_squares += (wrench.force - known.force).squaredNorm() / (force * force);
            torque_squares +=
                (wrench.torque - known.torque).squaredNorm() / (reach_m * reach_m * force * force);
        }
    }
    const auto n = static_cast<double>(scene.X_OT.size());
    return {series,
            knob,
            100.0 * std::sqrt(force_squares / n),
            summarise(std::move(us), bytes),
            {100.0 * std::sqrt(torque_squares / n)}};
}

CostPoint judge_field(const std::string& series, double knob, const AccuracyScene& scene,
                      const FieldSampler::Field& field, const FieldSampler::Shell& shell,
                      FieldSamplingSettings settings) {
    settings.stiffness_N_per_m = scene.area_m2 / static_cast<double>(shell->n_points());
    settings.along = ForceAlong::normals;
    FieldSampler sampler = FieldSampler::build(field, shell, settings).value();
    return judge(series, knob, scene, shell->reach_m(),
                 field->memory_bytes() + shell->memory_bytes() + sampler.memory_bytes(),
                 [&](const Pose& X_OT) { return sampler.step({}, X_OT).wrench_W; });
}

Wrench sum_in_double(const DistanceField& field, const Pointshell& points, double k,
                     const Pose& X_OT) {
    Wrench sum;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3 arm_O = X_OT.orientation * points.position_T(i);
        const double depth_m = field.sample_depth(X_OT.position + arm_O).depth_m;
        if (depth_m > 0.0) {
            const Vector3 force = k * depth_m * (X_OT.orientation * points.normal_T(i));
            sum.force += force;
            sum.torque += arm_O.cross(force);
        }
    }
    return sum;
}

CostPoint judge_double(double knob, const AccuracyScene& scene, const DistanceField& field,
                       const Pointshell& points, double reach_m) {
    const double k = scene.area_m2 / static_cast<double>(points.size());
    return judge(kDouble, knob, scene, reach_m, field.memory_bytes() + points.memory_bytes(),
                 [&](const Pose& X_OT) { return sum_in_double(field, points, k, X_OT); });
}

// The library's way, and in double precision.
void judge_both(double knob, const AccuracyScene& scene, const FieldSampler::Field& field,
                const Pointshell& points, const FieldSampler::Shell& shell, CostCurve& curve) {
    curve.points.push_back(
        judge_field(kSingle, knob, scene, field, shell, {.mode = SamplingMode::tree}));
    curve.points.push_back(judge_double(knob, scene, *field, points, shell->reach_m()));
}

// `how` goes on with what all poses are.
CostCurve make_curve(const AccuracyScene& scene, const std::string& knob, const std::string& what,
                     const std::string& how, const std::string& advice, const Axis& axis,
                     const std::string& default_series, double default_knob) {
    CostCurve curve;
    curve.name = "field-accuracy-" + scene.name + "-" + knob;
    curve.title = scene.title + ": " + what;
    curve.work =
        "A tool, pressed in by a hundredth of the object's size, or more where less than one in "
        "200 of its points is in, turned and shifted by chance; the sum of its points' forces and "
        "torques" +
        how;
    curve.reference = scene.reference;
    curve.advice = advice;
    curve.knob = axis;
    curve.error = {"error of the force, root mean square", "%", true};
    curve.extras = {{"error of the torque over force and reach", "%", true}};
    curve.default_series = default_series;
    curve.default_knob = default_knob;
    curve.time_is_per = "pose";
    return curve;
}

CostCurve vary_voxels(const Run& run, const AccuracyScene& scene) {
    CostCurve curve = make_curve(
        scene, "voxels", "how fine a field", "; 20 000 points, 5000 in a quick run.",
        "128 voxels along the object are as exact as 20 000 points; halve both together.",
        {"voxels along the object", "", true}, kSingle, kUsualCells);
    const Pointshell points = scene.make_shell(run.pick(static_cast<int>(kUsualPoints), 5000));
    const FieldSampler::Shell shell = make_shell(points);
    for (const double n :
         run.pick<std::vector<double>>({32, 64, kUsualCells, 256, 512}, {32, kUsualCells})) {
        judge_both(n, scene, make_field(scene, n), points, shell, curve);
    }
    return curve;
}

CostCurve vary_points(const Run& run, const AccuracyScene& scene,
                      const FieldSampler::Field& field) {
    CostCurve curve =
        make_curve(scene, "points", "how many points",
                   "; a field of 256 voxels along the object, 128 in a quick run.",
                   "Points are cheap where few touch: take as many as lie half a voxel apart.",
                   {"points", "", true}, kSingle, kUsualPoints);
    for (const double n : run.pick<std::vector<double>>({1000, 5000, kUsualPoints, 100000, 1000000},
                                                        {1000, kUsualPoints})) {
        const Pointshell points = scene.make_shell(static_cast<int>(n));
        judge_both(n, scene, field, points, make_shell(points), curve);
    }
    return curve;
}

CostCurve vary_budget(const Run& run, const AccuracyScene& scene,
                      const FieldSampler::Field& field) {
    CostCurve curve = make_curve(
        scene, "budget", "a budget of time",
        " within a budget, each pose a jump from the last; a million points, 50 000 in a quick "
        "run.",
        "Give what the tick can spare; where all that touches fits, nothing is lost.",
        {"budget", "us", true}, "budget", 100.0);
    const FieldSampler::Shell shell = make_shell(scene.make_shell(run.pick(1000000, 50000)));
    for (const double us : run.pick<std::vector<double>>({10, 20, 50, 100, 200, 500}, {10, 100})) {
        curve.points.push_back(judge_field("budget", us, scene, field, shell, {.budget_us = us}));
    }
    return curve;
}

CostCurve vary_depth(const Run& run, const AccuracyScene& scene) {
    constexpr int kVoxelsAlong = 76;
    CostCurve curve =
        make_curve(scene, "depth", "voxels of two bits in a tree",
                   ", by tangent planes of 80 voxels along the object, 20 000 points, 5000 in a "
                   "quick run; depth 0: a byte a voxel, no tree.",
                   "The depth changes time and memory, not the force, which a surface of voxels "
                   "tells to half a voxel only: take a distance field for exact forces.",
                   {"depth of the tree", "", false}, "voxmap", 0.0);
    const auto grid = std::make_shared<const VoxelGrid>(
        voxelise(scene.object, {.voxel_m = compute_voxel_m(scene.object, kVoxelsAlong)}).value());
    const Pointshell points = scene.make_shell(run.pick(static_cast<int>(kUsualPoints), 5000));
    VoxelSamplingSettings settings;
    settings.stiffness_N_per_m = scene.area_m2 / static_cast<double>(points.size());
    settings.averaging = ContactAveraging::none;
    settings.braking = PreContactBraking::off;
    for (const int depth : {0, 1, 2, 3}) {
        VoxelSamplingPlan plan{nullptr, nullptr, points, settings};
        if (depth == 0) {
            plan.grid = grid;
        } else {
            plan.map = std::make_shared<const Voxmap>(Voxmap::build(*grid, depth).value());
        }
        const VoxelSampling sampling = VoxelSampling::build(std::move(plan)).value();
        curve.points.push_back(judge("voxmap", depth, scene, sampling.reach_m(),
                                     sampling.memory_bytes(), [&](const Pose& X_OT) {
                                         RigidState state;
                                         state.pose_W = X_OT;
                                         return sampling.sample(state, {}).wrench_W;
                                     }));
    }
    return curve;
}

// Where no formula tells.
void converge(const Run& run, AccuracyScene& scene) {
    const FieldSampler::Field field = make_field(scene, run.pick(512.0, kUsualCells));
    const FieldSampler::Shell shell = make_shell(scene.make_shell(run.pick(4000000, 60000)));
    FieldSampler sampler =
        FieldSampler::build(
            field, shell,
            {.stiffness_N_per_m = scene.area_m2 / static_cast<double>(shell->n_points()),
             .along = ForceAlong::normals,
             .mode = SamplingMode::tree})
            .value();
    for (const Pose& X_OT : scene.X_OT) {
        scene.wrenches_O.push_back(sampler.step({}, X_OT).wrench_W);
    }
}

Report run_field_accuracy(Run& run) {
    const int n_poses = run.pick(60, 8);
    std::vector<AccuracyScene> scenes;
    scenes.push_back(make_sphere_plane(n_poses));
    scenes.push_back(make_cylinder_box(n_poses));
    scenes.push_back(make_free_forms(n_poses, run.mesh_file(), run.tool_file()));
    converge(run, scenes.back());
    Report report;
    for (const AccuracyScene& scene : scenes) {
        const FieldSampler::Field field = make_field(scene, run.pick(256.0, kUsualCells));
        report.emplace_back(vary_voxels(run, scene));
        report.emplace_back(vary_points(run, scene, field));
        report.emplace_back(vary_depth(run, scene));
        report.emplace_back(vary_budget(run, scene, field));
        run.progress(static_cast<double>(report.size()) / 12.0, scene.name);
    }
    return report;
}

const Registration kFieldAccuracy{
    {"field-accuracy",
     "voxels, points, precision, depth and budgets against the error of force and torque",
     run_field_accuracy}};

}  // namespace
}  // namespace fulcrum::bench
