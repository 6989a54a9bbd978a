// What a HID device can do as a hand, from its numbers and its report descriptor alone: nothing is opened.
//
// Thread: load path. Cost: parsing its descriptor.
#pragma once

#include "haptics/device/hid/force_layout.h"
#include "haptics/device/hid/hid_link.h"
#include "haptics/device/hid/report_descriptor.h"
#include "haptics/device/hid/space_mouse.h"
#include "haptics/device/hid/stick.h"

#include <optional>
#include <string>
#include <vector>

namespace fulcrum::hid {

enum class HandForm : std::uint8_t { none, space_mouse, stick };

struct HidAbility {
    HandForm form = HandForm::none;
    int n_axes = 0;
    int n_buttons = 0;
    int n_force_axes = 0;  ///< 0: renders none
    std::string
        missing;  ///< why it cannot be used, or has no force though it speaks of it; a clause, or empty
    ReportDescriptor descriptor;       ///< empty where it could not be parsed
    std::optional<Cap> cap;            ///< of a SpaceMouse
    std::optional<Stick> stick;        ///< of a stick
    std::optional<ForceLayout> force;  ///< where it renders one
};

[[nodiscard]] HidAbility find_ability(const HidNode& node);

/// What people call it: its name, or its numbers where it has none.
[[nodiscard]] std::string call(const HidNode& node);

/// The device to play with: at `path`, or, where that is empty, the best that is there: one with force, then a SpaceMouse, then any
/// stick. Says what is missing where there is none that can be opened.
[[nodiscard]] Expected<HidNode> choose_hand(HidBus& bus, const std::string& path);

/// The line for udev that lets everybody at the screen use this device, plugged in or by Bluetooth.
[[nodiscard]] std::string udev_rule(const HidNode& node);
/// Where that line goes.
inline constexpr const char* kUdevRules = "/etc/udev/rules.d/70-fulcrum.rules";

}  // namespace fulcrum::hid
