#include "haptics/device/hid/space_mouse.h"

#include "haptics/device/hid/input_fields.h"
#include "haptics/device/hid/report_bits.h"

#include <algorithm>

namespace fulcrum::hid {
namespace {

constexpr Usage kFirstPush = usage_of(0x01, 0x30);  // X; Y, Z follow
constexpr Usage kFirstTurn = usage_of(0x01, 0x33);  // Rx; Ry, Rz follow

double to_share(const ReportField& field, std::int64_t number) noexcept {
    const double share = field.is_signed() && field.logical_max > 0
                             ? static_cast<double>(number) / static_cast<double>(field.logical_max)
                             : to_unit(field, number);
    return std::clamp(share, -1.0, 1.0);
}

}  // namespace

Expected<Cap> Cap::find(const ReportDescriptor& descriptor) {
    Cap cap;
    cap.numbers_reports_ = descriptor.numbers_reports();
    for (Usage i = 0; i < 3; ++i) {
        cap.push_[i] = find_input(descriptor, kFirstPush + i, kMultiAxis);
        cap.turn_[i] = find_input(descriptor, kFirstTurn + i, kMultiAxis);
    }
    if (std::ranges::any_of(cap.push_, [](const auto& field) { return !field; })) {
        return fail("it calls itself a Multi-axis Controller, and does not tell X, Y and Z", {},
                    "use a SpaceMouse or a joystick");
    }
    cap.buttons_ = find_buttons(descriptor, kMultiAxis);
    return cap;
}

bool Cap::take_three(const Three& fields, std::uint8_t report_id,
                     std::span<const std::uint8_t> data, Vector3& value_D) noexcept {
    std::array<double, 3> shares{};
    bool is_told = false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (fields[i] && fields[i]->report_id == report_id) {
            const auto number = read_number(*fields[i], data);
            if (!number) {
                return false;
            }
            shares[i] = to_share(*fields[i], *number);
            is_told = true;
        }
    }
    if (is_told) {
        value_D = {shares[0], -shares[2], shares[1]};
    }
    return is_told;
}

bool Cap::take_report(std::span<const std::uint8_t> report, CapState& cap) const noexcept {
    if (report.empty()) {
        return false;
    }
    const auto [number, data] = split_report(report, numbers_reports_);
    bool was_of_use = take_three(push_, number, data, cap.push_D);
    was_of_use |= take_three(turn_, number, data, cap.turn_D);
    return take_buttons(buttons_, number, data, cap.buttons) || was_of_use;
}

int Cap::n_axes() const noexcept {
    const auto is_there = [](const auto& field) { return field.has_value(); };
    return static_cast<int>(std::ranges::count_if(push_, is_there) +
                            std::ranges::count_if(turn_, is_there));
}

}  // namespace fulcrum::hid
