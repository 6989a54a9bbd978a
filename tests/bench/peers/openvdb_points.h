// OpenVDB's narrow-band distance field of the ball that tools' points are measured against.
#pragma once

#include "tests/bench/curves/field_points.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#include <vector>

namespace fulcrum::bench {

[[nodiscard]] inline openvdb::FloatGrid::Ptr make_openvdb_field(const FieldPointsTask& task) {
    openvdb::initialize();
    std::vector<openvdb::Vec3s> vertices;
    std::vector<openvdb::Vec3I> triangles;
    for (const Vector3& v : task.mesh.vertices_B()) {
        const Eigen::Vector3f at = v.cast<float>();
        vertices.emplace_back(at.x(), at.y(), at.z());
    }
    for (const TriangleCorners& t : task.mesh.triangles()) {
        triangles.emplace_back(t[0], t[1], t[2]);
    }
    return openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(
        *openvdb::math::Transform::createLinearTransform(task.frame.voxel_m), vertices, triangles,
        3.0F);
}

}  // namespace fulcrum::bench
