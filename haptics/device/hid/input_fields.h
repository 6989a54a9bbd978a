// The input fields of a device that stand for one thing: an axis, a row of buttons.
//
// Thread: load path; `take_buttons` the device's own. Cost: linear in the descriptor's fields.
// Source: HID Usage Tables 1.12, 4 (Generic Desktop), 12 (Button).
#pragma once

#include "haptics/device/hid/report_descriptor.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace fulcrum::hid {

inline constexpr std::uint32_t kMostButtons = 32;

/// A report's number, 0 where the device numbers none, and what stands behind it.
struct InputReport {
    std::uint8_t id = 0;
    std::span<const std::uint8_t> data;
};
/// `report` is not empty.
[[nodiscard]] inline InputReport split_report(std::span<const std::uint8_t> report,
                                              bool numbers_reports) noexcept {
    return numbers_reports ? InputReport{report[0], report.subspan(1)} : InputReport{0, report};
}

/// The number of this usage, of this application; 0: of any. Nothing where there is none, or where its range is one value.
[[nodiscard]] std::optional<ReportField> find_input(const ReportDescriptor& descriptor, Usage usage,
                                                    Usage application);

/// Button 1 first, up to the first that is missing, kMostButtons at most.
[[nodiscard]] std::vector<ReportField> find_buttons(const ReportDescriptor& descriptor,
                                                    Usage application);

/// Takes over those that stand in this report, a bit a button. `data` begins behind the report's number. True when one did.
bool take_buttons(const std::vector<ReportField>& fields, std::uint8_t report_id,
                  std::span<const std::uint8_t> data, std::uint32_t& buttons) noexcept;

}  // namespace fulcrum::hid
