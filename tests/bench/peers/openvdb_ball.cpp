// OpenVDB: a narrow-band distance field of the same mesh, voxels as long as its edges, read trilinearly with its gradient.
#include "tests/bench/peers/felt_ball.h"

#include <array>
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

// The value and its gradient a voxel at `at`, in voxels, from the cell's eight corners.
struct Sample {
    double value;
    Vector3 slope;
};
Sample read(Grid::ConstAccessor& field, const Vector3& at) {
    const Vector3 low = at.array().floor();
    const Vector3 u = at - low;
    const openvdb::Coord corner(static_cast<int>(low.x()), static_cast<int>(low.y()),
                                static_cast<int>(low.z()));
    std::array<double, 8> v{};
    for (int i = 0; i < 8; ++i) {
        v[static_cast<std::size_t>(i)] =
            field.getValue(corner.offsetBy(i & 1, (i >> 1) & 1, i >> 2));
    }
    const auto mix = [](double a, double b, double t) { return a + t * (b - a); };
    const std::array<double, 4> x{mix(v[0], v[1], u.x()), mix(v[2], v[3], u.x()),
                                  mix(v[4], v[5], u.x()), mix(v[6], v[7], u.x())};
    const std::array<double, 4> dx{v[1] - v[0], v[3] - v[2], v[5] - v[4], v[7] - v[6]};
    const double y0 = mix(x[0], x[1], u.y());
    const double y1 = mix(x[2], x[3], u.y());
    return {mix(y0, y1, u.z()),
            {mix(mix(dx[0], dx[1], u.y()), mix(dx[2], dx[3], u.y()), u.z()),
             mix(x[1] - x[0], x[3] - x[2], u.z()), y1 - y0}};
}

FeltBall make(const TriangleMesh& mesh, double edge_m) {
    const Grid::Ptr field = make_field(mesh, edge_m);
    auto accessor = std::make_shared<Grid::ConstAccessor>(field->getConstAccessor());
    return {[field, accessor, edge_m](const Vector3& hand_W) {
                const Sample sample = read(*accessor, hand_W / edge_m);
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
