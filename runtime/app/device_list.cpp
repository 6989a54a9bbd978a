#include "runtime/app/device_list.h"

#include "haptics/device/hid/hid_ability.h"
#include "runtime/text/json.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

namespace fulcrum::runtime {
namespace {

std::string ids_of(const hid::HidNode& node) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%04x:%04x", node.vendor, node.product);
    return text.data();
}

std::string kind_of(hid::HandForm form) {
    return form == hid::HandForm::space_mouse ? "space mouse"
           : form == hid::HandForm::stick     ? "joystick"
                                              : "unknown";
}

// Nothing of what is no hand and has nothing to be mended.
std::optional<DeviceEntry> entry_of(const hid::HidNode& node) {
    const hid::HidAbility ability = hid::find_ability(node);
    if (ability.form == hid::HandForm::none && ability.missing.empty()) {
        return std::nullopt;
    }
    DeviceEntry entry;
    entry.name = hid::call(node);
    entry.kind = kind_of(ability.form);
    entry.path = node.path;
    entry.ids = ids_of(node);
    entry.hand = "hid:" + node.path;
    entry.axes = ability.n_axes;
    entry.buttons = ability.n_buttons;
    entry.force_axes = ability.n_force_axes;
    entry.missing = ability.missing;
    entry.usable = ability.form != hid::HandForm::none && node.may_open;
    if (ability.form != hid::HandForm::none && !node.may_open) {
        entry.missing = "this user may not open it";
        entry.to_do = "add the line below to " + std::string(hid::kUdevRules) +
                      ", then unplug it and plug it in again";
        entry.udev_rule = hid::udev_rule(node);
    }
    return entry;
}

std::string count_of(int n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string abilities_of(const DeviceEntry& entry) {
    std::string text = count_of(entry.axes, "axis", "axes");
    if (entry.buttons > 0) {
        text += ", " + count_of(entry.buttons, "button", "buttons");
    }
    return text + (entry.force_axes > 0
                       ? ", force along " + count_of(entry.force_axes, "axis", "axes")
                       : ", no force: it is shown and heard");
}

}  // namespace

std::vector<DeviceEntry> list_devices(const std::vector<hid::HidNode>& nodes, bool has_display) {
    std::vector<DeviceEntry> entries;
    DeviceEntry mouse;
    mouse.name = mouse.kind = mouse.hand = "mouse";
    mouse.axes = 3;
    mouse.buttons = 3;
    mouse.usable = has_display;
    if (!has_display) {
        mouse.missing = "there is no display";
        mouse.to_do = "start the program where there is a screen";
    }
    entries.push_back(mouse);
    DeviceEntry simulated;
    simulated.name = simulated.kind = "simulated hand";
    simulated.hand = "FILE.lua";
    simulated.axes = 6;
    simulated.force_axes = 6;
    simulated.usable = true;
    entries.push_back(simulated);
    for (const hid::HidNode& node : nodes) {
        if (auto entry = entry_of(node)) {
            entries.push_back(std::move(*entry));
        }
    }
    return entries;
}

std::string devices_text(const std::vector<DeviceEntry>& entries) {
    std::string text;
    for (const DeviceEntry& entry : entries) {
        text += entry.name + (entry.ids.empty() ? "" : " (" + entry.ids + ")") +
                (entry.axes > 0 ? ": " + abilities_of(entry) : "") + ".";
        text += entry.usable ? "  --hand " + entry.hand + "\n" : "\n";
        if (!entry.missing.empty()) {
            text += "    " + (entry.path.empty() ? "" : entry.path + ": ") + entry.missing +
                    (entry.to_do.empty() ? "" : "; " + entry.to_do) + ".\n";
        }
        if (!entry.udev_rule.empty()) {
            text += "    " + entry.udev_rule + "\n";
        }
    }
    const bool has_hid = std::any_of(entries.begin(), entries.end(),
                                     [](const DeviceEntry& entry) { return !entry.path.empty(); });
    return has_hid ? text : text + "No SpaceMouse and no joystick is plugged in.\n";
}

std::string devices_json(const std::vector<DeviceEntry>& entries) {
    Json devices = Json::array();
    for (const DeviceEntry& entry : entries) {
        devices.push_back(Json::object({{"name", entry.name},
                                        {"kind", entry.kind},
                                        {"path", entry.path},
                                        {"ids", entry.ids},
                                        {"hand", entry.hand},
                                        {"axes", entry.axes},
                                        {"buttons", entry.buttons},
                                        {"force_axes", entry.force_axes},
                                        {"usable", entry.usable},
                                        {"missing", entry.missing},
                                        {"to_do", entry.to_do},
                                        {"udev_rule", entry.udev_rule}}));
    }
    return Json::object({{"devices", std::move(devices)}, {"udev_file", hid::kUdevRules}})
        .to_text();
}

}  // namespace fulcrum::runtime
