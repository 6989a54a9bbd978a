#include "haptics/device/hid/stick.h"

#include "haptics/device/hid/input_fields.h"
#include "haptics/device/hid/report_bits.h"

#include <algorithm>

namespace fulcrum::hid {
namespace {

constexpr std::uint16_t kDesktop = 0x01;
constexpr std::uint16_t kSimulation = 0x02;
constexpr Usage kAxisX = usage_of(kDesktop, 0x30);
constexpr Usage kAxisY = usage_of(kDesktop, 0x31);
constexpr Usage kGamepad = usage_of(kDesktop, 0x05);

// What goes near and far, the most fitting first. A gamepad's Z is a trigger, its second stick springs back.
constexpr std::array kStickDepths{usage_of(kSimulation, 0xBB), usage_of(kDesktop, 0x36),
                                  usage_of(kDesktop, 0x32)};
constexpr std::array kPadDepths{usage_of(kDesktop, 0x35)};

// An axis tells where it is, not how far it went.
std::optional<ReportField> find_axis(const ReportDescriptor& descriptor, Usage usage,
                                     Usage application) {
    const auto field = find_input(descriptor, usage, application);
    return field && !field->is_relative ? field : std::nullopt;
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
    stick.buttons_ = find_buttons(descriptor, application);
    return stick;
}

bool Stick::take_report(std::span<const std::uint8_t> report, StickState& state) const noexcept {
    if (report.empty()) {
        return false;
    }
    const auto [number, data] = split_report(report, numbers_reports_);
    bool was_of_use = false;
    const auto value_of = [&, id = number, bytes = data](const ReportField& field) {
        const auto value =
            field.report_id == id ? read_value(field, bytes) : std::optional<std::int64_t>();
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
    was_of_use |= take_buttons(buttons_, number, data, state.buttons);
    return was_of_use;
}

double Stick::steps() const noexcept {
    return static_cast<double>(
        std::min(x_.logical_max - x_.logical_min, y_.logical_max - y_.logical_min));
}

}  // namespace fulcrum::hid
