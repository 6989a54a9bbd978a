// Finds the arm that OpenHaptics knows as the default one, and what it says of itself.
//
//   most force    what it gives for a while, and where it does not say what it gives for ever, within our own limit: where that is too
//                 much for long its motors warm, and it says so (hd_warm_motors)
//   reach         of a box about zero within what it calls usable
//
// Thread: who opens the arm. Cost: the library looks for it, seconds.
// Source: OpenHaptics 3.0, API Reference Manual, hdInitDevice and appendix A; the names of the default arm: programs that others run with it;
// the encoder's step: data sheet of the Phantom Omni, the coarsest of them.
#pragma once

#include "haptics/device/device.h"
#include "runtime/arms/arm_port.h"
#include "runtime/arms/hd/hd_library.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// An arm that is open, and the current one.
struct HdFound {
    std::uint32_t handle = kHdNoArm;
    std::uint32_t calibration_style = 0;  ///< the one of its styles that asks least of people
    DeviceTraits traits;
    std::vector<ArmFact> facts;
};

/// Refuses where none answers, with the library's own words and what to look at.
[[nodiscard]] Expected<HdFound> find_hd_arm(const HdFunctions& use, double max_force_N);

/// " (its words)", or nothing where there is no error.
[[nodiscard]] std::string tell_hd_error(const HdFunctions& use, std::uint32_t code);

}  // namespace fulcrum::runtime
