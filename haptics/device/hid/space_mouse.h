// SpaceMice and their like: a cap that is pushed and turned in six directions and gives back how far it was, and buttons.
//
// Any device is one that says it is a Multi-axis Controller and gives X, Y and Z, whatever its maker and number: where each number lies, how
// wide it is and how far it goes, its report descriptor tells. Rx, Ry, Rz may be in another report, or missing.
//   number -> unit   range about 0: n / logical_max; else -1 at logical_min, 1 at logical_max; what goes beyond counts as 1
// Their frame: x to the right, y towards the user, z down; turns by the right-hand rule. In ours:
//   D = (x, -z, y)     for pushes and for turns
//
// Thread: the device's own. Cost: tens of nanoseconds a report.
// Source: HID Usage Tables 1.12, 4 (Multi-axis Controller; X, Y, Z, Rx, Ry, Rz), 12 (Button); the family's report descriptors.
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/hid/report_descriptor.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace fulcrum::hid {

/// How far the cap is pushed and turned, 1 is as far as it goes, in the device's frame D; and which buttons are down.
struct CapState {
    Vector3 push_D{Vector3::Zero()};
    Vector3 turn_D{Vector3::Zero()};
    std::uint32_t buttons = 0;
};

inline constexpr Usage kMultiAxis = usage_of(0x01, 0x08);

class Cap {
  public:
    /// Finds axes and buttons of the Multi-axis Controller. Refuses one without X, Y and Z.
    [[nodiscard]] static Expected<Cap> find(const ReportDescriptor& descriptor);

    /// Takes a report over, its number first where reports are numbered. Three numbers of a push, or of a turn, are taken together or not at
    /// all. False, and `cap` as it was, when nothing in it was of use.
    bool take_report(std::span<const std::uint8_t> report, CapState& cap) const noexcept;

    /// 3 to 6.
    [[nodiscard]] int n_axes() const noexcept;
    [[nodiscard]] int n_buttons() const noexcept { return static_cast<int>(buttons_.size()); }

  private:
    using Three = std::array<std::optional<ReportField>, 3>;
    [[nodiscard]] static bool take_three(const Three& fields, std::uint8_t report_id,
                                         std::span<const std::uint8_t> data,
                                         Vector3& value_D) noexcept;

    bool numbers_reports_ = false;
    Three push_{};  // their x, y, z
    Three turn_{};  // likewise; what is missing is not turned
    std::vector<ReportField> buttons_;
};

}  // namespace fulcrum::hid
