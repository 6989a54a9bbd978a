// OpenVDB: the same points against its narrow-band distance field of the same ball and voxels, value and slope of each.
#include "tests/bench/peers/openvdb_points.h"

#include "tests/bench/curves/field_points.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"
#include "tests/bench/peers/openvdb_sample.h"

namespace fulcrum::bench {
namespace {

std::vector<CostPoint> measure(Run& run) {
    std::vector<CostPoint> points;
    const Timing timing{.samples = run.pick(300, 50), .batch = 1, .warm_up = 20};
    for (const int n : kFieldPoints) {
        const FieldPointsTask task = make_field_points_task(n);
        const openvdb::FloatGrid::Ptr grid = make_openvdb_field(task);
        openvdb::FloatGrid::ConstAccessor accessor = grid->getConstAccessor();
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
