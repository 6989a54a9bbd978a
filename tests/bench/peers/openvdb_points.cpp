// OpenVDB: the same points against its narrow-band distance field of the same ball and voxels, value and slope of each.
#include "tests/bench/curves/field_points.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"
#include "tests/bench/peers/openvdb_sample.h"

#include <openvdb/tools/MeshToVolume.h>

namespace fulcrum::bench {
namespace {

using Grid = openvdb::FloatGrid;

Grid::Ptr make_field(const FieldPointsTask& task) {
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
    return openvdb::tools::meshToLevelSet<Grid>(
        *openvdb::math::Transform::createLinearTransform(task.frame.voxel_m), vertices, triangles,
        3.0F);
}

std::vector<CostPoint> measure(Run& run) {
    std::vector<CostPoint> points;
    const Timing timing{.samples = run.pick(300, 50), .batch = 1, .warm_up = 20};
    for (const int n : kFieldPoints) {
        const FieldPointsTask task = make_field_points_task(n);
        const Grid::Ptr grid = make_field(task);
        Grid::ConstAccessor accessor = grid->getConstAccessor();
        std::vector<double> values_m(task.shell.size());
        const double per_metre = 1.0 / task.frame.voxel_m;
        const Cost cost = measure_cost(
            [&] {
                for (std::size_t i = 0; i < values_m.size(); ++i) {
                    const OpenVdbSample sample =
                        read_openvdb(accessor, per_metre * (task.X_OT * task.shell.position_T(i)));
                    values_m[i] = sample.value;
                    keep(sample.slope);
                }
            },
            timing, grid->memUsage());
        points.push_back({"OpenVDB 10.0.1, trilinear",
                          static_cast<double>(n),
                          find_rms_voxels(task, values_m),
                          cost,
                          {}});
    }
    return points;
}

const PeerRegistration kOpenVdbPoints{
    {"OpenVDB 10.0.1", "field-points", measure, "OpenVDB reads one point after the other."}};

}  // namespace
}  // namespace fulcrum::bench
