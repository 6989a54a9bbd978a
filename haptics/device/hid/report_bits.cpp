#include "haptics/device/hid/report_bits.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::hid {
namespace {

bool fits(const ReportField& field, std::size_t n_bytes) noexcept {
    return std::size_t{field.bit_offset} + field.bit_size <= 8 * n_bytes;
}

}  // namespace

std::optional<std::int64_t> read_number(const ReportField& field,
                                        std::span<const std::uint8_t> data) noexcept {
    if (field.bit_size == 0 || !fits(field, data.size())) {
        return std::nullopt;
    }
    std::uint64_t bits = 0;
    for (std::uint32_t i = 0; i < field.bit_size; ++i) {
        const std::uint32_t at = field.bit_offset + i;
        bits |= std::uint64_t{static_cast<std::uint8_t>(data[at / 8] >> (at % 8)) & 1U} << i;
    }
    auto value = static_cast<std::int64_t>(bits);
    if (field.is_signed() && (bits >> (field.bit_size - 1U) & 1U) != 0) {
        value -= std::int64_t{1} << field.bit_size;
    }
    return value;
}

std::optional<std::int64_t> read_value(const ReportField& field,
                                       std::span<const std::uint8_t> data) noexcept {
    const auto value = read_number(field, data);
    const bool is_there = value && *value >= field.logical_min && *value <= field.logical_max;
    return is_there ? value : std::nullopt;
}

void write_value(const ReportField& field, std::int64_t value,
                 std::span<std::uint8_t> data) noexcept {
    if (!fits(field, data.size())) {
        return;
    }
    // Where the field is narrower than its range, what it can hold.
    const int n_magnitude = field.bit_size - (field.is_signed() ? 1 : 0);
    const std::int64_t most = (std::int64_t{1} << n_magnitude) - 1;
    const std::int64_t high = std::min(field.logical_max, most);
    const std::int64_t low = std::max(field.logical_min, field.is_signed() ? -most - 1 : 0);
    const auto bits = static_cast<std::uint64_t>(std::max(std::min(value, high), low));
    for (std::uint32_t i = 0; i < field.bit_size; ++i) {
        const std::uint32_t at = field.bit_offset + i;
        const auto mask = static_cast<std::uint8_t>(1U << (at % 8));
        data[at / 8] = static_cast<std::uint8_t>((bits >> i & 1U) != 0 ? data[at / 8] | mask
                                                                       : data[at / 8] & ~mask);
    }
}

double to_unit(const ReportField& field, std::int64_t value) noexcept {
    const auto range = static_cast<double>(field.logical_max - field.logical_min);
    return range > 0.0 ? 2.0 * static_cast<double>(value - field.logical_min) / range - 1.0 : 0.0;
}

std::int64_t from_share(const ReportField& field, double share) noexcept {
    const auto range = static_cast<double>(field.logical_max - field.logical_min);
    const double held = share > 0.0 ? std::min(share, 1.0) : 0.0;
    return field.logical_min + std::llround(held * range);
}

std::int64_t from_physical(const ReportField& field, double value) noexcept {
    // Without physical extents they are the logical ones (HID 1.11, 6.2.2.7).
    const bool has_extents = field.physical_max > field.physical_min;
    const auto low = static_cast<double>(has_extents ? field.physical_min : field.logical_min);
    const auto high = static_cast<double>(has_extents ? field.physical_max : field.logical_max);
    const double counted = value / std::pow(10.0, field.unit_exponent);
    return high > low ? from_share(field, (counted - low) / (high - low)) : field.logical_min;
}

}  // namespace fulcrum::hid
