// A joystick's place: two axes and, where it has one, a throttle, and its buttons, found in its report descriptor.
//
//   x = axis X (to the right)    y = -axis Y (away from the user is up, as with a mouse)    z = the throttle (towards the user)
// each -1 to 1 over its logical range.
//
// Thread: the device's own. Cost: some nanoseconds an axis.
// Source: HID Usage Tables 1.12, 4 (Generic Desktop: X, Y, Z, Slider, Joystick, Gamepad), 5 (Simulation: Throttle), 12 (Button).
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/hid/report_descriptor.h"
#include "haptics/math/spatial.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace fulcrum::hid {

struct StickState {
    Vector3 place{Vector3::Zero()};  ///< each -1 to 1
    std::uint32_t buttons = 0;
};

class Stick {
  public:
    /// Finds axes and buttons. Refuses a device without both of X and Y.
    [[nodiscard]] static Expected<Stick> find(const ReportDescriptor& descriptor);

    /// Takes a report over, its number first where reports are numbered. Numbers that are missing or out of their range leave
    /// their axis as it was. False when nothing in the report was of use.
    bool take_report(std::span<const std::uint8_t> report, StickState& state) const noexcept;

    /// 2 or 3.
    [[nodiscard]] int n_axes() const noexcept { return depth_ ? 3 : 2; }
    [[nodiscard]] int n_buttons() const noexcept { return static_cast<int>(buttons_.size()); }
    /// The coarser of X and Y: how many steps it tells apart.
    [[nodiscard]] double steps() const noexcept;

  private:
    bool numbers_reports_ = false;
    ReportField x_{};
    ReportField y_{};
    std::optional<ReportField> depth_;
    std::vector<ReportField> buttons_;  // button 1 first, 32 at most
};

}  // namespace fulcrum::hid
