// The hand's device made to stand before this learner, and the scene made to lie within what it reaches.
//
//   scale   given or kept: that; else, of an arm that tells its reach:  max_i(kUsualReach_m / reach_i), 1 to kMostFitScale
// A lesson's scale is chosen for an arm that reaches kUsualReach_m each way, so that with a smaller one every part of the scene is
// reached again; a larger one keeps the lesson's own. The scale is the workspace's: newtons stay newtons and walls, materials and tools
// are as stiff in the hand as before (scene/plan_touch.h), and fields that would be too stiff are refused.
//
// Thread: load path.
#pragma once

#include "haptics/device/device.h"
#include "runtime/app/run_request.h"
#include "runtime/lesson/hand_fit.h"
#include "runtime/progress/store.h"

#include <memory>
#include <string>

namespace fulcrum::runtime {

inline constexpr double kUsualReach_m = 0.2;

/// Which device this is, as its settings are kept: "arm MODEL SERIAL" of one at this computer, "udp:HOST:PORT NAME", "hid:VENDOR:PRODUCT SERIAL",
/// mouse, simulated hand; empty for a record. An arm that was not met yet has no name behind its address.
[[nodiscard]] std::string name_device(const RunRequest& request);

/// The clutch's button where nobody says one: of an arm the third, for lessons use two.
[[nodiscard]] int usual_clutch(HandKind kind) noexcept;

/// Of each force, of a joystick that was never tried well: no device tells its newtons. So a push of 0.8 N is none that is stronger, of one
/// whose motors have up to three times what is taken for all that they can do (device/hid/hid_hand.h).
inline constexpr double kUntriedPart = 1.0 / 3.0;

/// What is kept of a good trial: with another device of the same address or kind it is none. `asked`: somebody said what was felt.
[[nodiscard]] std::string verdict_of(bool asked, const std::string& device);
/// And of one that was not.
[[nodiscard]] std::string bad_verdict_of(const std::string& device);
/// Whether the last trial of the device of this name was not good, by who keeps the fit.
[[nodiscard]] bool is_refused(const HandFit& fit, const std::string& device);
/// Whether the device of this name was tried well, by who keeps the fit; `asked`: with what was felt.
[[nodiscard]] bool is_tried(const HandFit& fit, bool asked, const std::string& device);

/// Times the lesson's scale.
[[nodiscard]] double choose_scale(const HandFit& fit, const DeviceTraits& traits);

/// The device as it stands before the learner. Only arms and HID devices do: a pointer and a simulated hand follow the scene themselves.
[[nodiscard]] std::unique_ptr<Device> fit_device(const RunRequest& request,
                                                 std::unique_ptr<Device> device);

/// True for who has a name of their own, so that something can be kept of them: no guest, no simulated pupil, no record.
[[nodiscard]] bool is_somebody(const RunRequest& request);

/// The request with what is kept of its learner and device, also under the name that the device had before (an address or a kind alone), which
/// is kept under its own then; what cannot be used is told on the terminal.
[[nodiscard]] RunRequest with_kept_fit(const RunRequest& request, ProgressStore& store);

/// Keeps what the request itself says of its learner and device; nothing for a guest. What goes wrong is told.
void keep_fit_of(const RunRequest& request, ProgressStore& store);

}  // namespace fulcrum::runtime
