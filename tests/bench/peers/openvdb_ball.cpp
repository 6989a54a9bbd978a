// OpenVDB: a narrow-band distance field of the same mesh, voxels as long as its edges, read trilinearly with its gradient.
#include "tests/bench/peers/felt_ball.h"
#include "tests/bench/peers/openvdb_sample.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

namespace fulcrum::bench {
namespace {

using Grid = openvdb::FloatGrid;

Grid::Ptr make_field(const TriangleMesh& mesh, double voxel_m) {
    openvdb::initialize();
    std::vector<openvdb::Vec3s> vertices;
    std::vector<openvdb::Vec3I> triangles;
    for (const Vector3& v : mesh.vertices_B()) {
        vertices.emplace_back(static_cast<float>(v.x()), static_cast<float>(v.y()),
                              static_cast<float>(v.z()));
    }
    for (const TriangleCorners& t : mesh.triangles()) {
        triangles.emplace_back(t[0], t[1], t[2]);
    }
    const auto band = static_cast<float>(3.0 + kDepth_m / voxel_m);
    return openvdb::tools::meshToLevelSet<Grid>(
        *openvdb::math::Transform::createLinearTransform(voxel_m), vertices, triangles, band);
}

FeltBall make(const TriangleMesh& mesh, double edge_m) {
    const Grid::Ptr field = make_field(mesh, edge_m);
    auto accessor = std::make_shared<Grid::ConstAccessor>(field->getConstAccessor());
    return {[field, accessor, edge_m](const Vector3& hand_W) {
                const OpenVdbSample sample = read_openvdb(*accessor, hand_W / edge_m);
                const Vector3 normal = sample.slope.normalized();
                const bool touches = sample.value < 0.0;
                const double push_N = touches ? -kStiffness_N_per_m * sample.value : 0.0;
                return Felt{push_N * normal, normal, touches};
            },
            field->memUsage()};
}

const FeltBallRegistration kOpenVdb{"OpenVDB 10.0.1, trilinear", make};

}  // namespace
}  // namespace fulcrum::bench
