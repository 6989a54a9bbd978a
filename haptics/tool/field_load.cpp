#include "haptics/tool/field_load.h"

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
    const Pose from_OT = motion.object_before_W.inverse() * motion.before_W;
    const Pose to_OT = motion.object.pose_W.inverse() * end.pose_W;
    const double way_m = compute_length(Vector3(to_OT.position - from_OT.position)) +
                         reach_m() * from_OT.orientation.angularDistance(to_OT.orientation);
    const Vector3 half = 0.5 * (frame().upper_O() - frame().lower_O);
    const double away_m = compute_length(Vector3(to_OT.position - frame().lower_O - half)) -
                          compute_length(half) - reach_m();
    const double deepest_m = kSweptDepth_voxels * frame().voxel_m;
    // No point can be that deep by then, or none can reach the field; not so where something is no number.
    if (way_m <= deepest_m - depth_m || away_m > way_m || !std::isfinite(way_m)) {
        return false;
    }
    const double share = sampler_.find_first_touch(from_OT, to_OT, deepest_m);
    if (share >= 1.0) {
        return false;
    }
    const MovingFrame& object = motion.object;
    end.pose_W = object.pose_W * compute_between(from_OT, to_OT, share);
    const Vector3 carried =
        object.velocity_W.linear +
        object.velocity_W.angular.cross(end.pose_W.position - object.pose_W.position);
    end.velocity_W.linear = carried + share * (end.velocity_W.linear - carried);
    end.velocity_W.angular =
        object.velocity_W.angular + share * (end.velocity_W.angular - object.velocity_W.angular);
    return true;
}

}  // namespace fulcrum
