// What a hand that holds a device adds to it: mass, damping, and a spring about where the person wants it.
//
// The presets lie inside what was measured. Where a source gives a formula or one fit, that is named; the others are
// orders of magnitude. A mass, spring and damper is the usual, and coarse, model: Speich et al. add a second spring and
// damper to fit one hand up to some 30 Hz, and all find stiffness and damping rising with the grip, so a claim about
// stability should hold for a range of hands, not for one.
// Source: A. Hajian, R. Howe 1997, Identification of the mechanical impedance at the human finger tip, J. Biomechanical
// Engineering 119(1): stiffness 93 + 41 F N/m at a pressing force F of 2 to 20 newtons (as quoted by J. Friedman and
// T. Flash 2007), near critical damping, grams of mass. F. van Beek, W. Bergmann Tiest, W. Mugge, A. Kappers 2015, Haptic
// perception of force magnitude and its relation to postural arm dynamics in 3D, Scientific Reports 5, 18004, Fig. 3: the
// fit of one trial. T. Tsuji, P. Morasso, K. Goto, K. Ito 1995, Human hand impedance characteristics during maintained
// posture, Biological Cybernetics 72: of the order of 1 kg, 10 Ns/m and some 100 N/m. J. Speich, L. Shao, M. Goldfarb
// 2005, Modeling the human hand as it interacts with a telemanipulation system, Mechatronics 15.
#pragma once

#include <array>

namespace fulcrum {

/// Added to the device's own; SI.
struct HumanImpedance {
    double mass_kg = 0.0;
    double damping_Ns_per_m = 0.0;
    double stiffness_N_per_m = 0.0;
};

/// The device is let go.
inline constexpr HumanImpedance kNobody{};
/// A fingertip that presses with 5 N: 93 + 41 * 5 N/m, 6 g, damped at a ratio of 1 (Hajian and Howe).
inline constexpr HumanImpedance kFingertip{0.006, 2.6, 300.0};
/// The same that presses with 2 N, the least that was measured.
inline constexpr HumanImpedance kLightFingertip{0.006, 2.05, 175.0};
/// One arm in one posture, as fitted (van Beek et al., Fig. 3).
inline constexpr HumanImpedance kArm{0.554, 6.45, 135.0};
/// A hand that keeps its posture, in the order of Tsuji et al.; what `SimulatedHand` has.
inline constexpr HumanImpedance kPosture{1.0, 20.0, 300.0};
/// Those that hold a device.
inline constexpr std::array kHoldingHands{kFingertip, kLightFingertip, kArm, kPosture};

}  // namespace fulcrum
