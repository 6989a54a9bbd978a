// Where a force-feedback joystick wants its orders: report numbers, fields and their ranges differ from device to device and are
// found in its report descriptor.
//
// Thread: load path. Cost: a walk over the descriptor's fields for each of some twenty that are looked for.
// Source: USB Device Class Definition for Physical Interface Devices (PID) 1.0, 4 (reports) and 5 (usages of page 0x0F).
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/hid/report_descriptor.h"

#include <cstdint>
#include <optional>

namespace fulcrum::hid {

/// One order to the device, and the value that gives it: an entry of an array, or a bit of its own.
struct ForceOrder {
    ReportField field{};
    std::int64_t value = 0;
};

struct ForceLayout {
    // Create New Effect: of which kind.
    ForceOrder create_constant{};
    // PID Block Load: what came of it.
    ReportField loaded_index{};
    ForceOrder load_success{};
    // Set Effect.
    ReportField effect_index{};
    ForceOrder effect_constant{};
    ReportField duration{};
    std::optional<ReportField> effect_gain;
    std::optional<ReportField> direction_enable;
    std::optional<ReportField> direction;  ///< bearing, clockwise from straight ahead
    std::optional<ReportField> enable_x;
    std::optional<ReportField> enable_y;
    // Set Constant Force.
    ReportField force_index{};
    ReportField magnitude{};  ///< its range has both signs
    // Effect Operation.
    ReportField operation_index{};
    ForceOrder start{};
    ForceOrder stop{};
    std::optional<ReportField> loop_count;
    // PID Device Control, Device Gain, PID Block Free: not every device has them.
    std::optional<ForceOrder> enable_actuators;
    std::optional<ForceOrder> stop_all;
    std::optional<ForceOrder> reset;
    std::optional<ReportField> device_gain;
    std::optional<ReportField> freed_index;

    bool has_x = false;  ///< the device pushes to the right and left
    bool has_y = false;  ///< away and towards the user

    /// Refuses a device that cannot render a constant force that ends by itself, and says what it lacks.
    [[nodiscard]] static Expected<ForceLayout> find(const ReportDescriptor& descriptor);
};

/// True when the device speaks of forces at all, whether or not it can be used.
[[nodiscard]] bool mentions_force(const ReportDescriptor& descriptor) noexcept;

}  // namespace fulcrum::hid
