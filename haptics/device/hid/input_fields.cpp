#include "haptics/device/hid/input_fields.h"

#include "haptics/device/hid/report_bits.h"

namespace fulcrum::hid {

std::optional<ReportField> find_input(const ReportDescriptor& descriptor, Usage usage,
                                      Usage application) {
    for (const ReportField& field : descriptor.fields()) {
        if (field.type == ReportType::input && !field.is_array && field.usage == usage &&
            field.logical_max > field.logical_min &&
            (application == 0 || descriptor.application_of(field) == application)) {
            return field;
        }
    }
    return std::nullopt;
}

std::vector<ReportField> find_buttons(const ReportDescriptor& descriptor, Usage application) {
    constexpr std::uint16_t kButtonPage = 0x09;
    std::vector<ReportField> buttons;
    for (std::uint32_t i = 1; i <= kMostButtons; ++i) {
        const auto field = find_input(
            descriptor, usage_of(kButtonPage, static_cast<std::uint16_t>(i)), application);
        if (!field) {
            break;
        }
        buttons.push_back(*field);
    }
    return buttons;
}

bool take_buttons(const std::vector<ReportField>& fields, std::uint8_t report_id,
                  std::span<const std::uint8_t> data, std::uint32_t& buttons) noexcept {
    bool was_of_use = false;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto down = fields[i].report_id == report_id ? read_value(fields[i], data)
                                                           : std::optional<std::int64_t>();
        if (down) {
            const std::uint32_t bit = 1U << i;
            buttons = *down != 0 ? buttons | bit : buttons & ~bit;
            was_of_use = true;
        }
    }
    return was_of_use;
}

}  // namespace fulcrum::hid
