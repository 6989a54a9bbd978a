// OpenVDB's narrow-band distance field of the ball that tools' points are measured against, and those points read from it one by one.
#pragma once

#include "tests/bench/curves/field_points.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#include <string>
#include <vector>

namespace fulcrum::bench {

[[nodiscard]] inline openvdb::FloatGrid::Ptr make_openvdb_field(const FieldPointsTask& task) {
    openvdb::initialize();
    std::vector<openvdb::Vec3s> vertices;
    std::vector<openvdb::Vec3I> triangles;
    for (const Vector3& v : task.mesh.vertices_B()) {
        const Vector3f at = v.cast<float>();
        vertices.emplace_back(at.x(), at.y(), at.z());
    }
    for (const TriangleCorners& t : task.mesh.triangles()) {
        triangles.emplace_back(t[0], t[1], t[2]);
    }
    return openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(
        *openvdb::math::Transform::createLinearTransform(task.frame.voxel_m), vertices, triangles,
        3.0F);
}

/// What values and slopes of all points cost, and how exact the values are: `prepare(task, measure)` makes the field of a task and calls
/// measure(read, bytes), with the value of read(place in voxels) in metres.
template <class Prepare>
[[nodiscard]] std::vector<CostPoint> measure_one_by_one(Run& run, const std::string& series,
                                                        const Prepare& prepare) {
    std::vector<CostPoint> points;
    const Timing timing{.samples = run.pick(300, 50), .batch = 1, .warm_up = 20};
    for (const int n : kFieldPoints) {
        const FieldPointsTask task = make_field_points_task(n);
        prepare(task, [&](auto&& read, std::size_t bytes) {
            std::vector<double> values_m(task.shell.size());
            const double per_metre = 1.0 / task.frame.voxel_m;
            const Cost cost = measure_cost(
                [&] {
                    for (std::size_t i = 0; i < values_m.size(); ++i) {
                        values_m[i] = read(per_metre * (task.X_OT * task.shell.position_T(i)));
                    }
                },
                timing, bytes);
            points.push_back(
                {series, static_cast<double>(n), find_rms_voxels(task, values_m), cost, {}});
        });
    }
    return points;
}

}  // namespace fulcrum::bench
