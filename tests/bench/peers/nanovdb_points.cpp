// NanoVDB: the same points against OpenVDB's field in NanoVDB's flat form, by its own trilinear sampler: value and slope of each.
#include "tests/bench/curves/field_points.h"
#include "tests/bench/harness/measure.h"
#include "tests/bench/harness/registry.h"
#include "tests/bench/peers/openvdb_points.h"

#include <nanovdb/util/OpenToNanoVDB.h>
#include <nanovdb/util/SampleFromVoxels.h>

namespace fulcrum::bench {
namespace {

std::vector<CostPoint> measure(Run& run) {
    std::vector<CostPoint> points;
    const Timing timing{.samples = run.pick(300, 50), .batch = 1, .warm_up = 20};
    for (const int n : kFieldPoints) {
        const FieldPointsTask task = make_field_points_task(n);
        const auto handle = nanovdb::openToNanoVDB(*make_openvdb_field(task));
        const nanovdb::FloatGrid* const grid = handle.grid<float>();
        const auto accessor = grid->getAccessor();
        const nanovdb::SampleFromVoxels<nanovdb::DefaultReadAccessor<float>, 1, true> sampler(
            accessor);
        std::vector<double> values_m(task.shell.size());
        const double per_metre = 1.0 / task.frame.voxel_m;
        const Cost cost = measure_cost(
            [&] {
                for (std::size_t i = 0; i < values_m.size(); ++i) {
                    const Vector3 at = per_metre * (task.X_OT * task.shell.position_T(i));
                    const nanovdb::Vec3d place(at.x(), at.y(), at.z());
                    values_m[i] = static_cast<double>(sampler(place));
                    keep(sampler.gradient(place));
                }
            },
            timing, handle.size());
        points.push_back({"NanoVDB 10.0.1, trilinear",
                          static_cast<double>(n),
                          find_rms_voxels(task, values_m),
                          cost,
                          {}});
    }
    return points;
}

const PeerRegistration kNanoVdbPoints{{"NanoVDB 10.0.1", "field-points", measure,
                                       "NanoVDB's sampler reads one point after the other."}};

}  // namespace
}  // namespace fulcrum::bench
