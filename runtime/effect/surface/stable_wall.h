// How stiff and damped a wall may be for the device that renders it: what a lesson wants, lowered to what settles in hands as they were measured.
//
// The wall as the loop renders it, held by a hand, is a plant with a delayed spring and damper:
//   L(jw) = (K + jw B e^(-jw t_v)) e^(-jw D) / (k_h - m w^2 + jw b)        m, b: hand and device together; k_h: the hand's spring
//   D = T/2 + link      half a period of the hold, and the way to the arm and back
//   t_v                 half the longest window of the velocity estimator
// The hand alone comes to rest, so by Nyquist the loop does where L meets the negative real axis nowhere beyond -1. A wall is stable where it meets it
// nowhere beyond -1 / kGainMargin, for each of kHoldingHands of device/simulated/human_impedance.h: theirs are spring, damper and mass of hands as they were
// measured, of a fingertip that presses with 2 N and more. Without B and with D alone that is what K (T/2 + link) < b asks for (Colgate and Brown), where the hand has no spring.
// The gate's slew S and force limit F add a bound. A vibration of a wall has a force between 0 and F at most, so that F/2 w is the most that it asks of
// the slew: where that is within S the gate adds no lag to it. The fastest is the bare handle's, w^2 = K/m, hence
//   K <= m (2 S / F)^2
// Lowered is as little as can be: damping first, at the wall's own stiffness, and stiffness where no damping helps. Not in it: a device's dry friction, which
// stills more than this, steps of its encoder, and the way from air to contact; tests/support/declared_wall.h tries all of it in time.
//
// Thread: load path. Cost: 0.1 ms for a wall that is stable, 30 ms for one that is not.
// Source: J. E. Colgate, J. M. Brown 1994, Factors affecting the Z-width of a haptic display, Proc. IEEE Int. Conf. Robotics and Automation; T. Hulin,
// A. Albu-Schaeffer, G. Hirzinger 2014, Passivity and stability boundaries for haptic systems with time delay, IEEE Trans. Control Systems Technology 22(4)
// (delay with the hand's own spring and damper); the bound by the slew is ours.
#pragma once

#include "haptics/coupling/coupling_settings.h"
#include "haptics/device/device.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Times the wall could be stiffer and more damped before a hand shakes: what the line above leaves out. At 1, of all walls that a lesson may declare,
/// the trial finds none that shakes on an arm at hand and few over a link; with this none.
inline constexpr double kGainMargin = 1.1;

/// Less of its stiffness or damping than this makes another material of it.
inline constexpr double kLeastKept = 0.5;

/// The device as a wall knows it; SI. The defaults are an arm like those on a classroom's desk (simulated_arm.h).
struct WallHolder {
    std::string name = "a desktop arm";  ///< for people
    double mass_kg = kHandleMass_kg;     ///< of the handle, above 0
    double damping_Ns_per_m = 0.5;       ///< its own, 0 or more
    double max_force_N = 3.3;            ///< the most it gives
    double link_s = 0.0;                 ///< to it and back; 0 where it is at hand
};

/// The loop and its last gate, as the plan makes them.
struct WallLoop {
    double rate_hz = 1000.0;
    double max_slew_N_per_s = 500.0;
    double max_force_N = 5.0;
};

/// What is known of an open device; where it tells no mass or damping, those of the lightest handle and none.
[[nodiscard]] WallHolder make_wall_holder(const DeviceTraits& traits, double link_s);

/// How far inside all bounds above it lies: stable from 1 on.
[[nodiscard]] double compute_wall_margin(const CouplingSettings& wall, const WallHolder& holder,
                                         const WallLoop& loop);

/// Those that render one lesson, a hand each; what is touched is as stiff in all of them.
using WallHolders = std::vector<WallHolder>;

/// The wall itself where that is stable; else the nearest that is, in whole tens of N/m and tenths of Ns/m.
[[nodiscard]] CouplingSettings fit_wall(const CouplingSettings& wanted, const WallHolder& holder,
                                        const WallLoop& loop);

}  // namespace fulcrum::runtime
