// Points against a distance field, all of them: value and slope of each, by the kernels for one processor and another, and in
// double precision one after the other.
#include "tests/bench/curves/field_points.h"

#include "haptics/tool/field_sampling/slope_sum.h"
#include "haptics/voxel/distance_field_batch.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

CostPoint measure_kernels(const FieldKernels& kernels, const FieldPointsTask& task,
                          const DistanceField& field, const Timing& timing) {
    const std::size_t n = task.shell.size();
    const ShellPoints points{task.shell.x_m.data(), task.shell.y_m.data(), task.shell.z_m.data(),
                             task.shell.nx.data(),  task.shell.ny.data(),  task.shell.nz.data()};
    std::array<std::vector<float>, 4> out;
    for (auto& values : out) {
        values.resize(n);
    }
    std::vector<std::int32_t> hits(n + 1);
    const std::array<float*, 3> slopes{out[1].data(), out[2].data(), out[3].data()};
    const Cost cost = measure_cost(
        [&] {
            kernels.sample(FieldView(field), FieldPlace(field, task.X_OT), points, n, out[0].data(),
                           slopes.data());
            keep(kernels.collect_hits(out[0].data(), n, hits.data()));
        },
        timing, field.memory_bytes());
    std::vector<double> values_m;
    for (const float value : out[0]) {
        values_m.push_back(field.step_m() * static_cast<double>(value));
    }
    return {std::string(kernels.name),
            static_cast<double>(n),
            find_rms_voxels(task, values_m),
            cost,
            {}};
}

// Derivatives of force and torque by the tool's pose, over the stiffness, of all whole leaves.
Matrix6 sum_slopes(const FieldKernels& kernels, const FieldPointsTask& task,
                   const DistanceField& field) {
    const ShellPoints points{task.shell.x_m.data(),
                             task.shell.y_m.data(),
                             task.shell.z_m.data(),
                             nullptr,
                             nullptr,
                             nullptr};
    const FieldView view(field);
    const FieldPlace place(field, task.X_OT);
    SlopeLanes lanes;
    Matrix6 slopes = Matrix6::Zero();
    for (std::size_t i = 0; i + kLeafPoints <= task.shell.size(); i += kLeafPoints) {
        // None is deeper than a voxel of three.
        keep(kernels.sum_slopes(
            view, place, {points.x + i, points.y + i, points.z + i, nullptr, nullptr, nullptr},
            kLeafPoints, lanes));
    }
    add_slope_lanes(field, lanes, slopes);
    return slopes;
}

Matrix6 sum_slopes_one_by_one(const FieldPointsTask& task, const DistanceField& field) {
    SlopeSum sum;
    for (std::size_t i = 0; i < task.shell.size() / kLeafPoints * kLeafPoints; ++i) {
        const Vector3 arm_O = task.X_OT.orientation * task.shell.position_T(i);
        const DepthSample depth = field.sample_depth(task.X_OT.position + arm_O);
        if (depth.depth_m > 0.0) {
            sum.add(depth, arm_O);
        }
    }
    Matrix6 slopes = Matrix6::Zero();
    sum.add_to(slopes);
    return slopes;
}

// How far they are off, in parts of each kind's own size: of force and torque, by shift and turn.
double find_worst_part(const Matrix6& slopes, const Matrix6& exact) {
    double worst = 0.0;
    for (int row = 0; row < 6; row += 3) {
        for (int column = 0; column < 6; column += 3) {
            const Matrix3 right = exact.block<3, 3>(row, column);
            const Matrix3 off = slopes.block<3, 3>(row, column) - right;
            worst = std::max(worst, off.norm() / right.norm());
        }
    }
    return worst;
}

CostCurve make_curve(const std::string& name, const std::string& title) {
    CostCurve curve;
    curve.name = name;
    curve.title = title;
    curve.advice = "Nothing is to be chosen: the best kernel of the processor is taken.";
    curve.knob = {"points", "", true};
    curve.default_series = std::string(best_field_kernels().name);
    curve.default_knob = kFieldPoints.back();
    return curve;
}

void measure_slopes(const FieldPointsTask& task, const DistanceField& field, const Timing& timing,
                    CostCurve& curve) {
    const Matrix6 exact = sum_slopes_one_by_one(task, field);
    const auto n = static_cast<double>(task.shell.size());
    for (const FieldKernels* const kernels : all_field_kernels()) {
        if (kernels != nullptr) {
            const Cost cost = measure_cost([&] { keep(sum_slopes(*kernels, task, field)); }, timing,
                                           field.memory_bytes());
            curve.add(std::string(kernels->name), n,
                      find_worst_part(sum_slopes(*kernels, task, field), exact), cost);
        }
    }
    const Cost cost = measure_cost([&] { keep(sum_slopes_one_by_one(task, field)); }, timing,
                                   field.memory_bytes());
    curve.add("one by one, double", n, 0.0, cost);
}

Report run_field_points(Run& run) {
    CostCurve slopes =
        make_curve("field-slopes", "How the force of a tool's points changes with its pose");
    slopes.work =
        "The same points: the derivatives of force and torque by the tool's pose, as backward "
        "Euler takes them, of those inside.";
    slopes.reference = "the same sums point by point in double precision";
    slopes.error = {"error, in parts of the largest of its kind", "", true};
    CostCurve curve = make_curve("field-points", "Value and slope at a tool's points");
    curve.work =
        "All points of a ball lie within a voxel of the same ball in 80 voxels along each side: "
        "trilinear value and slope of each, and the list of those inside.";
    curve.reference = "analytic: the distance to a sphere";
    curve.error = {"error of the value, root mean square", "voxels", true};
    const Timing timing{.samples = run.pick(1500, 200), .batch = 1, .warm_up = 50};
    for (const int n : kFieldPoints) {
        const FieldPointsTask task = make_field_points_task(n);
        const DistanceField field = DistanceField::build(task.mesh, task.frame).value();
        for (const FieldKernels* const kernels : all_field_kernels()) {
            if (kernels != nullptr) {
                curve.points.push_back(measure_kernels(*kernels, task, field, timing));
            }
        }
        curve.points.push_back(measure_one_by_one(
            "one by one, double", task, field.memory_bytes(), timing, [&](const Vector3& at_O) {
                const DistanceSample sample = field.sample(at_O);
                keep(sample.slope);
                return sample.value_m;
            }));
        measure_slopes(task, field, timing, slopes);
        run.progress(static_cast<double>(curve.points.size()) / 12.0,
                     std::to_string(n) + " points");
    }
    return {curve, slopes};
}

const Registration kFieldPointsBench{{"field-points",
                                      "a tool's points against a distance field: value and slope "
                                      "of all, and how their force changes",
                                      run_field_points}};

}  // namespace
}  // namespace fulcrum::bench
