// OpenVDB: the same points against its narrow-band distance field of the same ball and voxels, value and slope of each.
#include "tests/bench/peers/openvdb_points.h"

#include "tests/bench/peers/openvdb_sample.h"

namespace fulcrum::bench {
namespace {

std::vector<CostPoint> measure(Run& run) {
    return measure_one_by_one(
        run, "OpenVDB 10.0.1, trilinear", [](const FieldPointsTask& task, const auto& measure) {
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
