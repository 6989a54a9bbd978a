// From the device's frame D to the world's frame W and back.
//
//   p_W = p_WD + R_WD (scale p_D)      q_W = q_WD q_D      v_W = R_WD (scale v_D)      f_D = R_WD^T
//   f_W, unscaled
// Forces are not scaled: a newton in the scene is a newton in the hand. So a stiffness of the world
// is felt times scale. Thread: any. Cost: a rotation.
#pragma once

#include "haptics/loop/haptic_plan.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

/// Where a pose of the device lies in the world.
[[nodiscard]] inline Pose compute_world_pose(const Workspace& workspace, const Pose& pose_D) {
    return workspace.pose_WD * Pose{pose_D.position * workspace.scale, pose_D.orientation};
}

/// The device's pose that lies at `pose_W` in the world; the inverse of compute_world_pose.
[[nodiscard]] inline Pose compute_device_pose(const Workspace& workspace, const Pose& pose_W) {
    const Pose unscaled = workspace.pose_WD.inverse() * pose_W;
    return {unscaled.position / workspace.scale, unscaled.orientation};
}

/// A wrench of the world as the device renders it.
[[nodiscard]] inline Wrench compute_device_wrench(const Workspace& workspace,
                                                  const Wrench& wrench_W) {
    const Quaternion turned_back = workspace.pose_WD.orientation.conjugate();
    return {turned_back * wrench_W.force, turned_back * wrench_W.torque};
}

/// A rendered wrench as the world sees it; the inverse of compute_device_wrench.
[[nodiscard]] inline Wrench compute_world_wrench(const Workspace& workspace,
                                                 const Wrench& wrench_D) {
    return {workspace.pose_WD.orientation * wrench_D.force,
            workspace.pose_WD.orientation * wrench_D.torque};
}

}  // namespace fulcrum
