#include "haptics/tool/field_load.h"

namespace fulcrum {

VoxelContact FieldSampling::to_contact(const FieldTouch& touch) const noexcept {
    constexpr double kAsDeep = 1.0 - 1.0e-3;  // values are kept in steps
    const bool through = touch.deepest_m >= kAsDeep * sampler_.field().band_m();
    return {touch.wrench_W, touch.n_touching, through ? 1 : 0, 0, touch.error_N, touch.error_Nm};
}

VoxelContact FieldSampling::sample(const RigidState& state,
                                   const MovingFrame& object) const noexcept {
    return to_contact(sampler_.step(object.pose_W, state.pose_W));
}

VoxelContact FieldSampling::sample_linearised(const RigidState& state, const MovingFrame& object,
                                              WrenchJacobian& jacobian) const noexcept {
    return to_contact(sampler_.step_linearised(object.pose_W, state.pose_W, jacobian.pose));
}

}  // namespace fulcrum
