#include "haptics/device/hid/stick.h"

#include "haptics/device/hid/report_bits.h"

#include <algorithm>

namespace fulcrum::hid {
namespace {

constexpr std::uint16_t kDesktop = 0x01;
constexpr std::uint16_t kSimulation = 0x02;
constexpr std::uint16_t kButton = 0x09;
constexpr Usage kAxisX = usage_of(kDesktop, 0x30);
constexpr Usage kAxisY = usage_of(kDesktop, 0x31);
constexpr Usage kGamepad = usage_of(kDesktop, 0x05);
constexpr std::uint32_t kMostButtons = 32;

// What goes near and far, the most fitting first. A gamepad's Z is a trigger, its second stick springs back.
constexpr std::array kStickDepths{usage_of(kSimulation, 0xBB), usage_of(kDesktop, 0x36),
                                  usage_of(kDesktop, 0x32)};
constexpr std::array kPadDepths{usage_of(kDesktop, 0x35)};

std::optional<ReportField> find_axis(const ReportDescriptor& descriptor, Usage usage,
                                     Usage application) {
    for (const ReportField& field : descriptor.fields()) {
        if (field.type == ReportType::input && !field.is_array && !field.is_relative &&
            field.usage == usage && field.logical_max > field.logical_min &&
            (application == 0 || descriptor.application_of(field) == application)) {
            return field;
        }
    }
    return std::nullopt;
}

}  // namespace

Expected<Stick> Stick::find(const ReportDescriptor& descriptor) {
    const auto x = find_axis(descriptor, kAxisX, 0);
    const Usage application = x ? descriptor.application_of(*x) : 0;
    const auto y = find_axis(descriptor, kAxisY, application);
    if (!x || !y) {
        return fail("the device has no two axes", {}, "use a joystick, a gamepad or a SpaceMouse");
    }
    Stick stick;
    stick.numbers_reports_ = descriptor.numbers_reports();
    stick.x_ = *x;
    stick.y_ = *y;
    const std::span<const Usage> depths =
        application == kGamepad ? std::span<const Usage>(kPadDepths) : kStickDepths;
    for (const Usage usage : depths) {
        if (!stick.depth_) {
            stick.depth_ = find_axis(descriptor, usage, application);
        }
    }
    for (std::uint32_t i = 0; i < kMostButtons; ++i) {
        const auto button = static_cast<std::uint16_t>(i + 1);
        const auto field = find_axis(descriptor, usage_of(kButton, button), application);
        if (!field) {
            break;
        }
        stick.buttons_.push_back(*field);
    }
    return stick;
}

bool Stick::take_report(std::span<const std::uint8_t> report, StickState& state) const noexcept {
    if (report.empty()) {
        return false;
    }
    const std::uint8_t number = numbers_reports_ ? report[0] : 0;
    const std::span<const std::uint8_t> data = report.subspan(numbers_reports_ ? 1 : 0);
    bool was_of_use = false;
    const auto value_of = [&](const ReportField& field) {
        const auto value =
            field.report_id == number ? read_value(field, data) : std::optional<std::int64_t>();
        was_of_use |= value.has_value();
        return value;
    };
    if (const auto x = value_of(x_)) {
        state.place.x() = to_unit(x_, *x);
    }
    if (const auto y = value_of(y_)) {
        state.place.y() = -to_unit(y_, *y);
    }
    if (const auto z = depth_ ? value_of(*depth_) : std::nullopt) {
        state.place.z() = to_unit(*depth_, *z);
    }
    for (std::size_t i = 0; i < buttons_.size(); ++i) {
        if (const auto down = value_of(buttons_[i])) {
            const std::uint32_t bit = 1U << i;
            state.buttons = *down != 0 ? state.buttons | bit : state.buttons & ~bit;
        }
    }
    return was_of_use;
}

double Stick::steps() const noexcept {
    return static_cast<double>(
        std::min(x_.logical_max - x_.logical_min, y_.logical_max - y_.logical_min));
}

}  // namespace fulcrum::hid
