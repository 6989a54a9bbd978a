// Report descriptors as devices of each kind give them, item by item, for tests and as seeds of the fuzzer.
#pragma once

#include <cstdint>
#include <vector>

namespace fulcrum::test_support {

using Bytes = std::vector<std::uint8_t>;

/// Puts items one behind the other.
class DescriptorBuilder {
  public:
    /// `prefix` is tag and type with size 0, as in HID 1.11; the value takes the fewest bytes that hold it.
    DescriptorBuilder& item(std::uint8_t prefix, std::int64_t value);
    DescriptorBuilder& bare(std::uint8_t prefix);  ///< without data: End Collection, Push, Pop

    DescriptorBuilder& page(std::int64_t p) { return item(0x04, p); }
    DescriptorBuilder& usage(std::int64_t u) { return item(0x08, u); }
    DescriptorBuilder& usages(std::int64_t first, std::int64_t last) {
        return item(0x18, first).item(0x28, last);
    }
    DescriptorBuilder& logical(std::int64_t low, std::int64_t high);
    DescriptorBuilder& physical(std::int64_t low, std::int64_t high) {
        return item(0x34, low).item(0x44, high);
    }
    DescriptorBuilder& number(std::int64_t id) { return item(0x84, id); }
    DescriptorBuilder& fields(std::int64_t size, std::int64_t count) {
        return item(0x74, size).item(0x94, count);
    }
    DescriptorBuilder& input(std::int64_t flags) { return item(0x80, flags); }
    DescriptorBuilder& output(std::int64_t flags) { return item(0x90, flags); }
    DescriptorBuilder& feature(std::int64_t flags) { return item(0xB0, flags); }
    DescriptorBuilder& open(std::int64_t kind) { return item(0xA0, kind); }
    DescriptorBuilder& close() { return bare(0xC0); }

    [[nodiscard]] const Bytes& bytes() const { return bytes_; }

  private:
    Bytes bytes_;
};

/// Of a SpaceMouse that tells pushes (report 1) and turns (report 2) apart, or that gives both in report 1; buttons in report 3.
[[nodiscard]] Bytes space_mouse_descriptor(bool one_report);

/// How force-feedback joysticks differ.
struct ForceStickShape {
    std::uint8_t first_report = 1;  ///< number of the input report; the others follow it
    int magnitude = 255;            ///< range of the magnitude, either sign
    bool has_y = true;              ///< pushes away and towards as well
    bool by_axes = false;           ///< effects name axes; else a direction
    bool has_units =
        true;  ///< directions in hundredths of a degree, durations in milliseconds, told so
    bool features_made = true;  ///< Create New Effect is a feature report, as PID has it
};

/// Reports, in this order from `first_report`: input; set effect; constant force; operation; device control; device gain;
/// block free; create new effect; block load. force_stick.h has their bytes.
[[nodiscard]] Bytes force_stick_descriptor(const ForceStickShape& shape);

/// A joystick without forces: one unnumbered report of X, Y and a slider of 8 bits, and 4 buttons.
[[nodiscard]] Bytes plain_stick_descriptor();

}  // namespace fulcrum::test_support
