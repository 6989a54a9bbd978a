// OpenVDB's narrow-band distance field of the ball that tools' points are measured against, and those points read from it one by one.
#pragma once

#include "tests/bench/curves/field_points.h"
#include "tests/bench/harness/registry.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#include <string>
#include <vector>

namespace fulcrum::bench {

/// So many voxels to either side of the surface.
[[nodiscard]] inline openvdb::FloatGrid::Ptr make_openvdb_field(const TriangleMesh& mesh,
                                                                double voxel_m, float band) {
    openvdb::initialize();
    std::vector<openvdb::Vec3s> vertices;
    std::vector<openvdb::Vec3I> triangles;
    for (const Vector3& v : mesh.vertices_B()) {
        const Vector3f at = v.cast<float>();
        vertices.emplace_back(at.x(), at.y(), at.z());
    }
    for (const TriangleCorners& t : mesh.triangles()) {
        triangles.emplace_back(t[0], t[1], t[2]);
    }
    return openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(
        *openvdb::math::Transform::createLinearTransform(voxel_m), vertices, triangles, band);
}
[[nodiscard]] inline openvdb::FloatGrid::Ptr make_openvdb_field(const FieldPointsTask& task) {
    return make_openvdb_field(task.mesh, task.frame.voxel_m, 3.0F);
}

/// What values and slopes of all points cost, and how exact the values are: `prepare(task, measure)` makes the field of a task and calls
/// measure(read, bytes), with the value of read(place in voxels) in metres.
template <class Prepare>
[[nodiscard]] std::vector<CostPoint> measure_points(Run& run, const std::string& series,
                                                    const Prepare& prepare) {
    std::vector<CostPoint> points;
    const Timing timing{.samples = run.pick(300, 50), .batch = 1, .warm_up = 20};
    for (const int n : kFieldPoints) {
        const FieldPointsTask task = make_field_points_task(n);
        prepare(task, [&](auto&& read, std::size_t bytes) {
            points.push_back(measure_one_by_one(
                series, task, bytes, timing,
                [&](const Vector3& at_O) { return read(1.0 / task.frame.voxel_m * at_O); }));
        });
    }
    return points;
}

}  // namespace fulcrum::bench
