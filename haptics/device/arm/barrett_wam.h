// Barrett Technology's WAM with seven joints, from what its maker published.
//
//   kinematics, masses, centres, inertias, transmission   libbarrett, config/wam7w.conf. Its wrist is the newer one: link 4 has
//       2.173 kg, where the older WAM_InertialSpecifications_AC-02 and the MuJoCo models made from it have 2.400 kg; ROS models
//       have masses changed by hand. The maker's newest is taken whole: masses of one wrist with ratios of another are no arm.
//       libbarrett turns link 7's frame by -pi/2 and its tool plate back again; here neither is turned, for the inertia given
//       is that of a disc square to the axis
//   stops                 WAM Arm User's Manual D1001 AH.00 (2008), table 6
//   rotors                WAM_InertialSpecifications_AC-02, total drive inertia at the rotor
//   torque, viscosity     Barrett's page "Specifications: motors, materials, power" (as the University of Waterloo's
//       Advanced Robotics Lab keeps it): torque that a motor can give for ever, viscous friction 7.549e-5, 8.899e-6 and
//       1.259e-6 Nm/rpm, reflected to the joints by the squares of the ratios
//   encoder               4096 counts a turn of the motor (D1001, magnetic encoders)
// No source by the maker gives dry friction: the 1 Nm of the ROS model and the 0.1 Nm of a MuJoCo model are set by hand. Two
// hundredths of the motors' torque are assumed: 1.25 Nm at the first joint, 0.03 at the last. Joints 2 and 3, and 5 and 6, are turned by two
// motors each, in a differential: each of them has the friction of both, as it has when it turns alone. Where both joints turn so that one
// motor stands still, that is up to twice the friction there is.
//
// Thread: load path. Cost: none to speak of.
#pragma once

#include "haptics/device/arm/arm_model.h"

namespace fulcrum {

/// The arm with a handle `handle_m` metres beyond its tool plate, on the last joint's axis. Base frame: +Z up, +X ahead.
[[nodiscard]] ArmModel make_barrett_wam(double handle_m = 0.08);

/// The seven joints' angles (radians) in which its handle is in the middle of where a seated pupil's hand is, half a metre
/// before the shoulder and a third above it: the elbow up and bent, the wrist bent to the side in the middle of its range,
/// for there the handle can be moved 0.12 m and turned by half a radian, any way, without a stop or a singular posture.
[[nodiscard]] JointVector make_wam_home();

}  // namespace fulcrum
