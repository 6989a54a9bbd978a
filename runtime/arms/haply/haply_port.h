// A Haply Inverse3, Inverse3x or MinVerse, through the service that its owner has installed.
//
//   the port's thread   every round: the newest order -> one command · its state, kAnswer_s at most -> the newest sample
//                       no state for kArmSilence_s: not there · for kLost_s: the line is closed and tried anew every kLost_s
//                       once a second: the configuration and the scale of forces; what somebody changed ends the force until a restart
// The service gives one state for each message and none by itself, so who stops sending renders nothing more and hears nothing more. How
// long it and the arm go on with the last force where a client hangs is not documented: a loop that is silent for kArmSilence_s gets
// zero sent in its place. The grip's turn and buttons are 50 to 60 a second, older than the place; no torque goes to it.
//
// Thread: made and stopped by who serves the arm; the rest as in arm_port.h. Cost: a thread that sleeps, some 0.1 ms a round.
// Source: docs.haply.co/inverseSDK/service, 3.5; what is taken from where stands in the headers beside this one.
#pragma once

#include "haptics/base/error.h"
#include "runtime/arms/arm_port.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace fulcrum::runtime {

struct HaplySettings {
    std::uint16_t port = 10001;  ///< of the service, at this computer; not 0
    std::string
        device_id;  ///< the arm's; empty: the only one. Letters, digits, - and _, 64 at most
    double rate_Hz = 1000.0;  ///< rounds, where answers come in time, 100 to 2000
    std::string log_file;     ///< where messages are kept as they came; empty: nowhere
    /// The middle of the arm's space in its own base, m, each from -1 to 1; without it the handle must rest there while it is opened.
    std::optional<Vector3> centre_A;
    double rest_wait_s = 10.0;  ///< how long that is waited for, 0.5 to 60
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const HaplySettings& settings);

/// The arm, streaming. Refuses with a sentence where there is no service, one of an unknown version, no arm or several, one that may not
/// be held (haply_judge.h), and a handle that is never still.
[[nodiscard]] Expected<std::unique_ptr<ArmPort>> open_haply(const HaplySettings& settings);

}  // namespace fulcrum::runtime
