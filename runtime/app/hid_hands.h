// HID devices as a run knows them: which one was asked for, and how it is set for a scene.
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/hid/hid_hand.h"
#include "haptics/device/watched/watched_device.h"
#include "haptics/loop/haptic_plan.h"

#include <memory>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// A HID device that is to be the hand.
struct HidChoice {
    hid::HidNode node{};
    hid::HandForm form = hid::HandForm::none;
    bool has_force = false;
};

/// True for the words of --hand that ask for one: hid, or hid:PATH.
[[nodiscard]] bool asks_for_hid(std::string_view word) noexcept;

/// The device that the word asks for; says what is missing where there is none.
[[nodiscard]] Expected<HidChoice> choose_hid_hand(std::string_view word);

/// The most that it can give, in newtons; infinite where it renders none, so that what is shown is not lessened by it.
[[nodiscard]] double force_limit_N(const HidChoice& choice) noexcept;

/// How it is set in this workspace: what the mouse reaches, a SpaceMouse reaches; a stick, whose way is short, a part of it.
[[nodiscard]] hid::HidHandSettings hid_settings(const Workspace& workspace);

/// What is known of its sensor. A SpaceMouse, and a stick without motors, may stand still for ever: nothing is watched.
[[nodiscard]] SensorWatch sensor_watch(const DeviceTraits& traits, const Vector3& stick_reach_D);

/// Opens it.
[[nodiscard]] Expected<std::unique_ptr<hid::HidHand>> open_hid_hand(const HidChoice& choice,
                                                                    const Workspace& workspace);

}  // namespace fulcrum::runtime
