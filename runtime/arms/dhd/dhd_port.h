// Force Dimension's omega, sigma, delta and lambda, and Novint's Falcon, by the maker's library, which the user installs: libdrd is opened
// while the program runs.
//
//   thread   pose from the arm -> `sample`;  `order` -> force to the arm;  once a millisecond, whether anything changed or not
// A call that hangs holds up this thread alone: the sample grows old, the loop's gate fades, and the arm's own watchdog takes the force away
// 20 ms after the last order. Whoever stops it then waits kDhdFarewell_s at most; the thread ends, and closes the arm, when the call does.
//
// An arm that does not know its zero finds it by moving by itself. Nothing here does that but `open_dhd`, before anybody holds it, and
// only where a person has said that it may.
//
// Thread: made and stopped by who serves the arm. Cost: a thread that sleeps between rounds.
// Source: dhd_library.h.
#pragma once

#include "runtime/arms/arm_port.h"

#include <memory>
#include <string>

namespace fulcrum::runtime {

inline constexpr double kDhdRound_s = 0.001;
inline constexpr double kDhdFarewell_s = 0.8;
/// What a person types to allow that the arm moves by itself once, before it is held.
inline constexpr const char* kInitialiseOption = "--initialise";

/// Fixed when it is opened.
struct DhdSettings {
    std::string library;        ///< path of libdrd; empty: by its usual names
    double max_force_N = 10.0;  ///< the arm is told to give no more; 0 to kHardForceCap_N
    double max_torque_Nm =
        1.0;  ///< likewise, 0 to kHardTorqueCap_Nm; an arm without motors in its wrist gives none
    bool may_initialise =
        false;  ///< a person has said: nobody holds it, nothing is near, it may move
};

/// The first arm that is there, with its force on and its weight carried. Refuses settings outside their range, a library that is
/// missing or of no use, no arm, and one that does not know its zero where it may not move.
[[nodiscard]] Expected<std::unique_ptr<ArmPort>> open_dhd(const DhdSettings& settings);

}  // namespace fulcrum::runtime
