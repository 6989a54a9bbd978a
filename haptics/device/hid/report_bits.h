// A number in the bytes of a report: bit 0 of a field is the lowest, fields follow each other without gaps.
//
//   value = sum over i of bit(offset + i) 2^i, in two's complement where the logical minimum lies below zero
//   logical -> unit:  -1 at logical_min, +1 at logical_max, linear between
//   physical: p = (l - l_min) (p_max - p_min) / (l_max - l_min) + p_min, times 10^exponent in the field's unit
// Thread: any. Cost: some nanoseconds.
// Source: HID 1.11, 5.6 (reports), 6.2.2.7 (resolution, physical extents), 8.4 (two's complement, little-endian).
#pragma once

#include "haptics/device/hid/report_descriptor.h"

#include <cstdint>
#include <optional>
#include <span>

namespace fulcrum::hid {

/// What stands in the field, also outside its logical range; nothing where the report is too short.
[[nodiscard]] std::optional<std::int64_t> read_number(const ReportField& field,
                                                      std::span<const std::uint8_t> data) noexcept;

/// The field's value in `data`, which begins behind the report's number. Nothing where the report is too short, or where the
/// value lies outside the logical range: that is how a device says that it has none (HID 1.11, 5.10).
[[nodiscard]] std::optional<std::int64_t> read_value(const ReportField& field,
                                                     std::span<const std::uint8_t> data) noexcept;

/// Sets the field in `data`, held within the logical range; a field that does not fit into `data` is left out.
void write_value(const ReportField& field, std::int64_t value,
                 std::span<std::uint8_t> data) noexcept;

/// -1 to 1 over the logical range; 0 where the range is one value.
[[nodiscard]] double to_unit(const ReportField& field, std::int64_t value) noexcept;

/// The logical value for a share of the range: 0 is logical_min, 1 is logical_max. Held within it; NaN is 0.
[[nodiscard]] std::int64_t from_share(const ReportField& field, double share) noexcept;

/// The logical value for a physical one, which is in the field's unit after its exponent; nearest, held within the range.
[[nodiscard]] std::int64_t from_physical(const ReportField& field, double value) noexcept;

}  // namespace fulcrum::hid
