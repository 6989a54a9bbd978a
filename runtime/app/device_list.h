// What can be a hand here: the mouse, a simulated hand, and the HID devices that are plugged in; what each can do and what it lacks.
#pragma once

#include "haptics/device/hid/hid_link.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

/// One thing that can be a hand, or could be if something were mended.
struct DeviceEntry {
    std::string name;
    std::string kind;  ///< mouse, simulated hand, space mouse, joystick, unknown, arm
    std::string path;  ///< of a HID device
    std::string ids;   ///< vendor:product, likewise
    std::string hand;  ///< what --hand takes for it
    int axes = 0;
    int buttons = 0;
    int force_axes = 0;
    bool usable = false;
    std::string missing;    ///< a clause, or empty
    std::string to_do;      ///< what mends it, likewise
    std::string udev_rule;  ///< the line to add, where that mends it
};

/// Mouse and simulated hand first, then HID devices. Keyboards and what else is no hand is left out.
[[nodiscard]] std::vector<DeviceEntry> list_devices(const std::vector<hid::HidNode>& nodes,
                                                    bool has_display);

/// For people: a line for each, what is missing below it.
[[nodiscard]] std::string devices_text(const std::vector<DeviceEntry>& entries);
/// For programs: {"devices": [{"name", "kind", "path", "ids", "hand", "axes", "buttons", "force_axes", "usable", "missing", "to_do",
/// "udev_rule"}], "udev_file"}; texts are empty where there is nothing to say.
[[nodiscard]] std::string devices_json(const std::vector<DeviceEntry>& entries);

}  // namespace fulcrum::runtime
