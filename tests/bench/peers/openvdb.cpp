// OpenVDB: narrow-band distance fields, read trilinearly with their gradient: where a surface is felt, and at a tool's points.
#include "tests/bench/peers/felt_ball.h"
#include "tests/bench/peers/openvdb_points.h"

#include <array>

namespace fulcrum::bench {
namespace {

// The value and its gradient a voxel at `at`, in voxels, from the cell's eight corners.
struct OpenVdbSample {
    double value;
    Vector3 slope;
};
OpenVdbSample read_openvdb(openvdb::FloatGrid::ConstAccessor& field, const Vector3& at) {
    const Vector3 low = at.cwiseFloor();
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

using Grid = openvdb::FloatGrid;

// Voxels as long as the mesh's edges.
FeltBall make(const TriangleMesh& mesh, double edge_m) {
    const Grid::Ptr field =
        make_openvdb_field(mesh, edge_m, static_cast<float>(3.0 + kDepth_m / edge_m));
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

std::vector<CostPoint> measure(Run& run) {
    return measure_points(run, "OpenVDB 10.0.1, trilinear",
                          [](const FieldPointsTask& task, const auto& measure) {
                              const openvdb::FloatGrid::Ptr grid = make_openvdb_field(task);
                              openvdb::FloatGrid::ConstAccessor accessor = grid->getConstAccessor();
                              measure(
                                  [&](const Vector3& at) {
                                      const OpenVdbSample sample = read_openvdb(accessor, at);
                                      keep(sample.slope);
                                      return sample.value;
                                  },
                                  grid->memUsage());
                          });
}

const PeerRegistration kOpenVdbPoints{
    {"OpenVDB 10.0.1", "field-points", measure, "OpenVDB reads one point after the other."}};

}  // namespace
}  // namespace fulcrum::bench
