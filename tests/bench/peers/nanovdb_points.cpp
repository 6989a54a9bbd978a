// NanoVDB: the same points against OpenVDB's field in NanoVDB's flat form, by its own trilinear sampler: value and slope of each.
#include "tests/bench/peers/openvdb_points.h"

#include <nanovdb/util/OpenToNanoVDB.h>
#include <nanovdb/util/SampleFromVoxels.h>

namespace fulcrum::bench {
namespace {

std::vector<CostPoint> measure(Run& run) {
    return measure_points(
        run, "NanoVDB 10.0.1, trilinear", [](const FieldPointsTask& task, const auto& measure) {
            const auto handle = nanovdb::openToNanoVDB(*make_openvdb_field(task));
            const auto accessor = handle.grid<float>()->getAccessor();
            const nanovdb::SampleFromVoxels<nanovdb::DefaultReadAccessor<float>, 1, true> sampler(
                accessor);
            measure(
                [&](const Vector3& at) {
                    const nanovdb::Vec3d place(at.x(), at.y(), at.z());
                    keep(sampler.gradient(place));
                    return static_cast<double>(sampler(place));
                },
                handle.size());
        });
}

const PeerRegistration kNanoVdbPoints{{"NanoVDB 10.0.1", "field-points", measure,
                                       "NanoVDB's sampler reads one point after the other."}};

}  // namespace
}  // namespace fulcrum::bench
