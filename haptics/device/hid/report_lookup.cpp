// What is asked of a descriptor that was read; the half of report_descriptor.h that does not parse.
#include "haptics/device/hid/report_descriptor.h"

namespace fulcrum::hid {

std::size_t ReportDescriptor::report_bytes(ReportType type, std::uint8_t report_id) const noexcept {
    const std::uint32_t bits = bits_[static_cast<std::size_t>(type)][report_id];
    return bits == 0 ? 0 : (bits + 7U) / 8U + (numbers_reports_ ? 1U : 0U);
}

bool ReportDescriptor::is_within(const ReportField& field, Usage usage) const noexcept {
    for (std::int16_t i = field.collection; i != kNoCollection;) {
        const Collection& around = collections_[static_cast<std::size_t>(i)];
        if (around.usage == usage) {
            return true;
        }
        i = around.parent;
    }
    return false;
}

Usage ReportDescriptor::application_of(const ReportField& field) const noexcept {
    constexpr std::uint8_t kApplication = 1;
    for (std::int16_t i = field.collection; i != kNoCollection;) {
        const Collection& around = collections_[static_cast<std::size_t>(i)];
        if (around.kind == kApplication) {
            return around.usage;
        }
        i = around.parent;
    }
    return 0;
}

std::int64_t ReportDescriptor::value_of(const ReportField& array, Usage usage) const noexcept {
    std::int64_t value = array.logical_min;
    for (std::size_t i = array.first_range; i < std::size_t{array.first_range} + array.n_ranges;
         ++i) {
        const UsageRange& range = ranges_[i];
        if (usage >= range.first && usage <= range.last) {
            value += usage - range.first;
            return value <= array.logical_max ? value : -1;
        }
        value += std::int64_t{range.last} - range.first + 1;
    }
    return -1;
}

}  // namespace fulcrum::hid
