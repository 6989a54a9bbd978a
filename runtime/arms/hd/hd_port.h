// 3D Systems' Touch and Touch X, and SensAble's Omni, Desktop and Premium, by OpenHaptics' HDAPI, which the user installs: libHD is opened
// while the program runs.
//
//   library's thread   HdServo: pose -> `sample`;  `order` -> force, once a millisecond
//   port's thread      every kHdLook_s: whether that thread runs, and what is amiss: told in words;  at the end it puts the arm away
// Where the library's thread stops the sample grows old and the loop's gate fades; where the loop stops the order grows old and the
// library's thread gives no force. The library has one state for the whole program, and several arms at once are not reliable on Linux:
// exactly one a program, and one that could not be put away stays so.
// A program that is killed leaves the arm in disorder until it is plugged in again: whoever serves it must stop it on SIGTERM and SIGINT.
//
// Thread: made and stopped by who serves the arm. Cost: two threads that sleep.
// Source: hd_library.h; that killed programs leave an error behind, and the names of the default arm: programs that others run with it.
#pragma once

#include "runtime/arms/arm_port.h"

#include <memory>
#include <string>

namespace fulcrum::runtime {

inline constexpr double kHdLook_s = 0.02;
inline constexpr double kHdStill_s = 0.1;  ///< without a tick, until it is told
inline constexpr double kHdFarewell_s = 0.8;

/// Fixed when it is opened.
struct HdSettings {
    std::string library;  ///< path of libHD; empty: by its usual names
    double max_force_N =
        10.0;  ///< the arm gives no more, whatever it says of itself; 0 to kHardForceCap_N
};

/// The default arm, with its loop running. One that does not know its zero yet is opened too: its notice says what to do with the pen, and
/// it is there once that is done. Refuses settings outside their range, a library that is missing or of no use, no arm, one whose loop
/// does not run, and a second one.
[[nodiscard]] Expected<std::unique_ptr<ArmPort>> open_hd(const HdSettings& settings);

}  // namespace fulcrum::runtime
