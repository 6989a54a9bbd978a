#include "haptics/tool/field_sampling/field_load.h"

#include "haptics/math/length.h"

#include <cmath>

namespace fulcrum {

VoxelContact FieldSampling::to_contact(const FieldTouch& touch) const noexcept {
    constexpr double kAsDeep = 1.0 - 1.0e-3;  // values are kept in steps
    const bool through = touch.deepest_m >= kAsDeep * sampler_.field().band_m();
    return {touch.wrench_W, touch.n_touching, through ? 1 : 0, 0,
            touch.error_N,  touch.error_Nm,   touch.deepest_m};
}

VoxelContact FieldSampling::sample(const RigidState& state,
                                   const MovingFrame& object) const noexcept {
    return to_contact(sampler_.step(object.pose_W, state.pose_W));
}

VoxelContact FieldSampling::sample_linearised(const RigidState& state, const MovingFrame& object,
                                              WrenchJacobian& jacobian) const noexcept {
    return to_contact(sampler_.step_linearised(object.pose_W, state.pose_W, jacobian.pose));
}

bool FieldSampling::stop_at_touch(const ToolMotion& motion, double depth_m,
                                  RigidState& end) const noexcept {
    const ToolWay way = find_way(motion, end.pose_W, reach_m());
    const Vector3 half = 0.5 * (frame().upper_O() - frame().lower_O);
    const double away_m = compute_length(Vector3(way.to_OT.position - frame().lower_O - half)) -
                          compute_length(half) - reach_m();
    const double deepest_m = kSweptDepth_voxels * frame().voxel_m;
    // No point can be that deep by then, or none can reach the field; not so where something is no number.
    if (way.longest_m <= deepest_m - depth_m || away_m > way.longest_m ||
        !std::isfinite(way.longest_m)) {
        return false;
    }
    const double share = sampler_.find_first_touch(way.from_OT, way.to_OT, deepest_m);
    if (share >= 1.0) {
        return false;
    }
    put_back(motion, way, share, share, end);
    return true;
}

}  // namespace fulcrum
