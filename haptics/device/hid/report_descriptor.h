// What a HID device says of its own reports: each number in them, where it lies, what it means and its range.
//
//   items    prefix byte: size 0, 1, 2 or 4 bytes | type main, global, local | tag; 0xFE begins a long item, which is skipped
//   global   hold until they are set again; Push and Pop keep and restore all of them
//   local    hold until the next main item; usages of one or two bytes take the usage page that holds at the main item
//   main     Input, Output, Feature place `report count` numbers of `report size` bits behind those of the same report;
//            Collection and End Collection say what belongs together
// What a stranger's descriptor can cost is bounded: by its size, by kMost… below, and nothing is expanded before it was counted.
//
// Thread: load path. Cost: linear in the descriptor's bytes and in the numbers that it describes.
// Source: USB Device Class Definition for Human Interface Devices 1.11, 6.2.2 (items), 8.3 to 8.5 (reports, usages, order).
#pragma once

#include "haptics/base/error.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum::hid {

inline constexpr std::size_t kMostDescriptorBytes = 4096;  ///< Linux's HID_MAX_DESCRIPTOR_SIZE
inline constexpr std::size_t kMostFields = 4096;
inline constexpr std::size_t kMostReportBits = 32768;
inline constexpr std::size_t kMostDepth = 32;  ///< of collections, and of Push
inline constexpr std::size_t kMostUsageRanges = 1024;

enum class ReportType : std::uint8_t { input, output, feature };

/// Usage page in the upper half, usage in the lower.
using Usage = std::uint32_t;
[[nodiscard]] constexpr Usage usage_of(std::uint16_t page, std::uint16_t id) noexcept {
    return Usage{page} << 16U | id;
}

/// Usages from first to last, one page.
struct UsageRange {
    Usage first = 0;
    Usage last = 0;
};

inline constexpr std::int16_t kNoCollection = -1;

struct Collection {
    Usage usage = 0;
    std::uint8_t kind = 0;                ///< 0 physical, 1 application, 2 logical, …
    std::int16_t parent = kNoCollection;  ///< index of the one around it
};

/// One number of a report. Constants (padding) and what is wider than 32 bits are not kept, but their room is counted.
struct ReportField {
    ReportType type = ReportType::input;
    std::uint8_t report_id = 0;    ///< 0: the device numbers no reports
    std::uint32_t bit_offset = 0;  ///< from the first byte of data, behind the report's number
    std::uint8_t bit_size = 0;     ///< 1 to 32
    bool is_array = false;         ///< its value chooses one of its usages
    bool is_relative = false;
    std::int64_t logical_min = 0;
    std::int64_t logical_max = 0;  ///< not below logical_min
    std::int64_t physical_min = 0;
    std::int64_t physical_max = 0;  ///< equal to physical_min: as the logical ones
    std::int8_t unit_exponent = 0;  ///< -8 to 7
    std::uint32_t unit = 0;         ///< as in the descriptor; 0: none
    Usage usage = 0;                ///< of an array the first
    std::uint16_t first_range = 0;  ///< of an array: its usages, in ReportDescriptor::ranges
    std::uint16_t n_ranges = 0;
    std::int16_t collection = kNoCollection;  ///< the innermost around it

    [[nodiscard]] bool is_signed() const noexcept { return logical_min < 0; }
};

class ReportDescriptor {
  public:
    /// Refuses what cannot be right, with the byte at which it stands.
    [[nodiscard]] static Expected<ReportDescriptor> parse(std::span<const std::uint8_t> bytes);

    [[nodiscard]] const std::vector<ReportField>& fields() const noexcept { return fields_; }
    [[nodiscard]] const std::vector<Collection>& collections() const noexcept {
        return collections_;
    }
    /// True when reports begin with their number.
    [[nodiscard]] bool numbers_reports() const noexcept { return numbers_reports_; }
    /// Bytes of a report with its number where there is one; 0 when there is no such report.
    [[nodiscard]] std::size_t report_bytes(ReportType type, std::uint8_t report_id) const noexcept;

    /// True when the field lies in a collection of this usage, at any depth.
    [[nodiscard]] bool is_within(const ReportField& field, Usage usage) const noexcept;
    /// Usage of the application that the field belongs to; 0 when it stands in none.
    [[nodiscard]] Usage application_of(const ReportField& field) const noexcept;
    /// The value of an array field that chooses this usage; -1 when none does.
    [[nodiscard]] std::int64_t value_of(const ReportField& array, Usage usage) const noexcept;

  private:
    friend class DescriptorParser;

    std::vector<ReportField> fields_;
    std::vector<Collection> collections_;
    std::vector<UsageRange> ranges_;  // of arrays
    // Bits of each report, by type and number.
    std::array<std::array<std::uint32_t, 256>, 3> bits_{};
    bool numbers_reports_ = false;
};

}  // namespace fulcrum::hid
